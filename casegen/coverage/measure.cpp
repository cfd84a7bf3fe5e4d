#include "casegen/coverage/measure.h"

#include "casegen/added_buffer.h"
#include "casegen/check_inputs.h"
#include "casegen/worker_device.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <future>
#include <mutex>
#include <optional>

namespace gnomon::coverage {
namespace {

constexpr std::size_t samples_per_dispatch = std::size_t{1} << 18;

/// What a kernel is made of: files, then generated texts in <>.
std::vector<std::string> texts_in(const glsl::Sources& sources, const Case& c) {
    std::vector<std::string> names = glsl::included_files(sources, standalone_source(c));
    const std::string whole = glsl::expand(sources, standalone_source(c), standalone_name);
    for (const auto& [name, text] : sources.generated)
        if (whole.find(fmt::format("#line 1 \"<{}>\"\n", name)) != std::string::npos)
            names.push_back("<" + name + ">");
    return names;
}

/// The text behind such a name.
std::string named_text(const glsl::Sources& sources, const std::string& name) {
    if (name.starts_with('<')) return sources.generated.at(name.substr(1, name.size() - 2));
    return glsl::text_of(sources, name);
}

/// A kernel as it is and the same with counters: with all of them, or with parts of them in turn where all
/// change results. A driver that no longer unrolls a loop for them may round otherwise.
class Twins {
public:
    /// Throws CompileError.
    Twins(gpu::Device& device, const glsl::Sources& sources, const Case& c, const Instrumenter& instrumenter)
        : device_(device), case_(c), sources_(sources),
          plain_(device.kernel(compile_standalone(c, sources), c.name)) {
        for (const std::string& name : texts_in(sources, c)) {
            Instrumented instrumented = instrumenter(named_text(sources, name), counters_);
            files_.push_back({name, counters_, instrumented.counters});
            counters_ += instrumented.counters + instrumented.counters % 2;
            if (name.starts_with('<'))
                sources_.generated[name.substr(1, name.size() - 2)] = std::move(instrumented.text);
            else
                sources_.overlaid[name] = std::move(instrumented.text);
        }
        counting_.push_back(counting({0, counters_}));
    }

    /// Adds how many of `records` reach what; the first difference, if the counters make one. Throws
    /// KernelTimeout.
    std::string run(const Records& records, std::uint64_t Hits::*to, KernelRun& result) {
        const Outputs plain = run_standalone(device_, plain_, case_, records);
        gpu::Buffer reached = device_.allocate(records.size() * words_of(counters_) * sizeof(std::uint32_t));
        std::vector<Reached> counts(words_of(counters_) * 32);
        std::string complaint;
        for (std::size_t i = 0; i < counting_.size();) {
            const Outputs counted = run_standalone(device_, counting_[i].kernel, case_, records, reached);
            const std::string difference = this->difference(records, plain, counted);
            if (!difference.empty() && complaint.empty()) {
                if (is_same_without_counting(records, plain, reached)) {
                    result.left_out += halve(i);
                    continue;
                }
                complaint = difference;
            }
            count(records.size(), reached, counts);
            ++i;
        }
        for (const File& file : files_) {
            std::vector<Hits>& hits = result.hits[file.name];
            hits.resize(file.counters);
            for (std::size_t i = 0; i < file.counters; ++i) {
                const Reached& reached_here = counts[file.first + i];
                if (reached_here.inputs > 0 && hits[i].all() == 0 && to == &Hits::samples)
                    result.replays[file.name][i] = replay(records, reached_here.first);
                hits[i].*to += reached_here.inputs;
            }
        }
        return complaint;
    }

private:
    struct File {
        std::string name;
        std::size_t first = 0, counters = 0;
    };
    struct Reached {
        std::uint64_t inputs = 0;
        std::size_t first = 0; ///< the first one's record
    };
    struct Counting {
        Range active;
        gpu::Kernel kernel;
    };

    Counting counting(Range active) {
        const glsl::Spirv words = compile_standalone(case_, sources_, counters_around(counters_, active));
        return {active, device_.kernel(words, case_.name + " with counters")};
    }

    bool is_same_without_counting(const Records& records, const Outputs& plain, gpu::Buffer& reached) {
        Counting none = counting({0, 0});
        return difference(records, plain, run_standalone(device_, none.kernel, case_, records, reached))
            .empty();
    }

    /// Kernel `i` counts half of what it did, and one behind it the rest; it goes if it counted one pair.
    /// Returns how many counters are gone.
    std::size_t halve(std::size_t i) {
        const Range active = counting_[i].active;
        const auto at = counting_.begin() + static_cast<std::ptrdiff_t>(i);
        if (active.end - active.begin <= 2) {
            counting_.erase(at);
            return active.end - active.begin;
        }
        const std::size_t middle = (active.begin + active.end) / 4 * 2;
        *at = counting({active.begin, middle});
        counting_.insert(at + 1, counting({middle, active.end}));
        return 0;
    }

    void count(std::size_t records, const gpu::Buffer& reached, std::vector<Reached>& counts) {
        const std::size_t words = words_of(counters_);
        const gpu::HostView<std::uint32_t> bits = device_.view<std::uint32_t>(reached, records * words);
        for (std::size_t i = 0; i < bits.values.size(); ++i)
            for (std::uint32_t rest = bits.values[i]; rest != 0; rest &= rest - 1) {
                Reached& here = counts[i % words * 32 + static_cast<std::size_t>(std::countr_zero(rest))];
                if (here.inputs++ == 0) here.first = i / words;
            }
    }

    std::string replay(const Records& records, std::size_t record) const {
        Finding finding;
        finding.input.assign(records.input(record).begin(), records.input(record).end());
        if (const Mask* mask = records.mask(record)) finding.mask = *mask;
        return replay_command(case_, finding);
    }

    /// NaN is NaN: GLSL does not say which bits it has.
    std::string difference(const Records& records, const Outputs& plain, const Outputs& counted) const {
        const Scalar scalar = case_.reference.result.scalar;
        const auto is_same = [&](std::uint32_t a, std::uint32_t b) {
            return a == b || (std::isnan(widen(scalar, a)) && std::isnan(widen(scalar, b)));
        };
        const auto want = std::ranges::mismatch(plain.words, counted.words, is_same).in1;
        if (want == plain.words.end()) return {};
        const auto components = static_cast<std::size_t>(case_.reference.result.components);
        const std::size_t i = static_cast<std::size_t>(want - plain.words.begin()) / components;
        const auto result = [&](const Outputs& outputs) {
            return format_result(case_, std::span(outputs.words).subspan(i * components, components));
        };
        return fmt::format("gives {} with counters and {} without: {}", result(counted), result(plain),
                           format_call(case_, records.input(i), records.mask(i)));
    }

    gpu::Device& device_;
    const Case& case_;
    glsl::Sources sources_; ///< with counters
    std::vector<File> files_;
    std::size_t counters_ = 0;
    gpu::Kernel plain_;
    std::vector<Counting> counting_; ///< all counters between them
};

KernelRun measure_one(const Case& c, const Options& options, const glsl::Sources& sources,
                      const std::shared_ptr<const EdgePool>& pool, std::span<const CsvInput> regressions,
                      WorkerDevice& device, const std::function<void(std::size_t)>& progress) {
    KernelRun result;
    result.kernel = &c;
    const Sampler sampler = make_sampler(c, options.check, pool, regressions);
    const std::size_t fixtures = sampler.fixed_count();
    const std::size_t all = options.only_fixtures
                                ? fixtures
                                : std::max(fixtures, options.check.samples.value_or(default_samples(c)));
    try {
        Twins twins(device.get(), sources, c, instrument);
        for (std::size_t begin = 0; begin < all;) {
            const bool fixed = begin < fixtures;
            const std::size_t end = std::min(fixed ? fixtures : all, begin + samples_per_dispatch);
            const std::string difference = twins.run(draw_records(c, sampler, begin, end),
                                                     fixed ? &Hits::fixtures : &Hits::samples, result);
            if (result.trouble.empty()) result.trouble = difference;
            (fixed ? result.fixtures : result.samples) += end - begin;
            progress(end - begin);
            begin = end;
        }
    } catch (const CompileError& error) {
        result.trouble = error.what();
    } catch (const KernelTimeout& error) {
        result.trouble = error.what();
        device.restart();
    }
    return result;
}

/// What is reached by either and counted apart.
void take_larger(Hits& hits, const Hits& other) {
    hits.fixtures = std::max(hits.fixtures, other.fixtures);
    hits.samples = std::max(hits.samples, other.samples);
}

void count(Share& share, const Hits& hits) {
    share.fixtures += hits.fixtures > 0 ? 1 : 0;
    share.all += hits.all() > 0 ? 1 : 0;
    ++share.of;
}

} // namespace

KernelRun measure_on(gpu::Device& device, const glsl::Sources& sources, const Case& c, const Records& records,
                     const Instrumenter& instrumenter) {
    KernelRun result;
    result.kernel = &c;
    Twins twins(device, sources, c, instrumenter);
    result.trouble = twins.run(records, &Hits::fixtures, result);
    result.fixtures = records.size();
    return result;
}

std::vector<FileCoverage> merge(const glsl::Sources& sources, std::span<const KernelRun> runs) {
    std::map<std::string, FileCoverage> files;
    for (const KernelRun& run : runs)
        for (const auto& [name, hits] : run.hits) {
            FileCoverage& file = files[name];
            if (file.name.empty()) {
                file.name = name;
                file.text = named_text(sources, name);
                file.points = instrument(file.text);
                file.hits.resize(file.points.counters);
            }
            for (std::size_t i = 0; i < std::min(hits.size(), file.hits.size()); ++i) {
                file.hits[i].fixtures += hits[i].fixtures;
                file.hits[i].samples += hits[i].samples;
            }
            if (const auto found = run.replays.find(name); found != run.replays.end())
                file.replays.insert(found->second.begin(), found->second.end());
        }
    std::vector<FileCoverage> merged;
    for (auto& entry : files) {
        FileCoverage& file = entry.second;
        std::erase_if(file.replays, [&](const auto& replay) { return file.hits[replay.first].fixtures > 0; });
        merged.push_back(std::move(file));
    }
    std::ranges::stable_sort(merged, {}, &FileCoverage::is_generated);
    return merged;
}

Coverage measure(std::span<const Case* const> cases, const Options& options,
                 const std::function<void(std::size_t)>& done) {
    require_kernels(options.check.kernels);
    const glsl::Sources sources = kernel_sources(options.check.kernels);
    const std::map<std::string, std::vector<CsvInput>> regressions =
        load_inputs_of_regressions(cases, options.check);
    const std::shared_future<std::shared_ptr<const EdgePool>> pool = std::async(std::launch::async, [&] {
        return std::make_shared<const EdgePool>(
            make_edge_pool(options.check.seed.value_or(default_seed("masks"))));
    });
    std::size_t inputs_done = 0;
    std::mutex mutex;
    const auto progress = [&](std::size_t inputs) {
        const std::scoped_lock lock(mutex);
        inputs_done += inputs;
        if (done) done(inputs_done);
    };
    Coverage coverage;
    coverage.only_fixtures = options.only_fixtures;
    coverage.kernels.resize(cases.size());
    on_worker_devices(cases.size(), options.check.jobs, options.check.device,
                      [&](std::size_t i, WorkerDevice& device) {
                          coverage.kernels[i] = measure_one(*cases[i], options, sources, pool.get(),
                                                            regressions.at(cases[i]->name), device, progress);
                      });
    coverage.files = merge(sources, coverage.kernels);
    return coverage;
}

std::map<int, Hits> line_hits(const FileCoverage& file) {
    std::map<int, Hits> lines;
    for (const Lines& some : file.points.lines)
        for (int line = some.first; line <= some.last; ++line)
            take_larger(lines[line], file.hits[some.counter]);
    return lines;
}

Share& Share::operator+=(const Share& other) {
    fixtures += other.fixtures;
    all += other.all;
    of += other.of;
    return *this;
}

Totals& Totals::operator+=(const Totals& other) {
    lines += other.lines;
    branches += other.branches;
    functions += other.functions;
    return *this;
}

Totals totals(const FileCoverage& file) {
    Totals totals;
    for (const auto& [line, hits] : line_hits(file)) count(totals.lines, hits);
    for (const Branch& branch : file.points.branches)
        for (const Branch::Outcome& outcome : branch.outcomes)
            count(totals.branches, file.hits[outcome.counter]);
    for (const Function& function : file.points.functions)
        count(totals.functions, file.hits[function.counter]);
    return totals;
}

Totals totals(const Coverage& coverage) {
    Totals sum;
    for (const FileCoverage& file : coverage.files) sum += totals(file);
    return sum;
}

} // namespace gnomon::coverage
