#include "cli/mutate_report.h"

#include "cli/junit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::cli {
namespace {

using mutate::Fate;
using mutate::KernelCount;
using mutate::MutantReport;

std::string indented(const std::string& text, const char* indentation) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        result += indentation + text.substr(at, end - at) + '\n';
        at = end + 1;
    }
    return result;
}

std::string place_of(const mutate::Mutant& mutant) {
    if (mutant.mutation.by == mutate::Operator::stale) return mutant.file;
    return fmt::format("{}:{}:{}", mutant.file, mutant.mutation.line, mutant.mutation.column);
}

/// Rounded down: 100 % is all of them.
std::string percent(std::optional<double> share) {
    return share ? fmt::format("{:.1f} %", std::floor(*share * 1000) / 10) : "-";
}

std::string row(const std::string& name, std::size_t width, const KernelCount& count) {
    return fmt::format("{:<{}} {:>7} {:>9} {:>9} {:>7} {:>10} {:>9} {:>8} {:>8}\n", name, width,
                       count.total(), count.same_code, count.stillborn, count.killed, count.equivalent,
                       count.tolerated, count.survived, percent(count.score()));
}

std::string survivor_text(const MutantReport& each, const glsl::Sources& sources,
                          const std::string& options) {
    const mutate::Mutant& mutant = each.mutant;
    return fmt::format("\nSURVIVED {} {} ({})\n{}  {}\n  gnomon mutate {}{} --mutant {}\n", place_of(mutant),
                       mutant.id, to_string(mutant.mutation.by), indented(difference(mutant, sources), "  "),
                       each.how, mutant.users.front()->name, options, mutant.id);
}

using Json = nlohmann::ordered_json;

Json json_of(const MutantReport& each) {
    const mutate::Mutant& mutant = each.mutant;
    Json entry{{"id", mutant.id},
               {"file", mutant.file},
               {"line", mutant.mutation.line},
               {"column", mutant.mutation.column},
               {"operator", to_string(mutant.mutation.by)},
               {"before", mutant.before},
               {"after", mutant.mutation.after},
               {"fate", to_string(each.fate)}};
    if (each.by) entry["kernel"] = each.by->name;
    entry["how"] = each.how;
    return entry;
}

Json json_of(const KernelCount& count, const mutate::CampaignReport& report) {
    Json survived = Json::array();
    for (const std::size_t i : count.mutants)
        if (report.mutants[i].fate == Fate::survived) survived.push_back(json_of(report.mutants[i]));
    Json entry;
    if (count.kernel) entry["name"] = count.kernel->name;
    entry["mutants"] = count.total();
    entry["killed"] = count.killed;
    entry["equivalent"] = count.equivalent + count.tolerated;
    entry["tolerated"] = count.tolerated;
    entry["same_code"] = count.same_code;
    entry["stillborn"] = count.stillborn;
    entry["not_run"] = count.not_run;
    entry["score"] = count.score() ? Json(*count.score()) : Json();
    entry["survived"] = std::move(survived);
    return entry;
}

} // namespace

std::string mutate_text(const mutate::CampaignReport& report, const glsl::Sources& sources,
                        const std::string& options) {
    std::size_t width = 12;
    for (const KernelCount& count : report.kernels) width = std::max(width, count.kernel->name.size());
    std::string text =
        fmt::format("{:<{}} {:>7} {:>9} {:>9} {:>7} {:>10} {:>9} {:>8} {:>8}\n", "kernel", width, "mutants",
                    "same code", "stillborn", "killed", "equivalent", "tolerated", "survived", "score");
    for (const KernelCount& count : report.kernels) text += row(count.kernel->name, width, count);
    text += row("every mutant", width, report.all);
    if (!report.must_fail.empty())
        text +=
            fmt::format("{} kernels must fail their checks, and have no mutants\n", report.must_fail.size());
    for (const MutantReport& each : report.mutants)
        if (each.fate == Fate::survived) text += survivor_text(each, sources, options);
    for (const std::string& complaint : report.complaints) text += fmt::format("\nERROR {}\n", complaint);
    if (report.all.not_run > 0)
        text += fmt::format("\n{}{} mutants were not run\n", report.interrupted ? "interrupted: " : "",
                            report.all.not_run);
    return text + fmt::format("\n{} of {} mutants survive; {:.1f} s\n", report.all.survived,
                              report.all.total(), report.seconds);
}

std::string mutate_json(const mutate::CampaignReport& report) {
    Json kernels = Json::array(), mutants = Json::array();
    for (const KernelCount& count : report.kernels) kernels.push_back(json_of(count, report));
    for (const MutantReport& each : report.mutants) mutants.push_back(json_of(each));
    const Json all{{"kernels", kernels},
                   {"mutants", mutants},
                   {"all", json_of(report.all, report)},
                   {"complaints", report.complaints},
                   {"interrupted", report.interrupted},
                   {"seconds", report.seconds}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string mutate_junit(const mutate::CampaignReport& report, const glsl::Sources& sources) {
    std::vector<JunitCase> cases;
    for (const KernelCount& count : report.kernels) {
        JunitCase one{"mutate", count.kernel->name, 0, {}, {}};
        for (const std::size_t i : count.mutants)
            if (report.mutants[i].fate == Fate::survived)
                one.text += survivor_text(report.mutants[i], sources, {});
        if (!one.text.empty()) one.failure = "mutants survive";
        if (one.failure.empty() && count.not_run > 0) {
            one.failure = "not run";
            one.text = fmt::format("{} mutants were not run", count.not_run);
        }
        cases.push_back(std::move(one));
    }
    JunitCase listed{"mutate", "the list of equivalent mutants", 0, {}, {}};
    listed.text = fmt::format("{}", fmt::join(report.complaints, "\n"));
    if (!report.complaints.empty()) listed.failure = "it says what is not so";
    cases.push_back(std::move(listed));
    return junit_xml("gnomon mutate", cases);
}

std::string mutant_text(const MutantReport& report, const glsl::Sources& sources) {
    const mutate::Mutant& mutant = report.mutant;
    std::string users;
    for (const Case* c : mutant.users) users += (users.empty() ? "" : ", ") + c->name;
    std::string text = fmt::format("{} {} ({})\n{}checked by {}\n{}{}\n", place_of(mutant), mutant.id,
                                   to_string(mutant.mutation.by), difference(mutant, sources), users,
                                   to_string(report.fate), report.by ? " by " + report.by->name : "");
    if (!report.how.empty()) text += fmt::format("  {}\n", report.how);
    if (report.listed) text += fmt::format("listed: {}\n", report.listed->reason);
    return text;
}

} // namespace gnomon::cli
