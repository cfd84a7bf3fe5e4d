// Cameras, lights and renderers that the tests of the pipeline share.
#pragma once

#include "runtime/pipeline/judge.h"
#include "runtime/pipeline/renderer.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gnomon::testing {

struct View {
    Camera camera;
    Light light;
    ViewSettings settings;
};

inline const Technique no_shadows{Technique::Kind::none, "none"};
inline const Technique nsm{Technique::Kind::kernel, "nsm"};
inline const Technique smsr{Technique::Kind::kernel, "smsr"};
inline const Technique raytraced{Technique::Kind::raytraced, "raytraced"};
inline Technique hybrid(const std::string& name) { return {Technique::Kind::hybrid, name}; }

/// The demo scene against the light, near enough to show every kind of edge; directional light.
View demo_view(int width, int height, int shadow_map);
/// The same with a light at a place.
View demo_view_with_lamp(int width, int height, int shadow_map);
/// The default camera and light over any scene.
View default_view(const Scene& scene, int width, int height, int shadow_map);

/// On the shared device, with its validation layer on.
std::unique_ptr<Renderer> make_renderer(const Scene& scene, const View& view);

std::vector<float> visibility(Renderer& renderer, const Technique& technique);

/// 1 where `first` is lit and `second` is not, among the pixels that face the light.
std::size_t lit_only_in_first(const Surfaces& surfaces, std::span<const float> first,
                              std::span<const float> second);

} // namespace gnomon::testing
