#include "cli/report.h"

#include "casegen/atlas/html.h"

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
    return nlohmann::ordered_json{{"kernels", list}}.dump(2);
}

std::string check_junit(std::span<const CheckReport> reports, const std::string& options) {
    std::string cases;
    std::size_t failed = 0;
    for (const CheckReport& report : reports) {
        const std::string& name = report.kernel->name;
        const std::string family = name.substr(0, name.find('/'));
        const double seconds = report.nanoseconds * static_cast<double>(report.samples) * 1e-9;
        cases += fmt::format("  <testcase classname=\"{}\" name=\"{}\" time=\"{:.6f}\"",
                             atlas::escape_html(family), atlas::escape_html(name), seconds);
        if (is_good(report.verdict)) {
            cases += "/>\n";
            continue;
        }
        ++failed;
        cases += fmt::format(">\n    <failure type=\"{0}\" message=\"{0}\">{1}</failure>\n  </testcase>\n",
                             atlas::escape_html(to_string(report.verdict)),
                             atlas::escape_html(finding_text(report, options)));
    }
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
                       "<testsuite name=\"gnomon check\" tests=\"{}\" failures=\"{}\">\n{}</testsuite>",
                       reports.size(), failed, cases);
}

} // namespace gnomon::cli
