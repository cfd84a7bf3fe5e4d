#include "casegen/coverage/report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>

namespace gnomon::coverage {
namespace {

using Json = nlohmann::ordered_json;

enum class State { never, only_by_samples, reached };

State state(const Hits& hits, bool with_samples) {
    if (hits.fixtures > 0) return State::reached;
    return with_samples && hits.samples > 0 ? State::only_by_samples : State::never;
}

/// The lines of a text, without blanks at either end.
std::vector<std::string> trimmed_lines(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        const std::size_t first = std::min(line.find_first_not_of(" \t\r"), line.size());
        const std::size_t last = std::min(line.find_last_not_of(" \t\r"), line.size() - 1);
        lines.emplace_back(first < line.size() ? line.substr(first, last - first + 1) : "");
    }
    return lines;
}

std::string of_outcome(const Branch& branch, const Branch::Outcome& outcome, State state) {
    const bool never = state == State::never;
    if (branch.kind == Branch::Kind::condition)
        return fmt::format("`{}` was {}{}{}", branch.text, never ? "never " : "", outcome.what,
                           never ? "" : " only in random samples");
    if (outcome.what == "none of them")
        return fmt::format("`switch ({})` {} without a case", branch.text,
                           never ? "was never" : "was only in random samples");
    return fmt::format("`{}` was {}", outcome.what, never ? "never taken" : "taken only in random samples");
}

struct Column {
    const char* name;
    Share Totals::*share;
};
constexpr Column columns[] = {
    {"lines", &Totals::lines}, {"branches", &Totals::branches}, {"functions", &Totals::functions}};

std::string row(const std::string& name, std::size_t width, const Totals& totals, bool with_samples) {
    std::string text = fmt::format("{:<{}}", name, width);
    for (const Column& column : columns) {
        const Share& share = totals.*column.share;
        text += fmt::format("  {:>9}", fmt::format("{}/{}", share.fixtures, share.of));
        if (with_samples) text += fmt::format(" {:>9}", fmt::format("{}/{}", share.all, share.of));
    }
    return text + '\n';
}

std::string percentages(std::size_t width, const Totals& totals, bool with_samples) {
    const auto percent = [](std::size_t part, std::size_t whole) {
        return whole == 0
                   ? std::string("-")
                   : fmt::format("{:.1f} %", 100 * static_cast<double>(part) / static_cast<double>(whole));
    };
    std::string text = fmt::format("{:<{}}", "", width);
    for (const Column& column : columns) {
        const Share& share = totals.*column.share;
        text += fmt::format("  {:>9}", percent(share.fixtures, share.of));
        if (with_samples) text += fmt::format(" {:>9}", percent(share.all, share.of));
    }
    return text + '\n';
}

std::string head(std::size_t width, bool with_samples) {
    std::string first = fmt::format("{:<{}}", "", width), second = fmt::format("{:<{}}", "file", width);
    for (const Column& column : columns) {
        first += fmt::format("  {:>9}", column.name);
        second += fmt::format("  {:>9}", "fixtures");
        if (!with_samples) continue;
        first += fmt::format(" {:>9}", "");
        second += fmt::format(" {:>9}", "+ random");
    }
    return first.substr(0, first.find_last_not_of(' ') + 1) + '\n' + second + '\n';
}

Json to_json(const Hits& hits) { return {{"fixtures", hits.fixtures}, {"samples", hits.samples}}; }
Json to_json(const Share& share) {
    return {{"fixtures", share.fixtures}, {"all", share.all}, {"of", share.of}};
}
Json to_json(const Totals& totals) {
    Json json;
    for (const Column& column : columns) json[column.name] = to_json(totals.*column.share);
    return json;
}

Json to_json(const FileCoverage& file) {
    Json lines = Json::array(), branches = Json::array(), functions = Json::array(),
         omissions = Json::array();
    for (const auto& [line, hits] : line_hits(file)) {
        Json entry{{"line", line}};
        entry.update(to_json(hits));
        lines.push_back(entry);
    }
    for (const Branch& branch : file.points.branches) {
        Json outcomes = Json::array();
        for (const Branch::Outcome& outcome : branch.outcomes) {
            Json entry{{"outcome", outcome.what}};
            entry.update(to_json(file.hits[outcome.counter]));
            outcomes.push_back(entry);
        }
        branches.push_back({{"line", branch.line}, {"text", branch.text}, {"outcomes", outcomes}});
    }
    for (const Function& function : file.points.functions) {
        Json entry{{"line", function.line}, {"function", function.name}};
        entry.update(to_json(file.hits[function.counter]));
        functions.push_back(entry);
    }
    for (const Omission& omission : file.points.omissions)
        omissions.push_back({{"line", omission.line}, {"why", omission.why}});
    return {{"file", file.name},    {"totals", to_json(totals(file))}, {"lines", lines},
            {"branches", branches}, {"functions", functions},          {"not_instrumented", omissions}};
}

} // namespace

std::vector<Gap> gaps(const FileCoverage& file, bool with_samples) {
    std::vector<Gap> found;
    const auto add = [&](int line, std::string what, State state, std::optional<std::size_t> counter) {
        Gap gap;
        gap.line = line;
        gap.what = std::move(what);
        gap.by_samples = state != State::never;
        if (gap.by_samples && counter)
            if (const auto replay = file.replays.find(*counter); replay != file.replays.end())
                gap.replay = replay->second;
        found.push_back(std::move(gap));
    };
    const auto state_of = [&](std::size_t counter) { return state(file.hits[counter], with_samples); };
    const auto within_gap = [&](int line) { // in a function that nobody entered
        return std::ranges::any_of(file.points.functions, [&](const Function& function) {
            return function.line <= line && line <= function.last &&
                   state_of(function.counter) == State::never;
        });
    };
    for (const Function& function : file.points.functions)
        if (const State s = state_of(function.counter); s != State::reached)
            add(function.line,
                fmt::format("`{}` was {}", function.name,
                            s == State::never ? "never entered" : "entered only by random samples"),
                s, function.counter);
    const std::map<int, Hits> lines = line_hits(file);
    const std::vector<std::string> text = trimmed_lines(file.text);
    for (const auto& [line, hits] : lines)
        if (const State s = state(hits, with_samples); s != State::reached && !within_gap(line))
            add(line,
                fmt::format("was {}: `{}`",
                            s == State::never ? "never reached" : "reached only by random samples",
                            text[static_cast<std::size_t>(line) - 1]),
                s, {});
    for (const Branch& branch : file.points.branches) {
        if (within_gap(branch.line) || state(lines.at(branch.line), with_samples) == State::never) continue;
        const auto is_never = [&](const Branch::Outcome& o) { return state_of(o.counter) == State::never; };
        if (branch.kind == Branch::Kind::condition && std::ranges::all_of(branch.outcomes, is_never)) {
            add(branch.line, fmt::format("`{}` was never asked", branch.text), State::never, {});
            continue;
        }
        for (const Branch::Outcome& outcome : branch.outcomes)
            if (const State s = state_of(outcome.counter); s != State::reached)
                add(outcome.line, of_outcome(branch, outcome, s), s, outcome.counter);
    }
    std::ranges::stable_sort(found, {}, &Gap::line);
    return found;
}

std::string to_text(const Coverage& coverage, bool missing) {
    const bool with_samples = !coverage.only_fixtures;
    std::size_t width = 12;
    for (const FileCoverage& file : coverage.files) width = std::max(width, file.name.size());
    std::string text = head(width, with_samples);
    for (const FileCoverage& file : coverage.files) text += row(file.name, width, totals(file), with_samples);
    const Totals sum = totals(coverage);
    text += row(fmt::format("{} files", coverage.files.size()), width, sum, with_samples);
    text += percentages(width, sum, with_samples);
    if (missing) {
        std::string list;
        for (const FileCoverage& file : coverage.files) {
            for (const Gap& gap : gaps(file, with_samples)) {
                list += fmt::format("{}:{}: {}\n", file.name, gap.line, gap.what);
                if (!gap.replay.empty()) list += fmt::format("    {}\n", gap.replay);
            }
            for (const Omission& omission : file.points.omissions)
                list += fmt::format("{}:{}: bears no counters: {}\n", file.name, omission.line, omission.why);
        }
        if (!list.empty()) text += '\n' + list;
    }
    for (const KernelRun& run : coverage.kernels)
        if (run.left_out > 0)
            text +=
                fmt::format("\n{}: {} counters left out: with them the driver rounds its results otherwise\n",
                            run.kernel->name, run.left_out);
    for (const KernelRun& run : coverage.kernels)
        if (!run.trouble.empty()) text += fmt::format("\nFAIL {}: {}\n", run.kernel->name, run.trouble);
    return text;
}

std::string to_json(const Coverage& coverage) {
    Json files = Json::array(), kernels = Json::array();
    for (const KernelRun& run : coverage.kernels) {
        Json entry{{"kernel", run.kernel->name}, {"fixtures", run.fixtures}, {"samples", run.samples}};
        if (run.left_out > 0) entry["counters_left_out"] = run.left_out;
        if (!run.trouble.empty()) entry["trouble"] = run.trouble;
        kernels.push_back(entry);
    }
    for (const FileCoverage& file : coverage.files) files.push_back(to_json(file));
    return Json{{"totals", to_json(totals(coverage))}, {"kernels", kernels}, {"files", files}}.dump(
        1, ' ', false, Json::error_handler_t::replace);
}

std::string to_lcov(const Coverage& coverage, const std::filesystem::path& kernels) {
    std::string text = "TN:\n";
    for (const FileCoverage& file : coverage.files) {
        if (file.is_generated()) continue;
        const Totals sums = totals(file);
        const auto hits = [&](std::size_t counter) { return file.hits[counter].all(); };
        text += fmt::format("SF:{}\n",
                            (std::filesystem::absolute(kernels) / file.name).lexically_normal().string());
        for (const Function& function : file.points.functions)
            text += fmt::format("FN:{},{}\n", function.line, function.name);
        for (const Function& function : file.points.functions)
            text += fmt::format("FNDA:{},{}\n", hits(function.counter), function.name);
        text += fmt::format("FNF:{}\nFNH:{}\n", sums.functions.of, sums.functions.all);
        for (std::size_t block = 0; block < file.points.branches.size(); ++block) {
            const Branch& branch = file.points.branches[block];
            const bool asked = std::ranges::any_of(
                branch.outcomes, [&](const Branch::Outcome& outcome) { return hits(outcome.counter) > 0; });
            for (std::size_t i = 0; i < branch.outcomes.size(); ++i)
                text += fmt::format("BRDA:{},{},{},{}\n", branch.line, block, i,
                                    asked ? fmt::format("{}", hits(branch.outcomes[i].counter)) : "-");
        }
        text += fmt::format("BRF:{}\nBRH:{}\n", sums.branches.of, sums.branches.all);
        for (const auto& [line, count] : line_hits(file))
            text += fmt::format("DA:{},{}\n", line, count.all());
        text += fmt::format("LF:{}\nLH:{}\nend_of_record\n", sums.lines.of, sums.lines.all);
    }
    return text;
}

} // namespace gnomon::coverage
