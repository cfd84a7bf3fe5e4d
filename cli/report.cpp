#include "cli/report.h"

#include "cli/junit.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::cli {
namespace {

/// The finding's lines of a report, each behind two blanks.
std::string finding_text(const CheckReport& report, const std::string& options) {
    std::string text;
    for (const std::string& line : explain_failure(report, options)) text += fmt::format("  {}\n", line);
    return text;
}

const char* verdict_word(Verdict verdict) {
    return verdict == Verdict::pass ? "pass" : verdict == Verdict::expected ? "expected" : "FAIL";
}

} // namespace

std::string check_text(std::span<const CheckReport> reports, const std::string& options) {
    std::size_t width = 6;
    for (const CheckReport& report : reports) width = std::max(width, report.kernel->name.size());
    std::string text = fmt::format("{:<{}}  {:<13}  {:>9}  {:>11}  {:<22}  {:>7}  {}\n", "kernel", width,
                                   "verdict", "samples", "worst error", "allowed", "ns/eval", "seed");
    std::size_t failed = 0;
    for (const CheckReport& report : reports) {
        const bool ran = report.worst.has_value();
        text +=
            fmt::format("{:<{}}  {:<13}  {:>9}  {:>11}  {:<22}  {:>7}  {:#018x}\n", report.kernel->name,
                        width, verdict_word(report.verdict), report.samples,
                        ran ? format_error(report.worst->error) : "-", to_string(report.kernel->tolerance),
                        ran ? fmt::format("{:.1f}", report.nanoseconds) : "-", report.seed);
        if (is_good(report.verdict) && report.worst && report.worst->error > 0)
            text += fmt::format("  worst at {}\n",
                                format_call(*report.kernel, report.worst->input,
                                            report.worst->mask ? &*report.worst->mask : nullptr));
        if (!is_good(report.verdict)) ++failed;
    }
    for (const CheckReport& report : reports)
        if (!is_good(report.verdict))
            text += fmt::format("\nFAIL {} ({})\n{}", report.kernel->name, to_string(report.verdict),
                                finding_text(report, options));
    text += fmt::format("\n{} passed, {} failed\n", reports.size() - failed, failed);
    return text;
}

std::string check_json(std::span<const CheckReport> reports, const std::string& options) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const CheckReport& report : reports) {
        const Case& c = *report.kernel;
        nlohmann::ordered_json entry{{"kernel", c.name},
                                     {"source", c.source},
                                     {"verdict", to_string(report.verdict)},
                                     {"seed", fmt::format("{:#018x}", report.seed)},
                                     {"samples", report.samples},
                                     {"failures", report.failures},
                                     {"allowed", to_string(c.tolerance)},
                                     {"nanoseconds_per_evaluation", report.nanoseconds}};
        if (!report.message.empty()) entry["message"] = report.message;
        if (report.worst) {
            const Finding& f = *report.worst;
            // JSON has no infinity: an error that is none is null.
            entry["worst_error"] = std::isfinite(f.error) ? nlohmann::ordered_json(f.error) : nullptr;
            entry["worst_call"] = format_call(c, f.input, f.mask ? &*f.mask : nullptr);
            entry["got"] = format_result(c, f.got);
            if (f.in_domain) entry["want"] = format_result(c, f.want);
            entry["replay"] = replay_command(c, f, options);
        }
        list.push_back(std::move(entry));
    }
    return nlohmann::ordered_json{{"kernels", list}}.dump(2, ' ', false,
                                                          nlohmann::ordered_json::error_handler_t::replace);
}

std::string check_junit(std::span<const CheckReport> reports, const std::string& options) {
    std::vector<JunitCase> cases;
    for (const CheckReport& report : reports) {
        JunitCase one;
        one.name = report.kernel->name;
        one.group = one.name.substr(0, one.name.find('/'));
        one.seconds = report.nanoseconds * static_cast<double>(report.samples) * 1e-9;
        if (!is_good(report.verdict)) {
            one.failure = to_string(report.verdict);
            one.text = finding_text(report, options);
        }
        cases.push_back(std::move(one));
    }
    return junit_xml("gnomon check", cases);
}

} // namespace gnomon::cli
