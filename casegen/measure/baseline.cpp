#include "casegen/measure/baseline.h"

#include "casegen/measure/json_reading.h"
#include "casegen/measure/yardstick.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"

#include <cmath>
#include <fmt/format.h>
#include <set>

namespace gnomon::measure {
namespace {

using Json = nlohmann::ordered_json;
constexpr int format = 1;
constexpr double infinity = std::numeric_limits<double>::infinity();

Json json_of(const Quantiles& q) {
    return {{"median", number_or_null(q.median)},
            {"p99", number_or_null(q.p99)},
            {"max", number_or_null(q.most)},
            {"not_finite", q.non_finite}};
}

/// Four digits: more would be noise in a file that people compare.
double rounded(double value) {
    return std::isfinite(value) ? std::stod(fmt::format("{:.4g}", value)) : value;
}

void add_time(Json& json, const std::optional<TimeRecord>& time) {
    if (!time) return;
    json["time"] = {{"ratio", number_or_null(rounded(time->ratio.median))},
                    {"lower", number_or_null(rounded(time->ratio.interval.lower))},
                    {"upper", number_or_null(rounded(time->ratio.interval.upper))},
                    {"noise", number_or_null(rounded(time->noise))}};
}

Json json_of(const KernelRecord& kernel) {
    Json json{{"kernel", kernel.name},
              {"unit", kernel.unit},
              {"inputs", kernel.inputs},
              {"error", json_of(kernel.error)}};
    if (kernel.over_limit) json["over_limit"] = json_of(*kernel.over_limit);
    json["instructions"] = kernel.instructions;
    add_time(json, kernel.time);
    return json;
}

Json json_of(const TechniqueRecord& technique) {
    Json json{{"technique", technique.name},
              {"wrong_lit", technique.wrong_lit},
              {"wrong_shadowed", technique.wrong_shadowed},
              {"rmse", number_or_null(technique.rmse)}};
    add_time(json, technique.time);
    return json;
}

template <typename Items>
std::string lines_of(const Items& items, const char* indent) {
    std::string text;
    for (const auto& item : items)
        text += fmt::format("{}\n{}{}", text.empty() ? "" : ",", indent, json_of(item).dump());
    return text;
}

/// What a tolerance counts in: see KernelRecord::step.
double step_of(const Case& c) {
    switch (c.tolerance.kind) {
    case Tolerance::Kind::exact:
        break;
    case Tolerance::Kind::ulps:
    case Tolerance::Kind::conditioned:
        return 1;
    case Tolerance::Kind::absolute:
    case Tolerance::Kind::input_within:
        return c.tolerance.amount;
    }
    return 0;
}

Quantiles quantiles_of(const Json& json, const char* name, const std::string& at) {
    const Json& value = member(json, name, at);
    const std::string here = fmt::format("{}, \"{}\"", at, name);
    Quantiles q;
    q.median = number_member(value, "median", here);
    q.p99 = number_member(value, "p99", here);
    q.most = number_member(value, "max", here);
    q.non_finite = count_member(value, "not_finite", here);
    return q;
}

std::optional<TimeRecord> time_of(const Json& json, const std::string& at) {
    if (!json.contains("time")) return {};
    const Json& value = json["time"];
    const std::string here = at + ", \"time\"";
    TimeRecord time;
    time.ratio.median = number_member(value, "ratio", here);
    time.ratio.interval.lower = number_member(value, "lower", here);
    time.ratio.interval.upper = number_member(value, "upper", here);
    time.noise = number_member(value, "noise", here);
    // Of an interval that reaches from -infinity to infinity both ends are null.
    if (std::isinf(time.ratio.interval.lower)) time.ratio.interval.lower = -infinity;
    return time;
}

KernelRecord kernel_of(const Json& json, const std::string& at) {
    KernelRecord kernel;
    kernel.name = text_member(json, "kernel", at);
    const std::string here = fmt::format("{}, kernel {}", at, kernel.name);
    kernel.unit = text_member(json, "unit", here);
    kernel.inputs = count_member(json, "inputs", here);
    kernel.error = quantiles_of(json, "error", here);
    if (json.contains("over_limit")) kernel.over_limit = quantiles_of(json, "over_limit", here);
    kernel.instructions = count_member(json, "instructions", here);
    kernel.time = time_of(json, here);
    return kernel;
}

TechniqueRecord technique_of(const Json& json, const std::string& at) {
    TechniqueRecord technique;
    technique.name = text_member(json, "technique", at);
    const std::string here = fmt::format("{}, technique {}", at, technique.name);
    technique.wrong_lit = count_member(json, "wrong_lit", here);
    technique.wrong_shadowed = count_member(json, "wrong_shadowed", here);
    technique.rmse = number_member(json, "rmse", here);
    technique.time = time_of(json, here);
    return technique;
}

SceneRecord scene_of(const Json& json, const std::string& at) {
    SceneRecord scene;
    scene.scene = text_member(json, "scene", at);
    const std::string here = fmt::format("{}, scene {}", at, one_line(scene.scene));
    scene.width = static_cast<int>(std::min<std::uint64_t>(count_member(json, "width", here), 1 << 20));
    scene.height = static_cast<int>(std::min<std::uint64_t>(count_member(json, "height", here), 1 << 20));
    scene.shadow_map =
        static_cast<int>(std::min<std::uint64_t>(count_member(json, "shadow_map", here), 1 << 20));
    scene.facing = count_member(json, "facing_light", here);
    scene.yardstick = text_member(json, "yardstick", here);
    std::set<std::string> names;
    for (const Json& technique : list_member(json, "techniques", here)) {
        scene.techniques.push_back(technique_of(technique, here));
        if (!names.insert(scene.techniques.back().name).second)
            throw Error("{}: technique {} is there twice", here, scene.techniques.back().name);
    }
    return scene;
}

} // namespace

Baseline baseline_of(const Bench& bench, std::span<const SceneResult> scenes) {
    Baseline baseline;
    baseline.machine = bench.machine;
    baseline.driver = bench.driver;
    baseline.compiler = bench.compiler;
    baseline.samples = bench.options.samples;
    baseline.repeats = bench.options.repeats;
    baseline.seed = bench.options.seed;
    baseline.rounds = bench.options.rounds;
    baseline.yardstick = Yardstick::fingerprint();
    for (const GroupResult& result : bench.groups)
        for (std::size_t n = 0; n < result.group.variants.size(); ++n) {
            const Variant& variant = result.group.variants[n];
            KernelRecord kernel;
            kernel.name = full_name(variant);
            kernel.unit = result.unit;
            kernel.inputs = result.inputs;
            kernel.error = result.accuracy[n].all.of_scale;
            if (result.has_limit) kernel.over_limit = result.accuracy[n].all.of_limit;
            kernel.instructions = result.instructions[n];
            kernel.step = step_of(*variant.kernel);
            if (!result.timings.empty())
                kernel.time = TimeRecord{result.timings.back().variants[n].over_yardstick,
                                         result.timings.back().noise()};
            baseline.kernels.push_back(std::move(kernel));
        }
    for (const SceneResult& result : scenes) {
        SceneRecord scene;
        scene.scene = result.view.scene;
        scene.width = result.view.settings.width;
        scene.height = result.view.settings.height;
        scene.shadow_map = result.view.settings.shadow_map;
        scene.yardstick = result.yardstick;
        for (const FrameRow& row : result.rows) {
            TechniqueRecord technique;
            technique.name = row.technique;
            technique.wrong_lit = row.counts.wrong_lit;
            technique.wrong_shadowed = row.counts.wrong_shadowed;
            technique.rmse = row.rmse;
            if (!row.times.rounds.empty()) technique.time = TimeRecord{row.over_yardstick, result.noise};
            scene.facing = row.counts.facing;
            scene.techniques.push_back(std::move(technique));
        }
        baseline.scenes.push_back(std::move(scene));
    }
    return baseline;
}

std::string to_json(const Baseline& baseline) {
    Json head{{"format", format},
              {"gnomon", GNOMON_VERSION},
              {"machine", baseline.machine},
              {"driver", baseline.driver},
              {"compiler", baseline.compiler},
              {"samples", baseline.samples},
              {"repeats", baseline.repeats},
              {"seed", baseline.seed ? Json(*baseline.seed) : Json(nullptr)},
              {"rounds", baseline.rounds},
              {"yardstick", baseline.yardstick}};
    std::string text = head.dump(2, ' ', false, Json::error_handler_t::replace);
    text.resize(text.size() - 2); // "\n}"
    text += fmt::format(",\n  \"kernels\": [{}\n  ],\n  \"scenes\": [", lines_of(baseline.kernels, "    "));
    for (std::size_t i = 0; i < baseline.scenes.size(); ++i) {
        const SceneRecord& scene = baseline.scenes[i];
        std::string line = Json{{"scene", scene.scene},         {"width", scene.width},
                                {"height", scene.height},       {"shadow_map", scene.shadow_map},
                                {"facing_light", scene.facing}, {"yardstick", scene.yardstick}}
                               .dump(-1, ' ', false, Json::error_handler_t::replace);
        line.pop_back();
        text += fmt::format("{}\n    {}, \"techniques\": [{}\n    ]}}", i > 0 ? "," : "", line,
                            lines_of(scene.techniques, "      "));
    }
    return text + "\n  ]\n}\n";
}

Baseline parse_baseline(const std::string& text, const std::string& name) {
    const Json json = parse_json(text, name);
    if (!json.is_object() || !json.contains("format") || !json["format"].is_number_integer())
        throw Error("{}: is not a baseline of gnomon bench; write one with gnomon bench --save {}", name,
                    name);
    if (json["format"] != format)
        throw Error("{}: is a baseline of format {}; this gnomon reads {}: write it anew with --save", name,
                    json["format"].dump(), format);
    Baseline baseline;
    baseline.machine = text_member(json, "machine", name);
    baseline.driver = text_member(json, "driver", name);
    baseline.compiler = text_member(json, "compiler", name);
    baseline.samples = count_member(json, "samples", name);
    baseline.repeats = count_member(json, "repeats", name);
    if (!member(json, "seed", name).is_null()) baseline.seed = count_member(json, "seed", name);
    baseline.rounds = static_cast<unsigned>(count_member(json, "rounds", name));
    baseline.yardstick = count_member(json, "yardstick", name);
    std::set<std::string> names;
    for (const Json& kernel : list_member(json, "kernels", name)) {
        baseline.kernels.push_back(kernel_of(kernel, name));
        if (!names.insert(baseline.kernels.back().name).second)
            throw Error("{}: kernel {} is there twice", name, baseline.kernels.back().name);
    }
    names.clear();
    for (const Json& scene : list_member(json, "scenes", name)) {
        baseline.scenes.push_back(scene_of(scene, name));
        if (!names.insert(baseline.scenes.back().scene).second)
            throw Error("{}: scene {} is there twice", name, baseline.scenes.back().scene);
    }
    return baseline;
}

Baseline read_baseline(const std::filesystem::path& path) {
    return parse_baseline(read_file(path), path.string());
}

} // namespace gnomon::measure
