// How certain each hybrid technique is, and how often wrongly: random cameras, lights, map sizes and fits
// over scenes.
//     check_sound [SCENE…] [--views N] [--seed S] [--size PIXELS] [--thesis]
// A sound technique that is certain and wrong anywhere makes it fail.
#include "casegen/demo_scene.h"
#include "casegen/random.h"
#include "casegen/standalone.h"
#include "cli/reproduce/views.h"
#include "runtime/error.h"
#include "runtime/hybrid/classifier.h"
#include "runtime/pipeline/renderer.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <map>

namespace gnomon {
namespace {

struct Tally {
    std::size_t facing = 0, uncertain = 0, wrong = 0;
};

struct View {
    std::string name;
    Camera camera;
    Light light;
    ViewSettings settings;
};

float within(Random& random, float lower, float upper) {
    return lower + (upper - lower) * static_cast<float>(random.unit());
}

glm::vec3 point_in(Random& random, const Box& box, float grown) {
    const glm::vec3 half = 0.5f * (box.upper - box.lower) * grown;
    glm::vec3 point{};
    for (int axis = 0; axis < 3; ++axis)
        point[axis] = box.centre()[axis] + within(random, -1, 1) * half[axis];
    return point;
}

View random_view(const Scene& scene, std::uint64_t seed, std::uint64_t index, int size) {
    Random random(seed, index);
    const Box box = scene.bounds();
    View view{fmt::format("seed {} view {}", seed, index), {}, {}, {}};
    view.camera.position = point_in(random, box, 1.5f);
    view.camera.direction = point_in(random, box, 0.8f) - view.camera.position + glm::vec3(1e-3f);
    view.camera.fov = within(random, 20, 100);
    view.camera.near = 1e-3f * box.diagonal();
    view.camera.far = 3 * box.diagonal();
    // Mostly from above; sometimes along an axis, where triangles are edge-on.
    view.light.direction = glm::vec3(within(random, -1, 1), within(random, -1, 0.2f), within(random, -1, 1));
    if (random.chance(0.15)) view.light.direction = glm::vec3(0, -1, 0);
    if (random.chance(0.1)) view.light.direction = glm::vec3(1, 0, 0);
    constexpr std::array maps{64, 333, 512, 1024, 2048, 4096};
    view.settings.shadow_map = maps.at(random.below(maps.size()));
    view.settings.width = size + static_cast<int>(random.below(32));
    view.settings.height = size;
    constexpr std::array fits{LightFit::seen_box, LightFit::camera_frustum, LightFit::visible_points};
    view.settings.light_fit = fits.at(random.below(fits.size()));
    if (random.chance(0.3)) { // a ray begins on its surface
        view.settings.ray_begin = 4e-5f * box.diagonal();
        view.settings.facing = Facing::vertex_normals;
    }
    return view;
}

/// The triangles that the ray meets or nearly meets, in double.
void tell_hits(const Scene& scene, glm::dvec3 origin, glm::dvec3 towards) {
    const glm::dvec3 d(glm::vec3(glm::normalize(towards)));
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        glm::dvec3 p[3];
        for (int k = 0; k < 3; ++k) p[k] = glm::dvec3(scene.positions[scene.triangles[i][k]]) - origin;
        const glm::dvec3 normal = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double t = glm::dot(normal, p[0]) / glm::dot(normal, d);
        double least = 1e300; // distance inside the nearest edge
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3 edge = p[(k + 1) % 3] - p[k];
            const glm::dvec3 inward = glm::normalize(glm::cross(normal, edge));
            least = std::min(least, glm::dot(inward, t * d - p[k]));
        }
        if (least > -1e-3 && t > -1)
            fmt::print("    triangle {}: t {:.9g}, {:.3g} within its edges, cosine {:.3g}\n", i, t, least,
                       glm::dot(glm::normalize(normal), glm::normalize(d)));
    }
}

/// Certain-but-wrong pixels of techniques that must have none.
std::size_t judge(gpu::Device& device, const Scene& scene, const View& view,
                  std::span<const std::string> techniques, std::map<std::string, Tally>& tallies) {
    Renderer renderer(device, kernel_sources(GNOMON_SOURCE_DIR "/kernels"), scene, view.camera, view.light,
                      view.settings);
    const std::vector<float> truth = renderer.visibility({Technique::Kind::raytraced, "raytraced"});
    const Surfaces& surfaces = renderer.surfaces();
    std::size_t bad = 0;
    for (const std::string& name : techniques) {
        const std::vector<PixelState> states = renderer.states({Technique::Kind::hybrid, name});
        Tally tally;
        std::size_t first = states.size();
        for (std::size_t i = 0; i < states.size(); ++i) {
            if (surfaces.facing[i] == 0) continue;
            ++tally.facing;
            if (states[i] == PixelState::uncertain)
                ++tally.uncertain;
            else if ((states[i] == PixelState::lit) != (truth[i] >= 0.5f)) {
                ++tally.wrong;
                first = std::min(first, i);
            }
        }
        Tally& sum = tallies[name];
        sum.facing += tally.facing;
        sum.uncertain += tally.uncertain;
        sum.wrong += tally.wrong;
        if (tally.wrong == 0 || !find_hybrid(name)->sound) continue;
        bad += tally.wrong;
        const shared::Receiver& receiver = renderer.receivers()[first];
        const auto column = first % static_cast<std::size_t>(view.settings.width);
        fmt::print("{} {}: {} is certain and wrong in {} pixels, first at {}, {}: {} (map {}, fit {}, ray "
                   "begin {})\n",
                   scene.name, view.name, name, tally.wrong, column,
                   first / static_cast<std::size_t>(view.settings.width),
                   states[first] == PixelState::lit ? "lit" : "shadowed", view.settings.shadow_map,
                   static_cast<int>(view.settings.light_fit), view.settings.ray_begin);
        fmt::print("  ray from {:a}, {:a}, {:a} along {:a}, {:a}, {:a}\n", receiver.origin.x,
                   receiver.origin.y, receiver.origin.z, -view.light.direction.x, -view.light.direction.y,
                   -view.light.direction.z);
        tell_hits(scene, glm::dvec3(receiver.origin), glm::dvec3(-view.light.direction));
    }
    return bad;
}

void print(const std::string& of, const std::map<std::string, Tally>& tallies) {
    fmt::print("{:<34}", of);
    for (const auto& [name, tally] : tallies)
        fmt::print("  {} {:.2f} % ({})", name,
                   100.0 * static_cast<double>(tally.uncertain) /
                       static_cast<double>(std::max<std::size_t>(1, tally.facing)),
                   tally.wrong);
    fmt::print("\n");
    std::fflush(stdout);
}

int run(int argc, char** argv) {
    CLI::App app("How certain each hybrid technique is, and how often wrongly");
    std::vector<std::string> paths, techniques;
    int views = 50, size = 256;
    std::vector<int> maps{512, 1024, 2048, 4096};
    std::uint64_t seed = 1;
    bool thesis = false;
    int first = 0;
    app.add_option("--scene,SCENE", paths);
    app.add_option("--views", views);
    app.add_option("--first", first, "number of the first view of the seed");
    app.add_option("--size", size);
    app.add_option("--seed", seed);
    app.add_option("--maps", maps)->delimiter(',');
    app.add_option("--techniques", techniques)->delimiter(',');
    app.add_flag("--thesis", thesis, "the thesis's views, under its conventions, instead of random ones");
    CLI11_PARSE(app, argc, argv);
    if (techniques.empty())
        for (const HybridTechnique& technique : hybrid_techniques())
            if (technique.sound && technique.name != "traced") techniques.push_back(technique.name);
    std::vector<Scene> scenes;
    for (const std::string& path : paths) scenes.push_back(load_scene(path));
    if (scenes.empty()) scenes.push_back(demo_scene());
    gpu::Device device;
    std::size_t bad = 0;
    for (const Scene& scene : scenes) {
        std::map<std::string, Tally> sum;
        if (thesis) {
            for (const cli::ThesisView& view : cli::thesis_views())
                for (const int map : maps) {
                    std::map<std::string, Tally> of_view;
                    bad += judge(device, scene,
                                 {view.name, view.camera, cli::thesis_light(), as_published(1024, 1024, map)},
                                 techniques, of_view);
                    print(fmt::format("{} {}", view.name, map), of_view);
                }
            continue;
        }
        for (int i = first; i < first + views; ++i)
            bad += judge(device, scene, random_view(scene, seed, static_cast<std::uint64_t>(i), size),
                         techniques, sum);
        print(fmt::format("{}, {} views, seed {}", scene.name, views, seed), sum);
    }
    fmt::print("{} pixels certain and wrong\n", bad);
    return bad == 0 ? 0 : 1;
}

} // namespace
} // namespace gnomon

int main(int argc, char** argv) {
    try {
        return gnomon::run(argc, argv);
    } catch (const std::exception& e) {
        fmt::print(stderr, "check_sound: {}\n", e.what());
        return 2;
    }
}
