#include "cli/rendering.h"

#include "casegen/technique.h"
#include "cli/view.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace gnomon::cli {
namespace {

/// Steps that every technique takes alike; BVH building is once per scene, as uploading is.
bool is_shared(const std::string& step) {
    constexpr std::array shared{"g-buffer", "receivers", "fit light", "shade", "build BVH"};
    return std::ranges::find(shared, step) != shared.end();
}

nlohmann::ordered_json vector_json(glm::vec3 v) { return {v.x, v.y, v.z}; }

} // namespace

std::vector<std::string> technique_names() {
    std::vector<std::string> names{"none"};
    for (std::string& name : visibility_techniques()) names.push_back(std::move(name));
    names.emplace_back("raytraced");
    for (const HybridTechnique& hybrid : hybrid_techniques()) names.push_back(hybrid.name);
    names.emplace_back("auto");
    return names;
}

Technique technique_by_name(const std::string& name) {
    if (name == "none") return {Technique::Kind::none, name};
    if (name == "raytraced") return {Technique::Kind::raytraced, name};
    if (find_hybrid(name)) return {Technique::Kind::hybrid, name};
    if (name == "auto") return {Technique::Kind::automatic, name};
    return technique_of(technique_family(name));
}

double Judged::visibility_milliseconds() const {
    double sum = 0;
    for (const Step& step : rendering.steps)
        if (!is_shared(step.name)) sum += step.milliseconds;
    return sum;
}

std::string judged_table(const std::vector<Judged>& all) {
    std::string text = fmt::format("{:<12}  {:>12}  {:>14}  {:>8}  {:>15}\n", "technique", "wrongly lit",
                                   "wrongly shadow", "error", "visibility time");
    for (const Judged& j : all)
        text +=
            fmt::format("{:<12}  {:>12}  {:>14}  {:>7.3f}%  {:>12.2f} ms\n", j.technique, j.counts.wrong_lit,
                        j.counts.wrong_shadowed, 100 * j.counts.wrong_share(), j.visibility_milliseconds());
    return text;
}

nlohmann::ordered_json judged_json(const Judged& judged) {
    nlohmann::ordered_json steps = nlohmann::ordered_json::object();
    for (const Step& step : judged.rendering.steps) steps[step.name] = step.milliseconds;
    const PixelCounts& c = judged.counts;
    return {{"technique", judged.technique},
            {"milliseconds", steps},
            {"visibility_milliseconds", judged.visibility_milliseconds()},
            {"pixels",
             {{"all", c.all},
              {"covered", c.covered},
              {"facing_light", c.facing},
              {"facing_away", c.facing_away},
              {"lit_by_truth", c.truly_lit},
              {"shadowed_by_truth", c.truly_shadowed},
              {"wrong_lit", c.wrong_lit},
              {"wrong_shadowed", c.wrong_shadowed},
              {"wrong_share_of_facing", c.wrong_share()}}}};
}

nlohmann::ordered_json view_json(const Camera& camera, const Light& light, const ViewSettings& settings) {
    nlohmann::ordered_json json{
        {"size", {settings.width, settings.height}},
        {"shadow_map", settings.shadow_map},
        {"camera",
         {{"position", vector_json(camera.position)},
          {"direction", vector_json(camera.direction)},
          {"fov_degrees_vertical", camera.fov},
          {"near", camera.near},
          {"far", camera.far}}},
        {"light", {{"direction", vector_json(light.direction)}, {"fit", to_string(settings.light_fit)}}},
        {"receiver", settings.receiver_plane ? "plane" : "depth"}};
    if (settings.bias > 0) json["bias"] = settings.bias;
    if (light.position) {
        json["light"]["position"] = vector_json(*light.position);
        json["light"]["fov_degrees"] = light.fov;
    }
    return json;
}

} // namespace gnomon::cli
