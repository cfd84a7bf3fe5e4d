// The conventions under which the thesis counted, one by one, on scenes where each alone decides.
#include "casegen/random.h"
#include "tests/pipeline/scenes.h"
#include "tests/pipeline/view.h"
#include "tests/support/temporary_folder.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace gnomon::testing {
namespace {

/// Two triangles of a, b, c, d, with one normal at all corners.
void add_quad(Scene& scene, glm::vec3 a, glm::vec3 b, glm::vec3 c, glm::vec3 d, glm::vec3 normal) {
    const auto first = static_cast<unsigned>(scene.positions.size());
    for (const glm::vec3 p : {a, b, c, d}) {
        scene.positions.push_back(p);
        scene.normals.push_back(normal);
    }
    scene.triangles.push_back({first, first + 1, first + 2});
    scene.triangles.push_back({first, first + 2, first + 3});
}

constexpr glm::vec3 up{0, 1, 0};

/// A square of 2 `half` at height y, counter-clockwise as seen from above if `seen_from_above`.
void add_square(Scene& scene, float half, float y, bool seen_from_above, glm::vec3 normal = up) {
    const glm::vec3 a{-half, y, -half}, b{-half, y, half}, c{half, y, half}, d{half, y, -half};
    if (seen_from_above)
        add_quad(scene, a, b, c, d, normal);
    else
        add_quad(scene, d, c, b, a, normal);
}

/// Obliquely down onto the origin; the light comes from nearly above.
View published(int shadow_map = 256) {
    View view;
    view.camera = {.position = {0, 6, 6}, .direction = {0, -1, -1}, .fov = 60, .near = 1, .far = 20};
    view.light.direction = {0.1f, -1, 0.05f};
    view.settings = as_published(160, 120, shadow_map);
    return view;
}

std::size_t covered(const Scene& scene, const View& view) {
    const auto renderer = make_renderer(scene, view);
    return static_cast<std::size_t>(std::ranges::count(renderer->surfaces().covered, 1));
}

TEST(AsPublished, CameraSeesFrontFacesAlone) {
    Scene front, back;
    add_square(front, 3, 0, true);
    add_square(back, 3, 0, false);
    View view = published();
    EXPECT_GT(covered(front, view), 1000u);
    EXPECT_EQ(covered(back, view), 0u);
    view.settings.cull_primary = gpu::Cull::none;
    EXPECT_EQ(covered(back, view), covered(front, view));
}

TEST(AsPublished, VertexNormalsSayWhatFacesTheLight) {
    // A level square whose normals lean over from up at x = -3 to down at x = 3: level halfway.
    Scene scene;
    add_square(scene, 3, 0, true);
    for (std::size_t i = 0; i < 4; ++i) scene.normals[i] = scene.positions[i].x < 0 ? up : -up;
    View view = published();
    view.light.direction = {0, -1, 0};
    const auto renderer = make_renderer(scene, view);
    const std::vector<shared::Receiver>& receivers = renderer->receivers();
    std::size_t facing = 0, away = 0;
    for (const shared::Receiver& r : receivers) {
        if (r.map.w < 0 || std::abs(r.origin.x) < 0.01f) continue; // beside the line any answer will do
        EXPECT_EQ(r.map.w, r.origin.x < 0 ? 1.0f : 0.0f) << r.origin.x;
        ++(r.origin.x < 0 ? facing : away);
    }
    EXPECT_GT(facing, 500u);
    EXPECT_GT(away, 500u);
    view.settings.facing = Facing::triangle;
    const auto by_plane = make_renderer(scene, view);
    EXPECT_EQ(by_plane->surfaces().facing, by_plane->surfaces().covered);
}

TEST(AsPublished, RaysBeginAtTheSurfaceAndHitFromAHundredthOn) {
    const auto shadowed = [](float height) {
        Scene scene;
        add_square(scene, 3, 0, true);
        // Back faces: the camera looks through, rays do not.
        add_square(scene, 1, height, false);
        const auto renderer = make_renderer(scene, published());
        const std::vector<float> truth = visibility(*renderer, raytraced);
        return count_pixels(renderer->surfaces(), truth, truth).truly_shadowed;
    };
    EXPECT_EQ(shadowed(0.009f), 0u);
    EXPECT_GT(shadowed(0.011f), 100u);
    Scene ground;
    add_square(ground, 3, 0, true);
    const auto renderer = make_renderer(ground, published());
    for (const shared::Receiver& r : renderer->receivers())
        if (r.map.w == 1) ASSERT_NEAR(r.origin.y, 0, 1e-5);
}

TEST(AsPublished, MapHoldsWhatFacesAwayFromTheLight) {
    const auto wrongly_lit = [](bool caster_shows_its_back_to_the_light) {
        Scene scene;
        add_square(scene, 3, 0, true);
        add_square(scene, 1, 1, !caster_shows_its_back_to_the_light);
        View view = published();
        view.settings.cull_primary = gpu::Cull::none;
        const auto renderer = make_renderer(scene, view);
        const std::vector<float> truth = visibility(*renderer, raytraced);
        const PixelCounts counts = count_pixels(renderer->surfaces(), visibility(*renderer, nsm), truth);
        EXPECT_GT(counts.truly_shadowed, 200u);
        return static_cast<double>(counts.wrong_lit) / static_cast<double>(counts.truly_shadowed);
    };
    EXPECT_EQ(wrongly_lit(false), 1.0);
    EXPECT_LT(wrongly_lit(true), 0.1);
}

TEST(AsPublished, TakesNoBias) {
    const View view = published();
    Scene scene;
    add_square(scene, 3, 0, true);
    EXPECT_EQ(make_frame(view.camera, view.light, view.settings, scene.bounds()).range.z, 0.0f);
    ViewSettings chosen = view.settings;
    chosen.choose_bias = true;
    EXPECT_GT(make_frame(view.camera, view.light, chosen, scene.bounds()).range.z, 0.0f);
}

TEST(AsPublished, RefusesRaysThatBeginNowhere) {
    View view = published();
    for (const float wrong :
         {-0.01f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        view.settings.ray_begin = wrong;
        EXPECT_THAT(error_of([&] { require_valid(view.camera, view.light, view.settings); }),
                    ::testing::HasSubstr("shadow rays begin"));
    }
}

/// The corners of what the camera sees, through the inverse of its projection: in double, from other axes'
/// products than the product uses.
std::array<glm::dvec3, 8> corners_by_inverse(const Camera& camera, double aspect) {
    const glm::dvec3 eye(camera.position), forward = glm::normalize(glm::dvec3(camera.direction));
    const glm::dmat4 seen = glm::perspectiveRH_ZO(glm::radians(double(camera.fov)), aspect,
                                                  double(camera.near), double(camera.far)) *
                            glm::lookAt(eye, eye + forward, glm::dvec3(0, 1, 0));
    const glm::dmat4 back = glm::inverse(seen);
    std::array<glm::dvec3, 8> corners{};
    for (int i = 0; i < 8; ++i) {
        const glm::dvec4 p = back * glm::dvec4((i & 1) ? 1 : -1, (i & 2) ? 1 : -1, (i & 4) ? 1 : 0, 1);
        corners[static_cast<std::size_t>(i)] = glm::dvec3(p) / p.w;
    }
    return corners;
}

/// How far the box of the frustum's corners in the map's clip space is from -1 … 1, -1 … 1, 0 … 1.
double misfit(const View& view, const Box& box) {
    const shared::Frame frame = make_frame(view.camera, view.light, view.settings, box);
    glm::dvec3 lower(1e9), upper(-1e9);
    const double aspect = double(view.settings.width) / view.settings.height;
    for (const glm::dvec3& corner : corners_by_inverse(view.camera, aspect)) {
        const glm::dvec3 p(glm::dmat4(frame.light) * glm::dvec4(corner, 1));
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    const glm::dvec3 apart =
        glm::max(glm::abs(lower - glm::dvec3(-1, -1, 0)), glm::abs(upper - glm::dvec3(1)));
    return std::max({apart.x, apart.y, apart.z});
}

TEST(AsPublished, MapCoversTheFrustumsEightCornersExactly) {
    Box box;
    box.include(glm::vec3(-40, 0, -40));
    box.include(glm::vec3(90, 30, 40));
    Random random(20);
    const auto number = [&](double low, double high) {
        return static_cast<float>(low + (high - low) * random.unit());
    };
    for (int i = 0; i < 200; ++i) {
        View view;
        view.camera = {.position = {number(-50, 50), number(5, 40), number(-50, 50)},
                       .direction = {number(-1, 1), number(-0.9, -0.1), number(0.1, 1)},
                       .fov = number(20, 100),
                       .near = number(0.5, 2),
                       .far = number(50, 400)};
        view.light.direction = {number(-1, 1), number(-1, -0.2), number(-1, 1)};
        view.settings = as_published(random.between(200, 1920), random.between(200, 1080), 1024);
        EXPECT_LT(misfit(view, box), 2e-5)
            << i; // roundings of coordinates of hundreds, over extents of as many
        view.settings.light_fit = LightFit::seen_box;
        EXPECT_GT(misfit(view, box), 1e-3) << i;
    }
}

} // namespace
} // namespace gnomon::testing
