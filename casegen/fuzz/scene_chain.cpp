#include "casegen/fuzz/scene_chain.h"

#include "casegen/fuzz/scene_input.h"
#include "casegen/fuzz/scene_shrink.h"
#include "casegen/hybrid/certain.h"
#include "casegen/hybrid/soups.h"
#include "runtime/error.h"

#include <fmt/format.h>

namespace gnomon::fuzz {
namespace {

/// What no renderer takes is no failure: shrinking may ask for a camera that looks nowhere. A kernel that
/// does not compile or end is none either, and is told as everywhere.
bool is_renderable(const SceneInput& s) {
    try {
        require_valid(s.camera, s.light, s.settings);
        make_frame(s.camera, s.light, s.settings, s.scene.bounds());
    } catch (const Error&) {
        return false;
    }
    return true;
}

std::string failure_of(const SceneInput& s, const std::string& technique, const glsl::Sources& sources,
                       gpu::Device& device) {
    if (!is_renderable(s)) return {};
    Renderer renderer(device, sources, s.scene, s.camera, s.light, s.settings);
    const hybrid::Certainty certainty =
        hybrid::certainties(
            renderer, hybrid::exact_visibility(renderer, s.scene, s.camera, s.light, s.settings), {technique})
            .front();
    if (certainty.lit_wrongly > 0) return "certain of light, which a triangle blocks";
    if (certainty.shadowed_wrongly > 0) return "certain of shadow, where no triangle is";
    return {};
}

SceneInput draw_scene(std::uint64_t seed, std::uint64_t index) {
    SceneInput s;
    s.scene = hybrid::soup(seed, index);
    s.camera = hybrid::soup_camera(seed, index);
    s.light = hybrid::soup_light(seed, index);
    s.settings = hybrid::soup_settings(index);
    return s;
}

} // namespace

Chain scene_chain(const std::string& technique) {
    Chain chain;
    chain.described.name = "scene/" + technique;
    chain.described.source = "docs/fuzzing.md";
    chain.described.result = {0, 1, "1", "whether a certain pixel is wrong"};
    chain.invariants = {"no pixel that the technique is certain of is contradicted by an exact ray"};
    chain.batch = 1;
    chain.batches = 5; // all sizes of map
    chain.draw = [](std::uint64_t seed, std::uint64_t first, std::size_t count) {
        std::vector<Input> inputs;
        for (std::size_t i = 0; i < count; ++i) inputs.push_back(words_of(draw_scene(seed, first + i)));
        return inputs;
    };
    chain.judge = [technique](const glsl::Sources& sources, gpu::Device& device) -> Judge {
        return [technique, sources, &device](std::span<const Input> inputs) {
            std::vector<std::string> failures;
            for (const Input& input : inputs)
                failures.push_back(failure_of(scene_of(input), technique, sources, device));
            return failures;
        };
    };
    chain.shrink = [](const Input& input, const StillFails& still_fails) {
        return words_of(shrink_scene(scene_of(input), still_fails));
    };
    chain.format = [name = chain.described.name](const Input& input) {
        const SceneInput s = scene_of(input);
        return fmt::format("{} on {} triangles, {} x {} pixels, map {}", name, s.scene.triangles.size(),
                           s.settings.width, s.settings.height, s.settings.shadow_map);
    };
    return chain;
}

} // namespace gnomon::fuzz
