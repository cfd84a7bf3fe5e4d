#include "cli/watch_report.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::cli {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t name_width = 24;

std::string name_of(const Case& c) { return fmt::format("{:<{}}", c.name, name_width); }

std::string duration(double milliseconds) {
    return milliseconds < 10000 ? fmt::format("{:.0f} ms", milliseconds)
                                : fmt::format("{:.1f} s", milliseconds / 1000);
}

/// "0 -> 0.5 of exact", "0.5 of exact".
std::string errors_text(const watch::Judged& told) {
    const watch::Judgement& j = told.judgement;
    if (!j.worst) return {};
    const bool changed = told.worst_before && *told.worst_before != *j.worst;
    return fmt::format("worst error {}{}, allowed {}",
                       changed ? format_error(*told.worst_before) + " -> " : "", format_error(*j.worst),
                       to_string(told.kernel->tolerance));
}

std::string moved_text(const watch::Judgement& j) {
    if (!j.moved) return {};
    if (j.moved->samples == 0) return "no result moved";
    const std::string most = std::isfinite(j.moved->largest)
                                 ? fmt::format("by at most {:.3g}", j.moved->largest)
                                 : "to or from what is no number";
    return fmt::format("{} of {} results moved, {}", j.moved->samples, j.samples, most);
}

std::string text_of(const watch::Began& told, const std::string& folder) {
    return fmt::format("watching {} kernel{} below {} with {} worker{}{}; Ctrl-C ends\n", told.kernels,
                       told.kernels == 1 ? "" : "s", folder, told.workers, told.workers == 1 ? "" : "s",
                       told.polls ? ", looking every 0.1 s" : "");
}

std::string text_of(const watch::Judged& told, bool colours) {
    const watch::Judgement& j = told.judgement;
    if (told.edit == 0 && j.good) return {};
    std::string verdict = j.good ? (j.verdict == "pass" ? "pass" : "expected")
                                 : fmt::format("FAIL ({})", j.cannot.empty() ? j.verdict : "not checked");
    if (colours) verdict = fmt::format("\x1b[1;{}m{}\x1b[0m", j.good ? 32 : 31, verdict);
    std::string line = name_of(*told.kernel) + ' ' + verdict;
    for (const std::string& part : {errors_text(told), moved_text(j)})
        if (!part.empty()) line += "; " + part;
    std::string text = fmt::format("{} [{}]\n", line, duration(told.milliseconds));
    if (j.moved && j.moved->samples > 0)
        text += fmt::format("  most at {}: {} -> {}\n", j.moved->call, j.moved->before, j.moved->after);
    if (!j.cannot.empty()) text += fmt::format("  {}\n", j.cannot);
    for (const std::string& explained : j.explanation) text += fmt::format("  {}\n", explained);
    return text;
}

std::string text_of(const watch::SameCode& told) {
    return fmt::format("{} same code: nothing to run; {} [{}]\n", name_of(*told.kernel),
                       told.good ? "good as before" : "wrong as before", duration(told.milliseconds));
}

std::string text_of(const watch::Timed& told) {
    const measure::PaceVerdict& pace = told.pace;
    const double off = told.with_reading ? 0 : told.reading;
    std::string text = fmt::format(
        "{} {:.2f} -> {:.2f} ns per evaluation{}: {} (x {:.2f}, from {:.2f} to {:.2f}){}\n",
        name_of(*told.kernel), told.before - off, std::max(0.0, told.after - off),
        told.with_reading ? ", reading its inputs included" : "", measure::to_string(pace.pace), pace.ratio,
        pace.interval.lower, pace.interval.upper, pace.reason.empty() ? "" : "; " + pace.reason);
    if (!told.same_results)
        text += fmt::format("  optimised code has other results than those judged: gnomon check {}\n",
                            told.kernel->name);
    return text;
}

std::string text_of(const watch::NotTimed& told) {
    return fmt::format("{} not timed: {}\n", name_of(*told.kernel), told.why);
}

std::string text_of(const watch::Settled& told) {
    if (told.edit > 0 && told.judged + told.same == 1) return {};
    std::string of_edit = fmt::format("{} checked", told.judged);
    if (told.same > 0) of_edit += fmt::format(", {} of the same code", told.same);
    return fmt::format("{}: {} good, {} not [{}]\n", of_edit, told.good, told.bad,
                       duration(told.milliseconds));
}

/// JSON has no infinity and no NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json json_of(const watch::Began& told, const std::string& folder) {
    return {{"event", "watching"},
            {"folder", folder},
            {"kernels", told.kernels},
            {"workers", told.workers},
            {"polls", told.polls}};
}

Json json_of(const watch::Judged& told) {
    const watch::Judgement& j = told.judgement;
    Json json{{"event", "verdict"},
              {"edit", told.edit},
              {"kernel", told.kernel->name},
              {"verdict", j.cannot.empty() ? j.verdict : "not checked"},
              {"good", j.good},
              {"samples", j.samples},
              {"failures", j.failures},
              {"worst_error", number(j.worst)},
              {"worst_error_before", number(told.worst_before)},
              {"allowed", to_string(told.kernel->tolerance)}};
    if (const std::string& message = j.cannot.empty() ? j.message : j.cannot; !message.empty())
        json["message"] = message;
    if (!j.worst_call.empty()) {
        json["worst_call"] = j.worst_call;
        json["got"] = j.got;
        if (!j.want.empty()) json["want"] = j.want;
        json["replay"] = j.replay;
    }
    if (!j.explanation.empty()) json["explanation"] = j.explanation;
    if (j.moved) {
        json["moved"] = {{"samples", j.moved->samples}, {"largest", number(j.moved->largest)}};
        if (j.moved->samples > 0) {
            json["moved"]["call"] = j.moved->call;
            json["moved"]["before"] = j.moved->before;
            json["moved"]["after"] = j.moved->after;
        }
    }
    json["milliseconds"] = told.milliseconds;
    return json;
}

Json json_of(const watch::SameCode& told) {
    return {{"event", "same_code"},
            {"edit", told.edit},
            {"kernel", told.kernel->name},
            {"good", told.good},
            {"milliseconds", told.milliseconds}};
}

Json json_of(const watch::Timed& told) {
    const measure::PaceVerdict& pace = told.pace;
    return {{"event", "time"},
            {"edit", told.edit},
            {"kernel", told.kernel->name},
            {"nanoseconds_before", told.before},
            {"nanoseconds_after", told.after},
            {"nanoseconds_reading", told.reading},
            {"pace_includes_reading", told.with_reading},
            {"pace", measure::to_string(pace.pace)},
            {"ratio", number(pace.ratio)},
            {"ratio_from", number(pace.interval.lower)},
            {"ratio_to", number(pace.interval.upper)},
            {"confidence", pace.confidence},
            {"same_results_when_optimised", told.same_results}};
}

Json json_of(const watch::NotTimed& told) {
    return {
        {"event", "not_timed"}, {"edit", told.edit}, {"kernel", told.kernel->name}, {"message", told.why}};
}

Json json_of(const watch::Settled& told) {
    return {{"event", "settled"},
            {"edit", told.edit},
            {"checked", told.judged},
            {"same_code", told.same},
            {"good", told.good},
            {"bad", told.bad},
            {"milliseconds", told.milliseconds}};
}

} // namespace

std::string watch_text(const watch::Event& event, const std::string& folder, bool colours) {
    return std::visit(
        [&](const auto& told) {
            using Told = std::decay_t<decltype(told)>;
            if constexpr (std::is_same_v<Told, watch::Began>)
                return text_of(told, folder);
            else if constexpr (std::is_same_v<Told, watch::Judged>)
                return text_of(told, colours);
            else
                return text_of(told);
        },
        event);
}

std::string watch_json(const watch::Event& event, const std::string& folder) {
    const Json json = std::visit(
        [&](const auto& told) {
            if constexpr (std::is_same_v<std::decay_t<decltype(told)>, watch::Began>)
                return json_of(told, folder);
            else
                return json_of(told);
        },
        event);
    return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

} // namespace gnomon::cli
