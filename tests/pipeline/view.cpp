#include "tests/pipeline/view.h"

#include "casegen/standalone.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

namespace gnomon::testing {

View default_view(const Scene& scene, int width, int height, int shadow_map) {
    View view;
    view.camera = default_camera(scene.bounds(), static_cast<float>(width) / static_cast<float>(height));
    view.settings.width = width;
    view.settings.height = height;
    view.settings.shadow_map = shadow_map;
    return view;
}

View demo_view(int width, int height, int shadow_map) {
    View view;
    view.camera.position = {2.4f, 2.2f, 7.4f};
    view.camera.direction = {-0.30f, -0.36f, -0.9f};
    view.camera.fov = 50;
    view.camera.near = 0.1f;
    view.camera.far = 50;
    view.light.direction = {0.45f, -0.62f, 0.5f};
    view.settings.width = width;
    view.settings.height = height;
    view.settings.shadow_map = shadow_map;
    return view;
}

View demo_view_with_lamp(int width, int height, int shadow_map) {
    View view = demo_view(width, height, shadow_map);
    view.light.position = glm::vec3(-2.5f, 4.5f, -3.5f);
    view.light.direction = {0.4f, -0.62f, 0.6f};
    view.light.fov = 100;
    return view;
}

std::unique_ptr<Renderer> make_renderer(const Scene& scene, const View& view) {
    return std::make_unique<Renderer>(shared_device(), kernel_sources(kernels_folder()), scene, view.camera,
                                      view.light, view.settings);
}

std::vector<float> visibility(Renderer& renderer, const Technique& technique) {
    return renderer.render(technique, 1).visibility;
}

std::size_t lit_only_in_first(const Surfaces& surfaces, std::span<const float> first,
                              std::span<const float> second) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < surfaces.facing.size(); ++i)
        if (surfaces.facing[i] != 0 && first[i] >= 0.5f && !(second[i] >= 0.5f)) ++count;
    return count;
}

} // namespace gnomon::testing
