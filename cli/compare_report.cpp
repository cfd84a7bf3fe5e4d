#include "cli/compare_report.h"

#include "casegen/check.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::cli {
namespace {

using Json = nlohmann::ordered_json;
using measure::Pace;
using versus::Comparison;
using versus::SideReport;

std::string percent_of(std::size_t part, std::size_t whole) {
    return whole > 0 ? fmt::format("{:.3g} %", 100 * static_cast<double>(part) / static_cast<double>(whole))
                     : "-";
}

std::string figure(double value) {
    return std::isnan(value)   ? "NaN"
           : std::isinf(value) ? (value < 0 ? "-infinity" : "infinity")
                               : fmt::format("{:.4g}", value);
}

/// Whether the samples that differ lie all over the input's range: it has nothing to do with it.
bool is_anywhere(const versus::Whereabouts& where, std::size_t defined) {
    return where.values.size() == 1 || (where.values.empty() && where.inside == defined);
}

std::string where_text(const versus::Whereabouts& where, std::size_t differ) {
    if (!where.values.empty()) {
        std::vector<std::string> shares;
        for (const versus::ValueShare& share : where.values)
            if (share.differ > 0)
                shares.push_back(
                    fmt::format("{} ({})", share.value, percent_of(share.differ, share.samples)));
        return fmt::format("{} = {}", where.name, fmt::join(shares, ", "));
    }
    return fmt::format("{} from {} to {} of {} to {} ({} of the samples there)", where.name,
                       figure(where.from), figure(where.to), figure(where.sampled_from),
                       figure(where.sampled_to), percent_of(differ, where.inside));
}

std::string difference_text(const versus::DifferenceReport& report) {
    const versus::Difference& d = report.counts;
    if (d.differ == 0)
        return fmt::format("  output    the same bits on all {} samples{}\n", d.samples,
                           d.other_nan > 0 ? fmt::format(", but for {} NaN of other bits", d.other_nan) : "");
    std::string text = fmt::format("  output    differs on {} of {} samples ({}), {} of them in the domain\n",
                                   d.differ, d.samples, percent_of(d.differ, d.samples), d.differ_defined);
    std::vector<std::string> kinds;
    if (d.finiteness > 0) kinds.push_back(fmt::format("{} finite on one side only", d.finiteness));
    if (d.zeros > 0) kinds.push_back(fmt::format("{} only in the sign of 0", d.zeros));
    if (d.other_nan > 0)
        kinds.push_back(fmt::format("{} more are NaN on both sides, of other bits", d.other_nan));
    if (!kinds.empty()) text += fmt::format("            {}\n", fmt::join(kinds, "; "));
    text += fmt::format(
        "            worst by {}{}, at {}{}\n", figure(d.absolute),
        d.ulps > 0 ? fmt::format(" ({} ulps; at most {} anywhere)", figure(d.ulps), figure(d.most_ulps)) : "",
        report.call_a, report.worst_defined ? "" : ", outside the domain");
    text += fmt::format("            A {}, B {}{}\n", report.got_a, report.got_b,
                        report.want.empty() ? "" : ", reference " + report.want);
    text += fmt::format("            {}\n            {}\n", report.command_a, report.command_b);
    std::vector<std::string> anywhere;
    for (const versus::Whereabouts& where : d.where)
        if (is_anywhere(where, d.defined))
            anywhere.push_back(where.name);
        else
            text += fmt::format("  where     {}\n", where_text(where, d.differ_defined));
    if (!anywhere.empty())
        text += fmt::format("  where     at any {} ({} of the domain's samples)\n", fmt::join(anywhere, ", "),
                            percent_of(d.differ_defined, d.defined));
    return text;
}

std::string side_text(const char* name, const SideReport& side) {
    if (!side.ran)
        return fmt::format("  {}         {}{}\n", name, side.failure,
                           side.message.empty() ? "" : ": " + side.message);
    return fmt::format("  {}         error: median {}, 99 % {}, max {} {}; {} of {} samples fail (allowed: "
                       "{}; seed {:#x}){}\n",
                       name, format_error(side.error.median), format_error(side.error.p99),
                       format_error(side.error.most), side.unit, side.wrong, side.samples, side.allowed,
                       side.seed, side.message.empty() ? "" : "; " + side.message);
}

std::string picture_text(const versus::PictureReport& report, const std::filesystem::path& file) {
    return fmt::format(
        "  image     {}: to the right {}; downwards {}; all else as in {}\n"
        "            amber: B is larger, blue: smaller, by up to {}; pale: the same bits ({} of {} pixels "
        "differ)\n"
        "            red: finite on one side only ({}); magenta: NaN on both ({}); grey: the same, outside "
        "the "
        "domain ({} outside)\n",
        file.string(), report.across, report.down, report.rest, figure(report.scale), report.differ,
        report.pixels, report.finiteness, report.both_nan, report.outside);
}

std::string interval_text(const measure::Interval& interval) {
    return fmt::format("{:.3f} to {:.3f}", interval.lower, interval.upper);
}

std::string time_text(const measure::Pairing& time) {
    const measure::PaceVerdict& v = time.verdict;
    const std::string meaning = v.pace == Pace::uncertain ? fmt::format(" ({})", v.reason)
                                                          : fmt::format(" (margin {:.3g} %)", v.margin * 100);
    const std::string floor =
        v.with_floor ? fmt::format(" with {:.3g} ns of reading, nearly all of the shorter", time.floor) : "";
    return fmt::format("  time      A {:.4g} ns, B {:.4g} ns a call{}: {}{}\n"
                       "            B/A = {:.3f}, with {:.4g} % confidence {}; A/A = {:.3f}, {}; {} rounds\n",
                       time.a + (v.with_floor ? time.floor : 0), time.b + (v.with_floor ? time.floor : 0),
                       floor, to_string(v.pace), meaning, v.ratio, v.confidence * 100,
                       interval_text(v.interval), v.again, interval_text(v.calibration), v.rounds);
}

std::string comparison_text(const CompareHead& head, const Comparison& one) {
    std::string text = fmt::format("{}\n", one.name);
    if (one.compared) text += difference_text(one.difference);
    text += side_text("A", one.a) + side_text("B", one.b);
    text += fmt::format("  accuracy  {}\n", accuracy_verdict(one));
    if (!head.image.empty())
        text += one.drawn ? picture_text(one.picture, head.image)
                          : fmt::format("  image     none: {}\n", one.not_drawn);
    if (head.times)
        text += one.timed ? time_text(one.time) : fmt::format("  time      none: {}\n", one.not_timed);
    return text + '\n';
}

std::string word_of(const SideReport& side) { return is_right(side) ? "right" : side.failure; }

std::string table_text(const CompareHead& head, const std::vector<Comparison>& all) {
    std::vector<std::array<std::string, 7>> rows{
        {"kernel", "differ", "worst", "A", "B", "max error", "time B/A"}};
    for (const Comparison& one : all) {
        const versus::Difference& d = one.difference.counts;
        const measure::PaceVerdict& v = one.time.verdict;
        std::array<std::string, 7> row;
        row[0] = one.name;
        row[1] = one.compared ? percent_of(d.differ, d.samples) : "-";
        row[2] = one.compared ? figure(d.absolute) : "-";
        row[3] = word_of(one.a);
        row[4] = word_of(one.b);
        row[5] = one.a.ran && one.b.ran
                     ? fmt::format("{} → {}", format_error(one.a.error.most), format_error(one.b.error.most))
                     : "-";
        row[6] = one.timed ? fmt::format("{:.3f} {}", v.ratio, to_string(v.pace)) : head.times ? "none" : "-";
        rows.push_back(std::move(row));
    }
    std::array<std::size_t, 7> widths{};
    const auto width = [](const std::string& cell) { // code points
        return static_cast<std::size_t>(std::ranges::count_if(
            cell, [](char ch) { return (static_cast<unsigned char>(ch) & 0xc0u) != 0x80u; }));
    };
    for (const auto& row : rows)
        for (std::size_t k = 0; k < row.size(); ++k) widths[k] = std::max(widths[k], width(row[k]));
    std::string text;
    for (const auto& row : rows) {
        for (std::size_t k = 0; k + 1 < row.size(); ++k)
            text += row[k] + std::string(widths[k] - width(row[k]) + 2, ' ');
        text += row.back() + '\n';
    }
    return text;
}

Json finite(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json json_of(const measure::Interval& interval) { return {finite(interval.lower), finite(interval.upper)}; }

Json json_of(const SideReport& side) {
    Json object{{"right", is_right(side)}, {"failure", side.failure}};
    if (!side.message.empty()) object["message"] = side.message;
    object["allowed"] = side.allowed;
    if (side.ran)
        object["error"] = {{"unit", side.unit},
                           {"median", finite(side.error.median)},
                           {"p99", finite(side.error.p99)},
                           {"max", finite(side.error.most)}};
    if (side.ran) {
        object["failing"] = side.wrong;
        object["seed"] = fmt::format("{:#018x}", side.seed);
    }
    return object;
}

Json json_of(const versus::DifferenceReport& report) {
    const versus::Difference& d = report.counts;
    Json object{{"samples", d.samples},
                {"in_domain", d.defined},
                {"differ", d.differ},
                {"differ_in_domain", d.differ_defined},
                {"finite_on_one_side", d.finiteness},
                {"sign_of_zero", d.zeros},
                {"nan_of_other_bits", d.other_nan},
                {"wrong_where_a_is_right", report.lost}};
    if (d.differ == 0) return object;
    object["worst"] = {{"absolute", finite(d.absolute)},
                       {"ulps", finite(d.ulps)},
                       {"in_domain", report.worst_defined},
                       {"call_a", report.call_a},
                       {"call_b", report.call_b},
                       {"a", report.got_a},
                       {"b", report.got_b},
                       {"reference", report.want},
                       {"replay_a", report.command_a},
                       {"replay_b", report.command_b}};
    object["most_ulps"] = finite(d.most_ulps);
    object["where"] = Json::array();
    for (const versus::Whereabouts& where : d.where) {
        Json place{{"input", where.name}};
        if (where.values.empty()) {
            place["from"] = finite(where.from);
            place["to"] = finite(where.to);
            place["samples_inside"] = where.inside;
        } else {
            place["values"] = Json::array();
            for (const versus::ValueShare& share : where.values)
                place["values"].push_back(
                    {{"value", share.value}, {"samples", share.samples}, {"differ", share.differ}});
        }
        object["where"].push_back(std::move(place));
    }
    return object;
}

Json json_of(const measure::Pairing& time) {
    const measure::PaceVerdict& v = time.verdict;
    Json object{
        {"verdict", to_string(v.pace)}, {"ratio", finite(v.ratio)}, {"interval", json_of(v.interval)}};
    object["confidence"] = v.confidence;
    object["again"] = finite(v.again);
    object["calibration"] = json_of(v.calibration);
    object["margin"] = finite(v.margin);
    object["with_reading"] = v.with_floor;
    object["rounds"] = v.rounds;
    if (!v.reason.empty()) object["reason"] = v.reason;
    object["nanoseconds"] = {{"a", time.a}, {"b", time.b}, {"reading", time.floor}};
    return object;
}

} // namespace

std::string compare_text(const CompareHead& head, const versus::Plan& plan,
                         const versus::VersusReport& report) {
    std::string text = fmt::format("A = {}\nB = {}\n\n", head.a, head.b);
    for (const Comparison& one : report.comparisons) text += comparison_text(head, one);
    if (!report.comparisons.empty()) text += table_text(head, report.comparisons) + '\n';
    const auto list = [&](const std::vector<std::string>& names, const char* what) {
        if (!names.empty()) text += fmt::format("{}: {}\n", what, fmt::join(names, ", "));
    };
    list(plan.only_a, "only in A");
    list(plan.only_b, "only in B");
    list(plan.others, "stages that differ, which are not compared");
    text += plan.named ? fmt::format("{} compared\n", report.comparisons.size())
                       : fmt::format("{} compared; {} are the same code and were not run\n",
                                     report.comparisons.size(), report.same);
    return text;
}

std::string compare_json(const CompareHead& head, const versus::Plan& plan,
                         const versus::VersusReport& report) {
    Json kernels = Json::array();
    for (const Comparison& one : report.comparisons) {
        Json object{{"kernel", one.name}, {"a", json_of(one.a)}, {"b", json_of(one.b)}};
        object["accuracy"] = accuracy_verdict(one);
        if (one.compared) object["difference"] = json_of(one.difference);
        if (one.timed) object["time"] = json_of(one.time);
        if (head.times && !one.timed) object["not_timed"] = one.not_timed;
        if (one.drawn)
            object["image"] = {{"file", head.image.string()},      {"across", one.picture.across},
                               {"down", one.picture.down},         {"rest", one.picture.rest},
                               {"scale", one.picture.scale},       {"pixels", one.picture.pixels},
                               {"differ", one.picture.differ},     {"not_finite", one.picture.finiteness},
                               {"both_nan", one.picture.both_nan}, {"outside_domain", one.picture.outside}};
        kernels.push_back(std::move(object));
    }
    return Json{{"a", head.a},
                {"b", head.b},
                {"kernels", std::move(kernels)},
                {"same", report.same},
                {"only_a", plan.only_a},
                {"only_b", plan.only_b},
                {"other_stages", plan.others}}
        .dump(2, ' ', false, Json::error_handler_t::replace);
}

} // namespace gnomon::cli
