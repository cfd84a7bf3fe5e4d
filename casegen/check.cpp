#include "casegen/check.h"

#include "casegen/check_inputs.h"
#include "casegen/compare.h"
#include "casegen/csv.h"
#include "casegen/standalone.h"
#include "casegen/truths.h"
#include "casegen/verdict.h"
#include "casegen/worker_device.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <map>
#include <mutex>
#include <numeric>

namespace gnomon {
namespace {

constexpr std::size_t samples_per_dispatch = std::size_t{1} << 18;

/// Everything about a kernel that needs no device: made while the device starts.
struct Prepared {
    Sampler sampler;
    glsl::Spirv words;
    std::size_t samples;
    Records first; ///< the first dispatch's inputs
};

Prepared prepare(const Case& c, const CheckOptions& options, const glsl::Sources& sources,
                 const std::shared_ptr<const EdgePool>& pool, std::span<const CsvInput> regressions) {
    Sampler sampler = make_sampler(c, options, pool, regressions);
    const std::size_t samples = std::max(options.samples.value_or(default_samples(c)), sampler.fixed_count());
    Records first = draw_records(c, sampler, 0, std::min(samples, samples_per_dispatch));
    glsl::Spirv words = compile_standalone(c, sources); // last: glslang may still be building its tables
    return {std::move(sampler), std::move(words), samples, std::move(first)};
}

/// `progress` is told of every dispatch's samples.
void run(const Case& c, const Prepared& prepared, gpu::Device& device, CheckReport& report,
         const std::function<void(std::size_t)>& progress) {
    gpu::Kernel kernel = device.kernel(prepared.words, c.name);
    report.samples = prepared.samples;
    for (std::size_t begin = 0; begin < prepared.samples; begin += samples_per_dispatch) {
        const std::size_t end = std::min(prepared.samples, begin + samples_per_dispatch);
        Records drawn(c);
        if (begin > 0) drawn = draw_records(c, prepared.sampler, begin, end);
        const Records& records = begin == 0 ? prepared.first : drawn;
        Outputs outputs = run_standalone(device, kernel, c, records);
        report.nanoseconds += outputs.nanoseconds / static_cast<double>(prepared.samples);
        add_judged(c, records, begin, judge_all(c, records, std::move(outputs.words), truths(c, records)),
                   report);
        if (add_complaint(c, records, begin, outputs, report)) return;
        progress(end - begin);
    }
}

CheckReport check_one(const Case& c, const CheckOptions& options, const glsl::Sources& sources,
                      const std::shared_ptr<const EdgePool>& pool, std::span<const CsvInput> regressions,
                      WorkerDevice& device, const std::function<void(std::size_t)>& progress) {
    CheckReport report;
    report.kernel = &c;
    report.seed = options.seed.value_or(default_seed(c));
    try {
        const Prepared prepared = prepare(c, options, sources, pool, regressions);
        run(c, prepared, device.get(), report, progress);
        expect_what_the_table_says(report);
    } catch (const CompileError& error) {
        report.verdict = Verdict::compile_error;
        report.message = error.what();
    } catch (const KernelTimeout& error) {
        report.verdict = Verdict::timeout;
        report.message = error.what();
        device.restart();
    }
    return report;
}

/// The whole text that a kernel compiles from; empty for what does not even expand, which compiling will
/// explain.
std::string whole_source(const Case& c, const glsl::Sources& sources) {
    try {
        return glsl::expand(sources, standalone_source(c), standalone_name);
    } catch (const Error&) {
        return {};
    }
}

} // namespace

std::size_t samples_asked_for(std::span<const Case* const> cases, const CheckOptions& options) {
    std::size_t total = 0;
    for (const Case* c : cases) total += options.samples.value_or(default_samples(*c));
    return total;
}

std::string to_string(Verdict verdict) {
    switch (verdict) {
    case Verdict::pass:
        return "pass";
    case Verdict::expected:
        return "fails, as expected";
    case Verdict::passes_wrongly:
        return "passes, but must fail";
    case Verdict::wrong:
        return "wrong";
    case Verdict::unwritten:
        return "unwritten";
    case Verdict::stray_write:
        return "stray write";
    case Verdict::unstable:
        return "unstable";
    case Verdict::compile_error:
        return "compile error";
    case Verdict::timeout:
        return "timeout";
    }
    return {};
}

void require_kernels(const std::filesystem::path& kernels) {
    if (!std::filesystem::is_directory(kernels))
        throw Error("{}: no such folder; --kernels names the one that holds smsr/case_09.glsl and the others",
                    kernels.string());
}

std::vector<CheckReport> check(std::span<const Case* const> cases, const CheckOptions& options,
                               const std::function<void(std::size_t)>& done, WorkerDevice* first) {
    require_kernels(options.kernels);
    const glsl::Sources sources = kernel_sources(options.kernels);
    const std::map<std::string, std::vector<CsvInput>> regressions =
        load_inputs_of_regressions(cases, options);
    std::vector<CheckReport> reports(cases.size());
    std::size_t samples_done = 0;
    std::mutex mutex;

    std::vector<std::string> texts;
    for (const Case* c : cases) texts.push_back(whole_source(*c, sources));
    // Long kernels first, so that no worker is left alone with one at the end.
    std::vector<std::size_t> order(cases.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::greater{}, [&](std::size_t i) { return texts[i].size(); });
    // If anything must be compiled, glslang builds its tables while Vulkan starts and samples are drawn.
    std::future<void> tables;
    if (std::ranges::any_of(texts, [](const std::string& text) {
            return glsl::find_cached(text, glsl::Stage::compute).empty();
        }))
        tables = std::async(std::launch::async, glsl::warm_up);

    // Masks are the same for every kernel: one corpus, drawn from the seed that was given or from a fixed
    // one.
    const std::shared_future<std::shared_ptr<const EdgePool>> pool = std::async(std::launch::async, [&] {
        return std::make_shared<const EdgePool>(make_edge_pool(options.seed.value_or(default_seed("masks"))));
    });
    const auto progress = [&](std::size_t samples) {
        const std::scoped_lock lock(mutex);
        samples_done += samples;
        if (done) done(samples_done);
    };
    const auto check_in_turn = [&](std::size_t n, WorkerDevice& device) {
        const std::size_t i = order[n];
        reports[i] = check_one(*cases[i], options, sources, pool.get(), regressions.at(cases[i]->name),
                               device, progress);
    };
    on_worker_devices(cases.size(), options.jobs, options.device, check_in_turn, first);
    return reports;
}

std::string format_result(const Case& c, std::span<const std::uint32_t> words) {
    if (words.empty()) return "nothing";
    const Type type = c.reference.result;
    std::vector<std::string> cells;
    for (const std::uint32_t word : words) cells.push_back(format_word(type.scalar, word));
    if (type.components == 1) return cells.front();
    return fmt::format("{}({})", glsl_name(type), fmt::join(cells, ", "));
}

std::string format_result(const Case& c, const Numbers& numbers) {
    std::vector<std::uint32_t> words;
    for (int k = 0; k < c.reference.result.components; ++k)
        words.push_back(narrow(c.reference.result.scalar, numbers[static_cast<std::size_t>(k)]));
    return format_result(c, words);
}

std::string format_want(const Case& c, const Arguments& arguments) {
    if (in_domain(c, arguments)) return format_result(c, c.reference.call(arguments));
    const auto rule =
        c.outside ? c.outside(std::span(arguments.numbers).first(c.reference.words.size())) : std::nullopt;
    if (!rule) return fmt::format("anything from {:g} to {:g}", c.result.lower, c.result.upper);
    if (rule->lower == rule->upper) return format_result(c, rule->lower);
    return fmt::format("{} to {}", format_result(c, rule->lower), format_result(c, rule->upper));
}

std::string format_call(const Case& c, std::span<const std::uint32_t> input, const Mask* mask) {
    std::vector<std::string> parts;
    std::size_t word = 0;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Type type = c.reference.parameters[i];
        std::vector<std::string> cells;
        for (int k = 0; k < type.components; ++k) cells.push_back(format_word(type.scalar, input[word++]));
        parts.push_back(type.components == 1 ? fmt::format("{} = {}", c.parameters[i].name, cells.front())
                                             : fmt::format("{} = {}({})", c.parameters[i].name,
                                                           glsl_name(type), fmt::join(cells, ", ")));
    }
    std::string call = fmt::format("{}({})", function_name(c), fmt::join(parts, ", "));
    if (mask)
        call += fmt::format(" on a mask of {} x {}, {} outside", mask->width, mask->height,
                            to_string(mask->outside));
    return call;
}

std::string replay_command(const Case& c, const Finding& finding, const std::string& options) {
    std::vector<std::string> cells;
    if (finding.mask) cells = {format_mask(*finding.mask, '/'), to_string(finding.mask->outside)};
    std::size_t word = 0;
    for (const Type& type : c.reference.parameters)
        for (int k = 0; k < type.components; ++k)
            cells.push_back(format_word(type.scalar, finding.input[word++]));
    return fmt::format("gnomon eval {}{} --reference --at '{}'", c.name, options, fmt::join(cells, ","));
}

std::vector<std::string> explain_failure(const CheckReport& report, const std::string& options) {
    const Case& c = *report.kernel;
    std::vector<std::string> lines;
    if (!report.message.empty()) lines.push_back(report.message);
    if (report.worst && report.verdict != Verdict::stray_write && report.verdict != Verdict::unstable) {
        const Finding& f = *report.worst;
        lines.push_back(format_call(c, f.input, f.mask ? &*f.mask : nullptr));
        const Arguments with = arguments(c, f.input, f.mask ? &*f.mask : nullptr);
        const std::string want =
            f.in_domain ? format_result(c, f.want) : format_want(c, with) + " (input outside the domain)";
        const bool exactly = f.in_domain && exact_at(c, with);
        std::string allowed = exactly ? "no error: nothing is rounded here" : to_string(c.tolerance);
        if (f.in_domain && c.within) {
            const std::span numbers = std::span(with.numbers).first(c.reference.words.size());
            const Bounds bounds = c.within(numbers, c.reference.truth(with));
            allowed += fmt::format(", from {} to {}", format_result(c, bounds.lower),
                                   format_result(c, bounds.upper));
        }
        lines.push_back(fmt::format("got {}, want {}, allowed {}", format_result(c, f.got), want, allowed));
        lines.push_back(replay_command(c, f, options));
    }
    if (report.verdict == Verdict::wrong)
        lines.push_back(
            fmt::format("{} of {} samples fail; seed {:#x}", report.failures, report.samples, report.seed));
    return lines;
}

std::string format_error(double error) {
    return error == 0 ? "0" : std::isinf(error) ? "none finite" : fmt::format("{:.3g}", error);
}

} // namespace gnomon
