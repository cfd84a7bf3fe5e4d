#include "casegen/demo_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>

namespace gnomon {
namespace {

/// Solids are sunk this deep, so that none has a face in the plane of the ground.
constexpr float sunk = 0.02f;

/// A right-handed orthonormal system of axes at a place.
struct Frame {
    glm::vec3 origin{0.0f};
    glm::vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};

    glm::vec3 at(float u, float v, float w) const { return origin + u * x + v * y + w * z; }
    glm::vec3 at(glm::vec2 p, float w) const { return at(p.x, p.y, w); }
};

/// An angle as the legs of a triangle: directions then need square roots only, which every machine rounds
/// alike.
struct Angle {
    float along, across;
};

glm::vec2 direction(Angle angle) { return glm::normalize(glm::vec2(angle.along, angle.across)); }

Frame standing_at(float x, float z, Angle about_y = {1, 0}) {
    const glm::vec2 d = direction(about_y);
    return {{x, 0, z}, {d.x, 0, -d.y}, {0, 1, 0}, {d.y, 0, d.x}};
}

Frame turned_in_own_plane(const Frame& frame, glm::vec2 new_x) {
    const glm::vec3 x = new_x.x * frame.x + new_x.y * frame.y;
    const glm::vec3 y = -new_x.y * frame.x + new_x.x * frame.y;
    return {frame.origin, x, y, frame.z};
}

/// A flat convex polygon, its corners counter-clockwise seen from where its normal points.
void add_polygon(Scene& scene, std::span<const glm::vec3> corners, glm::vec3 normal) {
    const auto first = static_cast<std::uint32_t>(scene.positions.size());
    for (const glm::vec3& corner : corners) {
        scene.positions.push_back(corner);
        scene.normals.push_back(normal);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        scene.triangles.emplace_back(first, first + i - 1, first + i);
}

/// A convex outline (counter-clockwise in the frame's x and y), extruded from z = back to z = front.
void add_prism(Scene& scene, const Frame& frame, std::span<const glm::vec2> outline, float back,
               float front) {
    std::vector<glm::vec3> corners;
    for (const glm::vec2 p : outline) corners.push_back(frame.at(p, front));
    add_polygon(scene, corners, frame.z);

    corners.clear();
    for (const glm::vec2 p : outline) corners.push_back(frame.at(p, back));
    std::ranges::reverse(corners);
    add_polygon(scene, corners, -frame.z);

    for (std::size_t i = 0; i < outline.size(); ++i) {
        const glm::vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        const glm::vec2 outward = glm::normalize(glm::vec2(b.y - a.y, a.x - b.x));
        const glm::vec3 side[] = {frame.at(a, back), frame.at(b, back), frame.at(b, front),
                                  frame.at(a, front)};
        add_polygon(scene, side, outward.x * frame.x + outward.y * frame.y);
    }
}

void add_box(Scene& scene, const Frame& frame, glm::vec3 lower, glm::vec3 upper) {
    const glm::vec2 outline[] = {
        {lower.x, lower.y}, {upper.x, lower.y}, {upper.x, upper.y}, {lower.x, upper.y}};
    add_prism(scene, frame, outline, lower.z, upper.z);
}

void add_ground(Scene& scene, float half_width) {
    const float h = half_width;
    const glm::vec3 corners[] = {{-h, 0, h}, {h, 0, h}, {h, 0, -h}, {-h, 0, -h}};
    add_polygon(scene, corners, {0, 1, 0});
}

/// Pointed pickets along the frame's x, and two rails behind them.
void add_fence(Scene& scene, const Frame& frame, int pickets) {
    constexpr float spacing = 0.2f, half_width = 0.055f, shoulder = 0.95f, tip = 1.1f;
    for (int i = 0; i < pickets; ++i) {
        const float middle = (static_cast<float>(i) + 0.5f) * spacing;
        const glm::vec2 outline[] = {{middle - half_width, -sunk},
                                     {middle + half_width, -sunk},
                                     {middle + half_width, shoulder},
                                     {middle, tip},
                                     {middle - half_width, shoulder}};
        add_prism(scene, frame, outline, 0.0f, 0.03f);
    }
    const float length = static_cast<float>(pickets) * spacing;
    for (const float height : {0.25f, 0.75f}) // reaching into the pickets, so that no light passes between
        add_box(scene, frame, {0, height, -0.04f}, {length, height + 0.08f, 0.005f});
}

/// A frame filled with two layers of crossing diagonal slats: diamond-shaped holes.
void add_lattice(Scene& scene, const Frame& frame, float width, float height) {
    constexpr float border = 0.08f, half_slat = 0.02f, spacing = 0.25f, thickness = 0.02f;
    add_box(scene, frame, {0, -sunk, -0.04f}, {border, height, 0.04f});
    add_box(scene, frame, {width - border, -sunk, -0.04f}, {width, height, 0.04f});
    for (const float foot :
         {0.05f, height - border - 0.03f}) // reaching into the posts, no face in a plane of theirs
        add_box(scene, frame, {0.5f * border, foot, -0.03f}, {width - 0.5f * border, foot + border, 0.03f});

    // Slats run from the middle of one border to the middle of another, along x - y = offset.
    const glm::vec2 lower(0.5f * border, 0.05f + 0.5f * border);
    const glm::vec2 size = glm::vec2(width - 0.5f * border, height - 0.03f - 0.5f * border) - lower;
    const int first = -static_cast<int>(size.y / spacing), last = static_cast<int>(size.x / spacing);
    for (int i = first; i <= last; ++i) {
        const float offset = (static_cast<float>(i) + 0.5f) * spacing;
        const glm::vec2 start(std::max(0.0f, offset), std::max(0.0f, -offset));
        const glm::vec2 end(std::min(size.x, size.y + offset), std::min(size.y, size.x - offset));
        const float length = glm::length(end - start);
        if (start.x >= end.x || length < 2 * border) continue;
        for (const bool flipped : {false, true}) {
            const glm::vec2 foot = lower + (flipped ? glm::vec2(size.x - start.x, start.y) : start);
            Frame slat = turned_in_own_plane(frame, direction({flipped ? -1.0f : 1.0f, 1}));
            slat.origin = frame.at(foot, 0.0f);
            const float back = flipped ? 0.0f : -thickness;
            add_box(scene, slat, {0, -half_slat, back}, {length, half_slat, back + thickness});
        }
    }
}

/// A pole of six sides, leaning towards the frame's x.
void add_pole(Scene& scene, const Frame& frame, float radius, float height, Angle lean = {1, 0}) {
    const float half_side = 0.5f * radius, apothem = radius * std::sqrt(0.75f);
    const glm::vec2 hexagon[] = {{radius, 0},  {half_side, apothem},   {-half_side, apothem},
                                 {-radius, 0}, {-half_side, -apothem}, {half_side, -apothem}};
    const glm::vec2 d = direction(lean);
    // The pole's axis is its own z; the lean turns it from up towards the frame's x.
    const glm::vec3 axis = d.x * frame.y + d.y * frame.x;
    const Frame pole{frame.origin, d.x * frame.x - d.y * frame.y, -frame.z, axis};
    add_prism(scene, pole, hexagon, -2 * sunk, height);
}

void add_boxes(Scene& scene) {
    const auto standing_box = [&](const Frame& frame, float width, float height, float depth) {
        add_box(scene, frame, {-0.5f * width, -sunk, -0.5f * depth}, {0.5f * width, height, 0.5f * depth});
    };
    standing_box(standing_at(-3.2f, -1.6f), 1.2f, 0.8f, 1.0f);
    standing_box(standing_at(-1.2f, -2.6f, {12, 5}), 1.0f, 1.6f, 1.0f);
    standing_box(standing_at(1.0f, -1.4f, {4, -3}), 0.7f, 0.5f, 1.3f);
    standing_box(standing_at(4.2f, 0.4f, {1, 1}), 0.9f, 0.9f, 0.9f);
    standing_box(standing_at(-4.4f, 3.6f, {3, 1}), 0.5f, 2.4f, 0.5f);
    // A small one on the first, sunk into its top.
    Frame on_top = standing_at(-3.3f, -1.5f, {8, 15});
    on_top.origin.y = 0.8f;
    standing_box(on_top, 0.5f, 0.45f, 0.5f);
    // A table: shadows on what stands under it, and light below it.
    const Frame table = standing_at(2.6f, -3.8f, {24, 7});
    add_box(scene, table, {-0.8f, 0.7f, -0.5f}, {0.8f, 0.76f, 0.5f});
    for (const float x : {-0.74f, 0.68f})
        for (const float z : {-0.44f, 0.38f})
            add_box(scene, table, {x, -sunk, z}, {x + 0.06f, 0.71f, z + 0.06f});
}

} // namespace

Scene demo_scene() {
    Scene scene;
    scene.name = "demo";
    add_ground(scene, 6.0f);
    add_fence(scene, standing_at(-4.0f, 1.2f), 30);
    add_fence(scene, standing_at(2.2f, 1.5f, {4, -3}), 14);
    add_boxes(scene);
    add_lattice(scene, standing_at(-0.2f, 3.2f, {15, 8}), 2.4f, 1.7f);
    add_pole(scene, standing_at(-2.4f, 3.4f), 0.03f, 2.8f);
    add_pole(scene, standing_at(3.3f, -1.6f), 0.02f, 2.2f, {12, 5});
    add_pole(scene, standing_at(-4.6f, -3.6f, {3, 4}), 0.015f, 1.8f, {4, 3});
    add_pole(scene, standing_at(0.2f, -4.4f, {-1, 2}), 0.04f, 3.0f, {24, 7});
    return scene;
}

} // namespace gnomon
