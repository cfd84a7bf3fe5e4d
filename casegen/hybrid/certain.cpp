#include "casegen/hybrid/certain.h"

#include "casegen/hybrid/exact_ray.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

namespace gnomon::hybrid {

std::vector<std::string> sound_techniques() {
    std::vector<std::string> names;
    for (const HybridTechnique& technique : hybrid_techniques())
        if (technique.sound && technique.name != "traced") names.push_back(technique.name);
    return names;
}

std::vector<std::uint8_t> exact_visibility(Renderer& renderer, const Scene& scene, const Camera& camera,
                                           const Light& light, const ViewSettings& settings) {
    // The direction as runtime/rays.cpp gives it to the ray tracer.
    const shared::Frame frame = make_frame(camera, light, settings, scene.bounds());
    const glm::vec3 direction(glm::normalize(glm::dvec3(glm::vec3(frame.light_origin))));
    const std::vector<shared::Receiver>& receivers = renderer.receivers();
    const Surfaces& surfaces = renderer.surfaces();
    std::vector<std::uint8_t> lit(receivers.size());
    tbb::parallel_for(std::size_t{0}, lit.size(), [&](std::size_t i) {
        if (surfaces.facing[i] != 0)
            lit[i] = meets(Ray{glm::vec3(receivers[i].origin), direction, frame.eye.w}, scene) ? 0 : 1;
    });
    return lit;
}

std::vector<Certainty> certainties(Renderer& renderer, const std::vector<std::uint8_t>& exact,
                                   const std::vector<std::string>& techniques) {
    const Surfaces& surfaces = renderer.surfaces();
    std::vector<Certainty> all;
    for (const std::string& name : techniques) {
        Certainty found{.technique = name, .first = {}};
        const std::vector<PixelState> states = renderer.states({Technique::Kind::hybrid, name});
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (surfaces.facing[i] == 0) continue;
            ++found.facing;
            if (states[i] == PixelState::uncertain) continue;
            const bool lit = states[i] == PixelState::lit;
            ++(lit ? found.lit : found.shadowed);
            if (lit == (exact[i] != 0)) continue;
            ++(lit ? found.lit_wrongly : found.shadowed_wrongly);
            if (found.wrong() == 1)
                found.first = fmt::format("{} says that pixel {} is {}", name, i, lit ? "lit" : "shadowed");
        }
        all.push_back(found);
    }
    return all;
}

} // namespace gnomon::hybrid
