#include "casegen/measure/hybrid/tables.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::measure {
namespace {

using Json = nlohmann::ordered_json;

/// Of all techniques, in the order in which they first happen; building the BVH is not a frame's.
std::vector<std::string> steps_of(const std::vector<HybridRow>& rows) {
    // The longest first: a technique without maps has fewer steps, in the same order.
    std::vector<const HybridRow*> by_length;
    for (const HybridRow& row : rows) by_length.push_back(&row);
    std::ranges::stable_sort(by_length, std::greater{},
                             [](const HybridRow* r) { return r->times.steps.size(); });
    std::vector<std::string> names;
    for (const HybridRow* row : by_length)
        for (const gnomon::Step& step : row->times.steps)
            if (step.name != "build BVH" && std::ranges::find(names, step.name) == names.end())
                names.push_back(step.name);
    return names;
}

const gnomon::Step* step_called(const HybridRow& row, const std::string& name) {
    const auto found = std::ranges::find(row.times.steps, name, &gnomon::Step::name);
    return found == row.times.steps.end() ? nullptr : &*found;
}

std::string ratio(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "inf"; }

std::string nanoseconds(double value) {
    return std::isinf(value) ? "inf" : fmt::format("{:.{}f}", value, value < 10 ? 1 : 0);
}

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

/// How far auto is from the best exact technique of the same rounds.
double auto_ratio(const HybridCombination& c) {
    return c.automatic()->times.milliseconds / c.best_exact().times.milliseconds;
}

Json json_of(const HybridRow& row, double raytraced) {
    Json steps = Json::object();
    for (const gnomon::Step& step : row.times.steps) steps[step.name] = step.milliseconds;
    Json left_out = Json::array();
    for (const LeftOut& left : row.times.frame.left_out)
        left_out.push_back({{"step", left.step}, {"what", left.what}, {"why", left.why}});
    return {{"technique", row.technique},
            {"exact", row.exact},
            {"milliseconds", row.times.milliseconds},
            {"least", row.times.least},
            {"most", row.times.most},
            {"over_raytraced", number(row.times.milliseconds / raytraced)},
            {"steps", std::move(steps)},
            {"rays", row.times.frame.rays},
            {"uncertain_share", row.uncertain_share()},
            {"triangles_emitted", row.times.frame.maps.triangles_emitted},
            {"bytes_per_texel", row.times.frame.maps.bytes_per_texel},
            {"wrong_pixels", row.wrong},
            {"nanoseconds_per_ray", row.cost().per_ray()},
            {"break_even_nanoseconds_per_ray", number(row.break_even)},
            {"left_out", std::move(left_out)}};
}

} // namespace

Table hybrid_table(const HybridCombination& c) {
    Table table;
    table.title = fmt::format("{}x{}, shadow map {}", c.width, c.height, c.shadow_map);
    const HybridRow& raytraced = c.rows.front();
    const double whole = raytraced.times.milliseconds;
    table.notes.push_back(
        fmt::format("{} pixels face the light; raytraced takes {:.2f} ms, {:.1f} ns of tracing "
                    "per ray; the BVH took {:.1f} ms",
                    c.facing, whole, raytraced.cost().per_ray(), c.bvh));
    const std::vector<std::string> steps = steps_of(c.rows);
    table.header = {"technique"};
    table.header.insert(table.header.end(), steps.begin(), steps.end());
    for (const char* name : {"whole", "ms", "uncertain %", "rays", "triangles", "bytes/texel", "ns/ray",
                             "pays from ns/ray", "wrong"})
        table.header.emplace_back(name);
    for (const HybridRow& row : c.rows) {
        std::vector<std::string> cells{row.technique};
        for (const std::string& name : steps) {
            const gnomon::Step* step = step_called(row, name);
            cells.push_back(step == nullptr ? "-" : ratio(step->milliseconds / whole));
        }
        const HybridFrame& frame = row.times.frame;
        cells.push_back(ratio(row.times.milliseconds / whole));
        cells.push_back(fmt::format("{:.2f}", row.times.milliseconds));
        cells.push_back(fmt::format("{:.3f}", 100 * row.uncertain_share()));
        cells.push_back(std::to_string(frame.rays));
        cells.push_back(std::to_string(frame.maps.triangles_emitted));
        cells.push_back(fmt::format("{:.1f}", frame.maps.bytes_per_texel));
        cells.push_back(frame.rays == 0 ? "-" : nanoseconds(row.cost().per_ray()));
        const bool saves_none = frame.rays == raytraced.times.frame.rays; // auto may be raytraced
        cells.push_back(saves_none ? "-" : nanoseconds(row.break_even));
        cells.push_back(std::to_string(row.wrong));
        table.rows.push_back(std::move(cells));
    }
    if (c.automatic() && c.choice)
        table.notes.push_back(fmt::format(
            "auto takes {}: {:.2f} of the best exact technique, {}; calibration took "
            "{:.0f} ms",
            shown_name(c.choice->name()), auto_ratio(c), c.best_exact().technique, c.choice->milliseconds));
    return table;
}

std::vector<std::string> remarks(const HybridBench& bench) {
    return {
        fmt::format("{}: {} triangles; {}.", bench.scene, bench.triangles, bench.machine),
        fmt::format(
            "Steps and whole frames are parts of raytraced's frame: a ray for every pixel that faces the "
            "light, in packets of 16. Medians of {} rounds in which all techniques took turns over one "
            "G-buffer; a first round is discarded.",
            bench.rounds),
        "Uncertain: pixels that need a ray, of those that face the light. Wrong: pixels whose visibility is "
        "not "
        "the ray tracer's.",
        "Pays from: the cost of one ray above which the technique is faster than raytraced; beside it what "
        "one of "
        "its own rays took. inf: it saves no ray.",
    };
}

std::string to_text(const HybridBench& bench) {
    std::string text;
    for (const HybridCombination& c : bench.combinations) text += to_text(hybrid_table(c)) + "\n";
    for (const std::string& remark : remarks(bench)) text += remark + "\n";
    return text;
}

std::string hybrid_csv(const HybridBench& bench) {
    std::string text = "width,height,shadow_map,technique,exact,milliseconds,over_raytraced,facing,rays,"
                       "triangles_emitted,bytes_per_texel,wrong_pixels,nanoseconds_per_ray,"
                       "break_even_nanoseconds_per_ray\n";
    for (const HybridCombination& c : bench.combinations)
        for (const HybridRow& row : c.rows)
            text += fmt::format(
                "{},{},{},{},{},{:.6g},{:.6g},{},{},{},{:.6g},{},{:.6g},{:.6g}\n", c.width, c.height,
                c.shadow_map, row.technique, row.exact ? 1 : 0, row.times.milliseconds,
                row.times.milliseconds / c.rows.front().times.milliseconds, c.facing, row.times.frame.rays,
                row.times.frame.maps.triangles_emitted, row.times.frame.maps.bytes_per_texel, row.wrong,
                row.cost().per_ray(), row.break_even);
    return text;
}

std::string hybrid_json(const HybridBench& bench) {
    Json combinations = Json::array();
    for (const HybridCombination& c : bench.combinations) {
        Json techniques = Json::array();
        for (const HybridRow& row : c.rows)
            techniques.push_back(json_of(row, c.rows.front().times.milliseconds));
        Json json{{"size", {c.width, c.height}},
                  {"shadow_map", c.shadow_map},
                  {"facing", c.facing},
                  {"bvh_milliseconds", c.bvh},
                  {"techniques", std::move(techniques)}};
        if (c.automatic() && c.choice)
            json["auto"] = {{"chosen", shown_name(c.choice->name())},
                            {"best_exact", c.best_exact().technique},
                            {"over_best_exact", number(auto_ratio(c))},
                            {"calibration_milliseconds", c.choice->milliseconds}};
        combinations.push_back(std::move(json));
    }
    return Json{{"gnomon", GNOMON_VERSION}, {"machine", bench.machine},
                {"scene", bench.scene},     {"triangles", bench.triangles},
                {"rounds", bench.rounds},   {"combinations", std::move(combinations)}}
               .dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

} // namespace gnomon::measure
