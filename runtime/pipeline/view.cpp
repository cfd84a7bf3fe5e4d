#include "runtime/pipeline/view.h"

#include "runtime/error.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using glm::mat4, glm::vec2, glm::vec3, glm::vec4;

/// Relative to the depth range: the map's depth is interpolated in float32, with errors of a few 2^-23 of the
/// range, and the receiver's plane is as exact. A thousandth of a texel's depth would be lost in neither.
constexpr float bias_of_range = 2e-5f;
/// Of the scene's diagonal: how far a shadow ray starts above its surface. Positions carry about 2^-22 of it.
constexpr float lift_of_diagonal = 1e-5f;

bool finite(vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_direction(vec3 direction, const char* option) {
    if (!finite(direction) || direction == vec3(0))
        throw Error("{} is {},{},{}; a direction must be finite and not zero", option, direction.x,
                    direction.y, direction.z);
}

void require_position(vec3 position, const char* option) {
    if (!finite(position))
        throw Error("{} is {},{},{}; a position must be finite", option, position.x, position.y, position.z);
}

/// Of any length that is not zero, also where its square would leave the range of float.
vec3 unit(vec3 v) { return glm::normalize(v / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)})); }

/// Right-handed axes across `forward`, with +y up as far as possible.
struct Axes {
    vec3 right, up, forward;
};
Axes axes_along(vec3 direction) {
    const vec3 forward = unit(direction);
    const vec3 hint = std::abs(forward.y) > 0.999f ? vec3(0, 0, 1) : vec3(0, 1, 0);
    const vec3 right = glm::normalize(glm::cross(forward, hint));
    return {right, glm::cross(right, forward), forward};
}

std::array<vec3, 8> corners(const Box& box) {
    std::array<vec3, 8> result{};
    for (int i = 0; i < 8; ++i)
        result[static_cast<std::size_t>(i)] = {(i & 1) ? box.upper.x : box.lower.x,
                                               (i & 2) ? box.upper.y : box.lower.y,
                                               (i & 4) ? box.upper.z : box.lower.z};
    return result;
}

/// The box around points in the coordinates of `axes`: x right, y up, z forward.
template <std::size_t N>
Box box_along(const Axes& axes, const std::array<vec3, N>& points) {
    Box box;
    for (const vec3 p : points)
        box.include({glm::dot(axes.right, p), glm::dot(axes.up, p), glm::dot(axes.forward, p)});
    return box;
}

/// World to clip space with rows y growing downwards, depth 0 at near and 1 at far.
mat4 perspective(vec3 position, const Axes& axes, float fov, float aspect, float near, float far) {
    mat4 projection = glm::perspectiveRH_ZO(glm::radians(fov), aspect, near, far);
    projection[1][1] = -projection[1][1];
    // Not glm::lookAt: far from the origin, position + forward would round the direction away.
    const mat4 view = glm::transpose(
        mat4(vec4(axes.right, -glm::dot(axes.right, position)), vec4(axes.up, -glm::dot(axes.up, position)),
             vec4(-axes.forward, glm::dot(axes.forward, position)), vec4(0, 0, 0, 1)));
    return projection * view;
}

/// What a light can see of the scene in its own axes (x right, y up, z forward): across it, what the camera
/// can see too; along it, everything that casts.
Box seen_box(const Axes& axes, const Box& box, const std::array<vec3, 8>& frustum) {
    Box fit = box_along(axes, corners(box));
    const Box seen = box_along(axes, frustum);
    for (int axis = 0; axis < 2; ++axis) {
        const float low = std::max(fit.lower[axis], seen.lower[axis]);
        const float high = std::min(fit.upper[axis], seen.upper[axis]);
        if (low < high) { // else the camera sees nothing of the scene and any map will do
            fit.lower[axis] = low;
            fit.upper[axis] = high;
        }
    }
    // A hair around it, so that a flat scene has a depth range and its border texels are whole.
    const vec3 margin = 1e-3f * vec3(std::max(glm::length(fit.upper - fit.lower), 1e-6f));
    fit.lower -= margin;
    fit.upper += margin;
    return fit;
}

/// A directional light whose map covers `fit`, a box in the light's axes.
void light_directional(shared::Frame& frame, const Axes& axes, const Box& fit, float side) {
    const vec3 lower = fit.lower, upper = fit.upper, extent = upper - lower;
    const auto row = [](vec3 direction, float scale, float offset) {
        return vec4(direction * scale, offset);
    };
    const vec4 x = row(axes.right, 2 / extent.x, -2 * lower.x / extent.x - 1);
    const vec4 y = row(-axes.up, 2 / extent.y, 2 * upper.y / extent.y - 1);
    frame.light_depth = row(axes.forward, 1 / extent.z, -lower.z / extent.z);
    frame.light = glm::transpose(mat4(x, y, frame.light_depth, vec4(0, 0, 0, 1)));
    frame.light_origin = vec4(-axes.forward, 0);
    frame.texel_x = vec4(axes.right * (extent.x / side), 0);
    frame.texel_y = vec4(-axes.up * (extent.y / side), 0);
    frame.axis = vec4(axes.forward * extent.z, 0);
    frame.range.x = lower.z;
    frame.range.y = upper.z;
}

void light_directional(shared::Frame& frame, const Light& light, const Camera& camera,
                       const ViewSettings& settings, const Box& box) {
    const Axes axes = axes_along(light.direction);
    const std::array<vec3, 8> frustum =
        frustum_corners(camera, static_cast<float>(settings.width) / static_cast<float>(settings.height));
    Box fit;
    switch (settings.light_fit) {
    case LightFit::seen_box:
    case LightFit::visible_points: // until they are known: see refitted
        fit = seen_box(axes, box, frustum);
        break;
    case LightFit::camera_frustum:
        fit = box_along(axes, frustum);
        break;
    }
    light_directional(frame, axes, fit, static_cast<float>(settings.shadow_map));
}

void light_perspective(shared::Frame& frame, const Light& light, const ViewSettings& settings,
                       const Box& box) {
    const Axes axes = axes_along(light.direction);
    const vec3 position = *light.position;
    float far = 0;
    for (const vec3 corner : corners(box)) far = std::max(far, glm::dot(axes.forward, corner - position));
    if (!(far > 0))
        throw Error("--light-direction: the light at --light-position looks away from the whole scene");
    far *= 1.001f;
    const float near = 1e-3f * far, range = far - near;
    const float texel = 2 * std::tan(glm::radians(light.fov) / 2) / static_cast<float>(settings.shadow_map);
    frame.light = perspective(position, axes, light.fov, 1, near, far);
    frame.light_depth = vec4(axes.forward / range, (-glm::dot(axes.forward, position) - near) / range);
    frame.light_origin = vec4(position, 1);
    frame.texel_x = vec4(axes.right * texel, 0);
    frame.texel_y = vec4(-axes.up * texel, 0);
    frame.axis = vec4(axes.forward, 0);
    frame.range.x = near;
    frame.range.y = far;
}

} // namespace

std::array<vec3, 8> frustum_corners(const Camera& camera, float aspect) {
    const Axes axes = axes_along(camera.direction);
    const float tangent = std::tan(glm::radians(camera.fov) / 2);
    std::array<vec3, 8> result{};
    for (int i = 0; i < 8; ++i) {
        const float distance = (i & 4) ? camera.far : camera.near;
        const float x = ((i & 1) ? 1.0f : -1.0f) * tangent * aspect * distance;
        const float y = ((i & 2) ? 1.0f : -1.0f) * tangent * distance;
        result[static_cast<std::size_t>(i)] =
            camera.position + distance * axes.forward + x * axes.right + y * axes.up;
    }
    return result;
}

ViewSettings as_published(int width, int height, int shadow_map) {
    ViewSettings settings;
    settings.width = width;
    settings.height = height;
    settings.shadow_map = shadow_map;
    settings.choose_bias = false;
    settings.receiver_plane = false;
    settings.light_fit = LightFit::camera_frustum;
    settings.facing = Facing::vertex_normals;
    settings.cull_primary = gpu::Cull::back;
    settings.cull_shadow_map = gpu::Cull::front;
    settings.ray_begin = 0.01f;
    return settings;
}

void require_valid(const Camera& camera, const Light& light, const ViewSettings& settings) {
    const auto require_side = [](int side, const char* option) {
        if (side < 1 || side > 16384) throw Error("{} is {}; 1 to 16384 is possible", option, side);
    };
    require_side(settings.width, "--size: the width");
    require_side(settings.height, "--size: the height");
    require_side(settings.shadow_map, "--shadow-map");
    require_position(camera.position, "--camera-position");
    require_direction(camera.direction, "--camera-direction");
    if (light.position) require_position(*light.position, "--light-position");
    require_direction(light.direction, "--light-direction");
    const auto require_fov = [](float fov, const char* option) {
        if (!(fov > 0.01f && fov < 179.9f))
            throw Error("{} is {}; 0.01 to 179.9 degrees are possible", option, fov);
    };
    require_fov(camera.fov, "--fov");
    require_fov(light.fov, "--light-fov");
    if (!(camera.near > 0) || !(camera.far > camera.near) || !std::isfinite(camera.far))
        throw Error("--near is {} and --far is {}; 0 < near < far is needed", camera.near, camera.far);
    if (!(settings.bias >= 0) || !std::isfinite(settings.bias))
        throw Error("--bias is {}; it must be 0 (choose for me) or a positive distance", settings.bias);
    if (!(settings.ray_begin >= 0) || !std::isfinite(settings.ray_begin))
        throw Error("shadow rays begin at {}; it must be 0 (choose for me) or a positive distance",
                    settings.ray_begin);
}

Camera default_camera(const Box& box, float aspect) {
    Camera camera;
    const float diagonal = std::max(box.diagonal(), 1e-6f);
    camera.direction = glm::normalize(vec3(-0.45f, -0.42f, -0.8f));
    camera.fov = 50;
    // Back until the last corner is in sight, with a little room around it.
    const Axes axes = axes_along(camera.direction);
    const float tangent = 0.95f * std::tan(glm::radians(camera.fov) / 2);
    float distance = 0;
    for (const vec3 corner : corners(box)) {
        const vec3 from_centre = corner - box.centre();
        const float across = std::max(std::abs(glm::dot(axes.right, from_centre)) / aspect,
                                      std::abs(glm::dot(axes.up, from_centre)));
        const float in_front = std::max(across / tangent, 0.02f * diagonal);
        distance = std::max(distance, in_front - glm::dot(axes.forward, from_centre));
    }
    camera.position = box.centre() - distance * camera.direction;
    camera.near = 0.01f * diagonal;
    camera.far = std::max(3 * diagonal, distance + diagonal);
    return camera;
}

shared::Frame make_frame(const Camera& camera, const Light& light, const ViewSettings& settings,
                         const Box& box) {
    require_valid(camera, light, settings);
    // Beyond, squares of lengths leave float32's range in the shaders.
    if (const float diagonal = box.diagonal(); !(diagonal > 1e-6f && diagonal < 1e7f))
        throw Error("the scene is {:g} across; between 1e-6 and 1e7 can be rendered: scale it", diagonal);
    shared::Frame frame{};
    const float aspect = static_cast<float>(settings.width) / static_cast<float>(settings.height);
    frame.camera = perspective(camera.position, axes_along(camera.direction), camera.fov, aspect, camera.near,
                               camera.far);
    if (light.position)
        light_perspective(frame, light, settings, box);
    else
        light_directional(frame, light, camera, settings, box);
    const float range = frame.range.y - frame.range.x;
    frame.range.z = settings.bias > 0 ? settings.bias / range : settings.choose_bias ? bias_of_range : 0.0f;
    const float chosen = lift_of_diagonal * box.diagonal();
    frame.range.w = settings.ray_begin > 0 ? 0 : chosen;
    frame.eye = vec4(camera.position, settings.ray_begin > 0 ? settings.ray_begin : chosen);
    frame.rules.y = static_cast<unsigned>(settings.cull_shadow_map);
    frame.rules.x = settings.facing == Facing::vertex_normals ? 1 : 0;
    frame.size = {static_cast<unsigned>(settings.width), static_cast<unsigned>(settings.height),
                  static_cast<unsigned>(settings.shadow_map), settings.receiver_plane ? 1u : 0u};
    return frame;
}

shared::Frame refitted(const shared::Frame& frame, vec2 lower, vec2 upper) {
    const double side = frame.size.z;
    const glm::dvec2 middle = 0.5 * (glm::dvec2(lower) + glm::dvec2(upper));
    // A two-hundredth around, and never so little that texels lose their float32 coordinates.
    const glm::dvec2 extent = glm::max(1.005 * glm::dvec2(upper - lower), glm::dvec2(1e-3 * side));
    shared::Frame result = frame;
    glm::dmat4 rows = glm::transpose(glm::dmat4(frame.light));
    for (int axis = 0; axis < 2; ++axis) {
        // Texels t = (clip + 1) side / 2 become (t - middle) side / extent + side / 2.
        const double scale = side / extent[axis];
        const double offset = scale * (1 - 2 * middle[axis] / side);
        rows[axis] *= scale;
        rows[axis][3] += offset;
        (axis == 0 ? result.texel_x : result.texel_y) *= static_cast<float>(1 / scale);
    }
    result.light = mat4(glm::transpose(rows));
    return result;
}

} // namespace gnomon
