#include "tests/pipeline/geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gnomon::testing {
namespace {

using glm::dvec3;

struct Axes {
    dvec3 right, up, forward;
};

Axes look_along(glm::vec3 direction) {
    const dvec3 forward = glm::normalize(dvec3(direction));
    const dvec3 right =
        glm::normalize(glm::cross(forward, std::abs(forward.y) > 0.999 ? dvec3(0, 0, 1) : dvec3(0, 1, 0)));
    return {right, glm::cross(right, forward), forward};
}

double half_tangent(float degrees) { return std::tan(static_cast<double>(degrees) * std::numbers::pi / 360); }

double aspect(const ViewSettings& settings) { return static_cast<double>(settings.width) / settings.height; }

} // namespace

Ray camera_ray(const View& view, int x, int y) {
    const Axes axes = look_along(view.camera.direction);
    const double tangent = half_tangent(view.camera.fov);
    const double right = (2 * (x + 0.5) / view.settings.width - 1) * tangent * aspect(view.settings);
    const double up = (1 - 2 * (y + 0.5) / view.settings.height) * tangent;
    return {dvec3(view.camera.position), axes.forward + right * axes.right + up * axes.up};
}

Hit first_hit(const Scene& scene, const Ray& ray, double begin, double end, double edge_margin) {
    Hit first{-1, end, false};
    double nearest_unsure = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene.triangles.size(); ++i) {
        const glm::uvec3 corners = scene.triangles[i];
        const dvec3 a(scene.positions[corners.x]);
        const dvec3 ab = dvec3(scene.positions[corners.y]) - a, ac = dvec3(scene.positions[corners.z]) - a;
        const dvec3 normal = glm::cross(ab, ac);
        const double slope = glm::dot(normal, ray.direction);
        if (slope == 0) continue;
        const double t = glm::dot(normal, a - ray.origin) / slope;
        if (!(t > begin && t < end)) continue;
        const dvec3 in_plane = ray.at(t) - a;
        const double v = glm::dot(glm::cross(ab, in_plane), normal) / glm::dot(normal, normal);
        const double u = glm::dot(glm::cross(in_plane, ac), normal) / glm::dot(normal, normal);
        const double inside = std::min({u, v, 1 - u - v});
        if (std::abs(inside) < edge_margin) nearest_unsure = std::min(nearest_unsure, t);
        if (inside >= 0 && t < first.t) first = {static_cast<int>(i), t, false};
    }
    first.unsure = nearest_unsure <= first.t;
    return first;
}

LightSpace::LightSpace(const View& view, const Scene& scene)
    : perspective_(view.light.position.has_value()), side_(view.settings.shadow_map) {
    const Axes axes = look_along(view.light.direction);
    right_ = axes.right;
    up_ = axes.up;
    forward_ = axes.forward;
    const auto along = [&](dvec3 p) {
        return dvec3(glm::dot(right_, p), glm::dot(up_, p), glm::dot(forward_, p));
    };
    const Box box = scene.bounds();
    dvec3 low(1e300), high(-1e300);
    for (int i = 0; i < 8; ++i) {
        const dvec3 corner((i & 1) != 0 ? box.upper.x : box.lower.x, (i & 2) != 0 ? box.upper.y : box.lower.y,
                           (i & 4) != 0 ? box.upper.z : box.lower.z);
        low = glm::min(low, along(corner));
        high = glm::max(high, along(corner));
    }
    if (perspective_) {
        position_ = dvec3(*view.light.position);
        tangent_ = half_tangent(view.light.fov);
        far_ = 1.001 * (high.z - glm::dot(forward_, position_));
        near_ = far_ / 1000;
        return;
    }
    dvec3 seen_low(1e300), seen_high(-1e300);
    for (int i = 0; i < 8; ++i) {
        const double distance = (i & 4) != 0 ? view.camera.far : view.camera.near;
        const Axes camera = look_along(view.camera.direction);
        const double y = half_tangent(view.camera.fov) * distance, x = y * aspect(view.settings);
        const dvec3 corner = dvec3(view.camera.position) + distance * camera.forward +
                             ((i & 1) != 0 ? x : -x) * camera.right + ((i & 2) != 0 ? y : -y) * camera.up;
        seen_low = glm::min(seen_low, along(corner));
        seen_high = glm::max(seen_high, along(corner));
    }
    lower_ = {std::max(low.x, seen_low.x), std::max(low.y, seen_low.y), low.z};
    upper_ = {std::min(high.x, seen_high.x), std::min(high.y, seen_high.y), high.z};
    const dvec3 margin(1e-3 * glm::length(upper_ - lower_));
    lower_ -= margin;
    upper_ += margin;
}

dvec3 LightSpace::project(dvec3 world) const {
    if (perspective_) {
        const dvec3 d = world - position_;
        const double depth = glm::dot(forward_, d);
        return {side_ / 2 * (1 + glm::dot(right_, d) / (depth * tangent_)),
                side_ / 2 * (1 - glm::dot(up_, d) / (depth * tangent_)), (depth - near_) / (far_ - near_)};
    }
    const dvec3 extent = upper_ - lower_;
    return {side_ * (glm::dot(right_, world) - lower_.x) / extent.x,
            side_ * (upper_.y - glm::dot(up_, world)) / extent.y,
            (glm::dot(forward_, world) - lower_.z) / extent.z};
}

Ray LightSpace::ray(glm::dvec2 texels) const {
    const glm::dvec2 share = texels / side_;
    if (perspective_) {
        const dvec3 direction =
            forward_ + (2 * share.x - 1) * tangent_ * right_ + (1 - 2 * share.y) * tangent_ * up_;
        return {position_ + near_ * direction, (far_ - near_) * direction};
    }
    const dvec3 extent = upper_ - lower_;
    return {(lower_.x + share.x * extent.x) * right_ + (upper_.y - share.y * extent.y) * up_ +
                lower_.z * forward_,
            extent.z * forward_};
}

dvec3 LightSpace::to_light(dvec3 world) const {
    return perspective_ ? glm::normalize(position_ - world) : -forward_;
}

dvec3 normal_towards(const Scene& scene, int triangle, dvec3 eye, dvec3 point) {
    const glm::uvec3 corners = scene.triangles[static_cast<std::size_t>(triangle)];
    const dvec3 a(scene.positions[corners.x]);
    const dvec3 normal = glm::normalize(
        glm::cross(dvec3(scene.positions[corners.y]) - a, dvec3(scene.positions[corners.z]) - a));
    return glm::dot(normal, eye - point) < 0 ? -normal : normal;
}

} // namespace gnomon::testing
