#include "cli/fuzz_report.h"

#include "casegen/check.h"
#include "casegen/fuzz/chain.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace gnomon::cli {
namespace {

/// "8 s", "3 min", "2.5 h".
std::string duration(double seconds) {
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    return seconds < 7200 ? fmt::format("{:.0f} min", seconds / 60) : fmt::format("{:.1f} h", seconds / 3600);
}

double per_second(std::uint64_t evaluations, double seconds) {
    return seconds > 0 ? static_cast<double>(evaluations) / seconds : 0;
}

std::string allowed(const Case& c) {
    return fuzz::find_chain(c) ? "no broken invariant" : to_string(c.tolerance);
}

std::string finding_text(const fuzz::Finding& finding, const std::string& replay) {
    const fuzz::Regression& r = finding.regression;
    const Case& c = *fuzz::find_subject(r.kernel);
    std::string text = fmt::format("\nFAIL {}: {}{}\n", r.kernel, r.failure, finding.known ? " (known)" : "");
    if (finding.file.empty())
        return text + fmt::format("  {}\n", r.found.empty() ? r.got : r.got + "\n  " + r.found);
    text += fmt::format("  {}\n", fuzz::format_input(c, r.input));
    if (c.reference.takes_mask)
        for (int y = r.input.mask.height - 1; y >= 0; --y) {
            std::string row;
            for (int x = 0; x < r.input.mask.width; ++x) row += r.input.mask.lit(x, y) ? '.' : '#';
            text += fmt::format("    {}{}\n", row, y == r.input.mask.height - 1 ? "   +y" : "");
        }
    if (!fuzz::find_chain(c))
        text += fmt::format("  got {}, want {}, allowed {}\n", r.got, r.want, r.allowed);
    if (fuzz::find_chain(c))
        return text + fmt::format("  gnomon check {}{}\n  {}\n", r.kernel, replay, finding.file.string());
    gnomon::Finding replayed;
    replayed.input = r.input.words;
    if (c.reference.takes_mask) replayed.mask = r.input.mask;
    return text + fmt::format("  {}\n  {}\n", replay_command(c, replayed, replay), finding.file.string());
}

} // namespace

FuzzProgress::FuzzProgress() : terminal_(isatty(STDERR_FILENO) == 1) {}

FuzzProgress::~FuzzProgress() {
    if (shown_ && terminal_) fmt::print(stderr, "\r\x1b[K");
}

void FuzzProgress::show(const fuzz::CampaignProgress& now) {
    const auto time = std::chrono::steady_clock::now();
    if (time - last_ < (terminal_ ? std::chrono::milliseconds(200) : std::chrono::seconds(10))) return;
    last_ = time;
    const double left = now.share > 0 ? now.seconds * (1 - std::min(1.0, now.share)) / now.share : 0;
    std::string line =
        fmt::format("{:.3g} evaluations, {:.1f} M/s, {} found", static_cast<double>(now.evaluations),
                    per_second(now.evaluations, now.seconds) * 1e-6, now.findings);
    if (now.worst_kernel)
        line += fmt::format(", worst {} of {} ({})", format_error(now.worst_error),
                            to_string(now.worst_kernel->tolerance), now.worst_kernel->name);
    line += fmt::format(", {} left", duration(left));
    fmt::print(stderr, "{}{}{}", terminal_ ? "\r\x1b[K" : "fuzzing: ", line, terminal_ ? "" : "\n");
    std::fflush(stderr);
    shown_ = true;
}

std::string fuzz_text(const fuzz::CampaignReport& report, const fuzz::CampaignOptions& options,
                      const std::string& replay) {
    std::size_t width = 6;
    for (const fuzz::KernelReport& kernel : report.kernels)
        width = std::max(width, kernel.kernel->name.size());
    std::string text =
        fmt::format("{:<{}}  {:>12}  {:>11}  {}\n", "kernel", width, "evaluations", "worst error", "allowed");
    for (const fuzz::KernelReport& kernel : report.kernels) {
        const bool fails = std::ranges::any_of(report.findings, [&](const fuzz::Finding& finding) {
            return finding.regression.kernel == kernel.kernel->name;
        });
        text += fmt::format("{:<{}}  {:>12}  {:>11}  {}\n", kernel.kernel->name, width, kernel.evaluations,
                            fails ? "FAIL" : format_error(kernel.worst_error), allowed(*kernel.kernel));
        if (!kernel.given_up.empty()) text += fmt::format("  given up: {}\n", kernel.given_up);
    }
    for (const fuzz::Finding& finding : report.findings) text += finding_text(finding, replay);
    const auto fresh =
        std::ranges::count_if(report.findings, [](const fuzz::Finding& f) { return !f.known; });
    text += fmt::format("\n{} evaluations in {} units", report.evaluations, report.units);
    if (report.resumed_units > 0)
        text += fmt::format(" ({} of them before it was interrupted)", report.resumed_units);
    text += fmt::format(", {:.1f} s, {:.1f} M/s; seed {:#x}\n", report.seconds,
                        per_second(report.evaluations_now, report.seconds) * 1e-6, options.seed);
    if (report.interrupted) text += "interrupted; the same command goes on from here\n";
    text += fmt::format("{} failures, {} of them new\n", report.findings.size(), fresh);
    return text;
}

std::string fuzz_json(const fuzz::CampaignReport& report, const fuzz::CampaignOptions& options) {
    using Json = nlohmann::ordered_json;
    Json kernels = Json::array(), findings = Json::array();
    for (const fuzz::KernelReport& kernel : report.kernels) {
        Json entry{{"kernel", kernel.kernel->name},
                   {"evaluations", kernel.evaluations},
                   {"worst_error", kernel.worst_error},
                   {"allowed", allowed(*kernel.kernel)}};
        if (kernel.worst_error > 0) entry["worst"] = fuzz::format_input(*kernel.kernel, kernel.worst);
        if (!kernel.given_up.empty()) entry["given_up"] = kernel.given_up;
        kernels.push_back(std::move(entry));
    }
    for (const fuzz::Finding& finding : report.findings)
        findings.push_back({{"kernel", finding.regression.kernel},
                            {"failure", finding.regression.failure},
                            {"known", finding.known},
                            {"file", finding.file.string()},
                            {"got", finding.regression.got},
                            {"want", finding.regression.want},
                            {"found", finding.regression.found}});
    const Json all{{"seed", fmt::format("{:#x}", options.seed)},
                   {"evaluations", report.evaluations},
                   {"units", report.units},
                   {"resumed_units", report.resumed_units},
                   {"seconds", report.seconds},
                   {"evaluations_per_second", per_second(report.evaluations_now, report.seconds)},
                   {"interrupted", report.interrupted},
                   {"kernels", kernels},
                   {"findings", findings}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

} // namespace gnomon::cli
