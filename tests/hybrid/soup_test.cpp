// No certain pixel of a sound technique is wrong, whatever the triangles: random soups and the small scenes
// of fixtures/scenes/hybrid, against exact rays.
#include "casegen/hybrid/certain.h"
#include "casegen/hybrid/soups.h"
#include "tests/pipeline/view.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <map>

namespace gnomon::testing {
namespace {

using hybrid::certainties, hybrid::Certainty, hybrid::exact_visibility, hybrid::sound_techniques;
using hybrid::soup, hybrid::soup_camera, hybrid::soup_light, hybrid::soup_settings;

constexpr std::uint64_t seed = 2501;
constexpr std::uint64_t lights = 3; // of each scene

/// Sums over views; every wrong pixel fails.
class Sums {
public:
    void judge(Renderer& renderer, const Scene& scene, const View& view, const std::string& where) {
        for (const Certainty& each :
             certainties(renderer, exact_visibility(renderer, scene, view.camera, view.light, view.settings),
                         sound_techniques())) {
            EXPECT_EQ(each.wrong(), 0u) << where << ": " << each.first;
            Certainty& sum = sums_[each.technique];
            sum.facing += each.facing;
            sum.lit += each.lit;
            sum.shadowed += each.shadowed;
        }
    }
    /// A technique that were certain of nothing would pass.
    void expect_certain_of(double light, double shadow) const {
        EXPECT_EQ(sums_.size(), 3u);
        for (const auto& [name, sum] : sums_) {
            const auto share = [&sum = sum](std::size_t n) {
                return static_cast<double>(n) / static_cast<double>(std::max<std::size_t>(1, sum.facing));
            };
            EXPECT_GT(share(sum.lit), light) << name;
            EXPECT_GT(share(sum.shadowed), shadow) << name;
            ::testing::Test::RecordProperty(name, fmt::format("{} {} {}", sum.facing, sum.lit, sum.shadowed));
        }
    }

private:
    std::map<std::string, Certainty> sums_;
};

void look_at(Sums& sums, const Scene& scene, View view, std::uint64_t index, const std::string& name) {
    view.light = soup_light(seed, index * lights);
    const auto renderer = make_renderer(scene, view);
    for (std::uint64_t light = 0; light < lights; ++light) {
        view.light = soup_light(seed, index * lights + light);
        renderer->look(view.camera, view.light);
        sums.judge(*renderer, scene, view,
                   fmt::format("{}, seed {}, index {}, light {}", name, seed, index, light));
    }
}

TEST(soup, certain_pixels_agree_with_exact_rays) {
    Sums sums;
    for (std::uint64_t index = 0; index < 5; ++index)
        look_at(sums, soup(seed, index), {soup_camera(seed, index), {}, soup_settings(index)}, index, "soup");
    sums.expect_certain_of(0.02, 0.005);
}

TEST(soup, certain_pixels_of_minimal_scenes_agree_with_exact_rays) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(source_folder() / "fixtures/scenes/hybrid"))
        if (entry.path().extension() == ".obj") files.push_back(entry.path());
    std::ranges::sort(files);
    ASSERT_GE(files.size(), 9u);
    Sums sums;
    for (std::uint64_t index = 0; index < files.size(); ++index) {
        const Scene scene = load_scene(files[index]);
        for (const int map : {24, 1000}) {
            View view = default_view(scene, 64, 64, map);
            view.camera.position = {2.5f, 4, 3};
            view.camera.direction = {-0.6f, -1, -0.7f};
            look_at(sums, scene, view, index,
                    fmt::format("{}, map {}", files[index].filename().string(), map));
            // Near, so that thin triangles fill pixels.
            view.camera.position = {0.1f, 1.2f, 0};
            view.camera.direction = {-0.01f, -1, 0.02f};
            look_at(sums, scene, view, index + 100,
                    fmt::format("{} from near, map {}", files[index].filename().string(), map));
        }
    }
    sums.expect_certain_of(0.2, 0.005);
}

} // namespace
} // namespace gnomon::testing
