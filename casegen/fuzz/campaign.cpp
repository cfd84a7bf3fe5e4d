#include "casegen/fuzz/campaign.h"

#include "casegen/check.h"
#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/journal.h"
#include "casegen/fuzz/plan.h"
#include "casegen/fuzz/workers.h"
#include "runtime/clock.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <thread>
#include <utility>

namespace gnomon::fuzz {
namespace {

/// A kernel whose units crash or hang so often is given up: each costs the time limit many times.
constexpr int most_deaths = 2;

/// Findings by kernel and failure, each of the lowest unit that met it, and their files.
class Findings {
public:
    using Key = std::pair<std::size_t, std::string>; ///< kernel's number, failure

    Findings(std::filesystem::path folder, std::map<std::string, std::vector<Regression>> on_file)
        : folder_(std::move(folder)), on_file_(std::move(on_file)) {}

    void add(std::size_t kernel, std::uint64_t unit, const Found& found) {
        const Regression& regression = found.regression;
        const auto [at, is_new] = findings_.try_emplace(Key{kernel, regression.failure});
        Finding& finding = at->second;
        if (!is_new && finding.unit <= unit) return;
        if (!is_new && !finding.known && !finding.file.empty()) std::filesystem::remove(finding.file);
        finding = {regression, {}, found.on_file, unit};
        if (found.on_file) {
            for (const Regression& old : on_file_[regression.kernel])
                if (old.input.words == regression.input.words && old.input.mask == regression.input.mask) {
                    finding.regression = old;
                    finding.file = folder_ / file_name(old);
                }
            return;
        }
        if (regression.input.words.empty() && regression.input.mask.texels.empty()) return;
        finding.file = folder_ / file_name(regression);
        write_file(finding.file, format_regression(regression));
    }

    /// What a unit of this kernel need not shrink: what lower units have met.
    std::set<std::string> known(std::size_t kernel, std::uint64_t unit) const {
        std::set<std::string> failures;
        for (auto at = findings_.lower_bound({kernel, ""});
             at != findings_.end() && at->first.first == kernel; ++at)
            if (at->second.unit < unit) failures.insert(at->first.second);
        return failures;
    }

    std::size_t count_new() const {
        return static_cast<std::size_t>(
            std::ranges::count_if(findings_, [](const auto& entry) { return !entry.second.known; }));
    }
    std::vector<Finding> all() const {
        std::vector<Finding> all;
        for (const auto& entry : findings_) all.push_back(entry.second);
        return all;
    }

private:
    std::filesystem::path folder_;
    std::map<std::string, std::vector<Regression>> on_file_;
    std::map<Key, Finding> findings_;
};

class Campaign {
public:
    Campaign(std::span<const Case* const> cases, const CampaignOptions& options)
        : options_(options), plan_(make_plan(cases, options.samples)), journal_(open(options)),
          regressions_(older_regressions()), findings_(options.regressions, regressions_),
          deaths_(cases.size(), 0) {
        for (const Case* c : cases) report_.kernels.push_back({c, 0, 0, {}, {}});
        for (const Journal::Line& line : journal_.lines()) {
            done_.insert(line.unit);
            take_in(line.unit, parse_reply(line.text));
            ++report_.resumed_units;
        }
    }

    CampaignReport run(const std::function<void(const CampaignProgress&)>& progress) {
        const double start = seconds_now();
        const unsigned jobs =
            options_.jobs > 0 ? options_.jobs : std::max(1u, std::thread::hardware_concurrency());
        gpu::DeviceOptions device = options_.device;
        Workers workers(
            plan_.cases,
            {options_.sources, options_.pins, options_.worst, regressions_, options_.seed, device}, jobs);
        std::vector<std::uint64_t> units(jobs);
        const std::uint64_t before = report_.evaluations;
        for (;;) {
            report_.seconds = seconds_now() - start;
            bool any_busy = false;
            for (std::size_t i = 0; i < jobs; ++i) {
                if (const auto unit = workers.busy(i) ? std::nullopt : next_unit()) {
                    units[i] = *unit;
                    workers.send(i, request_of(*unit));
                }
                any_busy = any_busy || workers.busy(i);
            }
            if (!any_busy) break;
            const std::size_t ready = workers.wait(0.2);
            report_.evaluations_now = report_.evaluations - before;
            if (progress) progress(progress_now());
            if (ready == workers.size()) continue;
            const std::uint64_t unit = units[ready];
            Outcome outcome = workers.receive(ready);
            if (!outcome.death.empty() || !outcome.reply.timeout.empty())
                outcome.reply = post_mortem(workers, ready, unit, outcome);
            journal_.add({unit, format_reply(outcome.reply)});
            take_in(unit, outcome.reply);
        }
        report_.evaluations_now = report_.evaluations - before;
        report_.findings = findings_.all();
        if (!report_.interrupted) journal_.finish();
        return std::move(report_);
    }

private:
    static Journal open(const CampaignOptions& options) {
        return options.journal.empty() ? Journal() : Journal(options.journal, options.key);
    }

    /// Those on file before the campaign began: what it found itself before it was interrupted is not.
    std::map<std::string, std::vector<Regression>> older_regressions() const {
        std::map<std::string, std::vector<Regression>> regressions = load_regressions(options_.regressions);
        for (const Journal::Line& line : journal_.lines()) {
            const Reply reply = parse_reply(line.text);
            if (!reply.result) continue;
            for (const Found& found : reply.result->found)
                if (!found.on_file && regressions.contains(found.regression.kernel))
                    std::erase_if(regressions.at(found.regression.kernel), [&](const Regression& old) {
                        return file_name(old) == file_name(found.regression);
                    });
        }
        return regressions;
    }

    std::optional<std::uint64_t> next_unit() {
        if (options_.until_found && findings_.count_new() > 0) return {};
        if (!plan_.rounds && report_.seconds >= options_.seconds) return {};
        for (;; ++next_) {
            if (plan_.rounds && next_ >= *plan_.units()) return {};
            if (next_ % options_.shards != options_.shard || done_.contains(next_)) continue;
            if (report_.kernels[plan_.kernel_of(next_)].given_up.empty()) {
                report_.interrupted = options_.stop && *options_.stop; // with something left to do
                if (report_.interrupted) return {};
                return next_++;
            }
            if (std::ranges::none_of(report_.kernels,
                                     [](const KernelReport& k) { return k.given_up.empty(); }))
                return {};
        }
    }

    Request request_of(std::uint64_t unit) const {
        const std::size_t kernel = plan_.kernel_of(unit);
        return {
            kernel, plan_.round_of(unit), plan_.sizes[kernel], true, {}, findings_.known(kernel, unit), {},
            false};
    }

    void take_in(std::uint64_t unit, const Reply& reply) {
        const std::size_t kernel = plan_.kernel_of(unit);
        KernelReport& of_kernel = report_.kernels[kernel];
        ++report_.units;
        if (!reply.compile_error.empty()) {
            of_kernel.given_up = reply.compile_error;
            Found found;
            found.regression.kernel = of_kernel.kernel->name;
            found.regression.failure = "compile error";
            found.regression.got = reply.compile_error;
            findings_.add(kernel, unit, found);
        }
        if (!reply.result) return;
        if (reply.result->worst_error > 0) require_input_of(*of_kernel.kernel, reply.result->worst);
        of_kernel.evaluations += reply.result->evaluations;
        report_.evaluations += reply.result->evaluations;
        if (reply.result->worst_error > of_kernel.worst_error ||
            (reply.result->worst_error == of_kernel.worst_error && of_kernel.worst_error > 0 &&
             reply.result->worst.words < of_kernel.worst.words)) {
            of_kernel.worst_error = reply.result->worst_error;
            of_kernel.worst = reply.result->worst;
        }
        for (const Found& found : reply.result->found) {
            findings_.add(kernel, unit, found);
            const std::string& failure = found.regression.failure;
            if ((failure.starts_with(crash) || failure.starts_with(timeout)) &&
                ++deaths_[kernel] >= most_deaths)
                of_kernel.given_up = fmt::format("{} units ended in a crash or a timeout", deaths_[kernel]);
        }
    }

    /// What a unit finds in so many batches, or in all. If that is fatal too, without shrinking, which may be
    /// what is fatal; then in the batches before the one that is.
    UnitResult found_again(Workers& workers, std::size_t worker, Request request,
                           std::optional<std::size_t> batches, bool shrink) {
        request.part.reset();
        for (;;) {
            if (batches == 0u) return {};
            request.batches = batches;
            request.shrink = shrink;
            Outcome again = workers.ask(worker, request);
            if (again.reply.result) return std::move(*again.reply.result);
            if (!std::exchange(shrink, false)) batches = again.batch;
        }
    }

    /// A unit took its worker down: which of the batch's inputs does so alone? What it found before that died
    /// with it and is asked again; what later batches would have told is not.
    Reply post_mortem(Workers& workers, std::size_t worker, std::uint64_t unit, const Outcome& outcome) {
        const std::string failure = outcome.death.empty() ? timeout : crash;
        const std::string how =
            outcome.death.empty() ? outcome.reply.timeout : "the driver died: " + outcome.death;
        const Case& c = *plan_.cases[plan_.kernel_of(unit)];
        Request request = request_of(unit);
        const auto survives = [&](std::size_t begin, std::size_t end) {
            request.part = Part{outcome.batch, begin, end};
            const Outcome again = workers.ask(worker, request);
            return again.death.empty() && again.reply.timeout.empty();
        };
        Reply reply;
        Regression regression{c.name, failure, {}, how, "an end", to_string(c.tolerance), {}};
        if (request.known.contains(failure)) { // once is enough: it takes long
            reply.result = found_again(workers, worker, request, outcome.batch + 1, false);
            reply.result->found.push_back({regression, false});
            return reply;
        }
        const std::size_t all = unit_size(c);
        if (survives(0, all)) { // not the batch: so what shrinking tried
            reply.result = found_again(workers, worker, request, {}, false);
            regression.found = fmt::format("unit {}, batch {}, seed {:#x}: not seen again", unit,
                                           outcome.batch, options_.seed);
            reply.result->found.push_back({regression, false});
            return reply;
        }
        reply.result = found_again(workers, worker, request, outcome.batch, true);
        // Survivals are cheap and deaths are not: ever longer beginnings, then halves of what the last one
        // added.
        std::size_t begin = 0, end = 1;
        while (end < all && survives(begin, end)) {
            begin = end;
            end = std::min(all, 8 * end);
        }
        while (end - begin > 1) {
            const std::size_t middle = begin + (end - begin) / 2;
            if (survives(begin, middle))
                begin = middle;
            else
                end = middle;
        }
        request.part = Part{outcome.batch, begin, begin + 1};
        request.tell_inputs = true;
        Outcome told = workers.ask(worker, request);
        if (!told.reply.inputs.empty()) regression.input = told.reply.inputs.front();
        regression.found = fmt::format("fuzzing, seed {:#x}, round {}, batch {}, record {}", options_.seed,
                                       plan_.round_of(unit), outcome.batch, begin);
        reply.result->found.push_back({regression, false});
        return reply;
    }

    CampaignProgress progress_now() const {
        CampaignProgress now;
        now.seconds = report_.seconds;
        now.evaluations = report_.evaluations_now;
        now.findings = findings_.count_new();
        now.share = plan_.rounds ? static_cast<double>(report_.units * options_.shards) /
                                       static_cast<double>(*plan_.units())
                                 : report_.seconds / std::max(1e-9, options_.seconds);
        double nearest = 0;
        for (const KernelReport& kernel : report_.kernels) {
            const double allowed = kernel.kernel->tolerance.amount;
            const double share = allowed > 0 ? kernel.worst_error / allowed : 0;
            if (share <= nearest) continue;
            nearest = share;
            now.worst_kernel = kernel.kernel;
            now.worst_error = kernel.worst_error;
        }
        return now;
    }

    const CampaignOptions& options_;
    Plan plan_;
    Journal journal_;
    std::map<std::string, std::vector<Regression>> regressions_;
    Findings findings_;
    std::vector<int> deaths_; ///< per kernel
    std::set<std::uint64_t> done_;
    std::uint64_t next_ = 0;
    CampaignReport report_;
};

/// The files of a folder, names and texts.
std::string text_of_folder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> paths;
    if (std::filesystem::is_directory(folder))
        for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
            if (entry.is_regular_file()) paths.push_back(entry.path());
    std::ranges::sort(paths);
    std::string text;
    for (const std::filesystem::path& path : paths)
        text += path.lexically_relative(folder).string() + '\n' + read_file(path);
    return text;
}

} // namespace

CampaignReport run_campaign(std::span<const Case* const> cases, const CampaignOptions& options,
                            const std::function<void(const CampaignProgress&)>& progress) {
    make_regressions_folder(options.regressions);
    return Campaign(cases, options).run(progress);
}

std::string campaign_key(std::span<const Case* const> cases, const CampaignOptions& options) {
    std::string all = fmt::format("{:#x} {} {} {} {}\n", options.seed, options.samples.value_or(0),
                                  options.shard, options.shards, options.device.name);
    all += read_file("/proc/self/exe"); // tables, references, tolerances, how inputs are drawn
    all += text_of_folder(options.pins) + text_of_folder(options.worst);
    if (std::ranges::any_of(cases, [](const Case* c) { return find_chain(*c) != nullptr; }))
        for (const auto& [file, text] : options.sources.overlaid) all += file + '\n' + text;
    for (const Case* c : cases) {
        all += c->name + '\n';
        if (find_chain(*c)) continue;
        try {
            all += glsl::expand(options.sources, standalone_source(*c), standalone_name);
        } catch (const Error& error) {
            all += error.what(); // it will be told as a compile error
        }
    }
    return fmt::format("{:016x}", hash(all));
}

} // namespace gnomon::fuzz
