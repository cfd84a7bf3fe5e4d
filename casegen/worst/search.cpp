#include "casegen/worst/search.h"

#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/measure/inputs.h"
#include "casegen/standalone.h"
#include "casegen/worst/change.h"
#include "runtime/clock.h"
#include "runtime/error.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::worst {
namespace {

/// Candidates of a round: as many as a reference answers in about a tenth of a second.
std::size_t round_size(const Case& c) { return c.reference.truth ? 512 : 8192; }

/// Sign and exponent of floats, other words as they are.
std::uint32_t octave(Scalar scalar, std::uint32_t word) {
    return scalar == Scalar::float32 ? word >> 23 : word;
}

bool same_octaves(const Case& c, const Row& a, const Row& b) {
    if ((a.mask != nullptr) != (b.mask != nullptr) || (a.mask && !(*a.mask == *b.mask))) return false;
    for (std::size_t i = 0; i < a.words.size(); ++i)
        if (octave(c.reference.words[i], a.words[i]) != octave(c.reference.words[i], b.words[i]))
            return false;
    return true;
}

bool worse(const Row& a, const Row& b) { return a.error != b.error ? a.error > b.error : a.words < b.words; }

class Search {
public:
    Search(const Case& c, const SearchOptions& options, gpu::Device& device, const Sampler& sampler)
        : case_(c), options_(options), device_(device), sampler_(sampler), worst_(c),
          anywhere_(c.defended && c.fails.empty()),
          kernel_(device.kernel(compile_standalone(c, kernel_sources(options.kernels)), c.name)) {}

    /// Runs and judges, in any order of threads; takes in the worst ones in the order of the candidates.
    std::vector<Row> judge_all(std::vector<Row> candidates) {
        std::erase_if(candidates, [&](const Row& row) { return !anywhere_ && !in_domain(case_, with(row)); });
        if (candidates.empty()) return candidates;
        Records records(case_);
        for (const Row& row : candidates) records.add(row.words, row.mask);
        const Outputs outputs = run_standalone(device_, kernel_, case_, records);
        if (const std::string complaint = outputs.complaint(); !complaint.empty())
            throw Error("{}: {}; gnomon check {} tells more", case_.name, complaint, case_.name);
        // Nobody asks for these inputs again: they are not worth files.
        const std::vector<Truth> truths = measure::truths_on(case_, records, options_.jobs, {});
        const auto components = static_cast<std::size_t>(case_.reference.result.components);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            const Agreement agreement = judge(case_, with(candidates[i]),
                                              std::span(outputs.words).subspan(i * components, components),
                                              truths.empty() ? nullptr : &truths[i]);
            candidates[i].error = agreement.error;
            candidates[i].passes = agreement.pass;
            worst_.add(candidates[i]);
        }
        return candidates;
    }

    Row sample(std::size_t index) const {
        Sampler::Sample drawn = sampler_.draw(index);
        return {std::move(drawn.words), drawn.mask};
    }

    /// Evaluation `n`: a fresh sample, or a change of one of the worst.
    Row candidate(std::size_t n) const {
        Random random(seed() ^ 0x5eedull, n);
        const std::vector<Row>& rows = worst_.rows();
        if (rows.empty() || random.chance(0.2)) return sample(sampler_.fixed_count() + n);
        const auto pick = [&]() -> const Row& { // the worse the likelier
            const double u = random.unit();
            return rows[static_cast<std::size_t>(u * u * static_cast<double>(rows.size()))];
        };
        Row row = pick();
        change(case_, random, row.words, pick().words);
        return row;
    }

    std::uint64_t seed() const { return sampler_.seed(); }
    const std::vector<Row>& rows() const { return worst_.rows(); }

private:
    Arguments with(const Row& row) const { return arguments(case_, row.words, row.mask); }

    const Case& case_;
    const SearchOptions& options_;
    gpu::Device& device_;
    const Sampler& sampler_;
    Worst worst_;
    bool anywhere_; ///< or only in the domain
    gpu::Kernel kernel_;
};

} // namespace

void Worst::add(Row row) {
    if (!(row.error > 0)) return;
    if (rows_.size() == most_rows && !worse(row, rows_.back())) return;
    const auto alike =
        std::ranges::find_if(rows_, [&](const Row& other) { return same_octaves(case_, row, other); });
    if (alike != rows_.end()) {
        if (!worse(row, *alike)) return;
        rows_.erase(alike);
    }
    rows_.insert(std::ranges::upper_bound(rows_, row, worse), std::move(row));
    if (rows_.size() > most_rows) rows_.pop_back();
}

Found search(const Case& c, const SearchOptions& options,
             const std::function<void(double, std::size_t, double)>& progress) {
    require_kernels(options.kernels);
    const double start = seconds_now();
    const auto seconds = [&] { return seconds_now() - start; };
    Found found;
    found.seed = options.seed.value_or(default_seed(c));
    const auto pool = std::make_shared<const EdgePool>(make_edge_pool(default_seed("masks")));
    found.sampler = std::make_shared<const Sampler>(c, found.seed, pool, options.pins, options.worst);
    const Sampler& sampler = *found.sampler;
    gpu::Device device(options.device);
    Search search(c, options, device, sampler);
    const auto told = [&] {
        if (progress)
            progress(seconds(), found.evaluations, search.rows().empty() ? 0 : search.rows().front().error);
    };

    const std::size_t old = Sampler(c, found.seed, pool, {}, options.worst).pinned_count();
    std::vector<Row> fixed;
    for (std::size_t i = 0; i < old; ++i) fixed.push_back(search.sample(i));
    found.before = search.judge_all(std::move(fixed));
    std::ranges::sort(found.before, worse);
    for (std::size_t i = old; i < sampler.fixed_count();) {
        fixed.clear();
        for (; i < sampler.fixed_count() && fixed.size() < round_size(c); ++i)
            fixed.push_back(search.sample(i));
        search.judge_all(std::move(fixed));
        told();
    }

    const auto goes_on = [&] {
        if (options.stop && *options.stop) return false;
        return options.evaluations > 0 ? found.evaluations < options.evaluations
                                       : seconds() < options.seconds;
    };
    while (goes_on()) {
        const std::size_t left =
            options.evaluations > 0 ? options.evaluations - found.evaluations : round_size(c);
        std::vector<Row> candidates;
        for (std::size_t i = 0; i < std::min(left, round_size(c)); ++i)
            candidates.push_back(search.candidate(found.evaluations + i));
        found.evaluations += candidates.size();
        search.judge_all(std::move(candidates));
        told();
    }
    found.rows = search.rows();
    return found;
}

} // namespace gnomon::worst
