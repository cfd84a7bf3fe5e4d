#include "casegen/hybrid/exact_ray.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <array>
#include <cmath>

namespace gnomon::hybrid {
namespace {

using Rational = boost::multiprecision::cpp_rational;

template <typename T>
using Vector = std::array<T, 3>;

template <typename T>
Vector<T> as(glm::vec3 v) {
    return {T(v.x), T(v.y), T(v.z)};
}
template <typename T>
Vector<T> minus(const Vector<T>& p, const Vector<T>& q) {
    return {p[0] - q[0], p[1] - q[1], p[2] - q[2]};
}
template <typename T>
Vector<T> cross(const Vector<T>& p, const Vector<T>& q) {
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}
template <typename T>
T dot(const Vector<T>& p, const Vector<T>& q) {
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

/// What decides: on which side of the ray each edge passes, how steeply the ray meets the plane, and how far
/// beyond tmin, times that.
template <typename T>
std::array<T, 5> terms(const Ray& ray, std::span<const glm::vec3, 3> triangle) {
    const Vector<T> origin = as<T>(ray.origin), direction = as<T>(ray.direction);
    std::array<Vector<T>, 3> p;
    for (std::size_t i = 0; i < 3; ++i) p[i] = minus(as<T>(triangle[i]), origin);
    const Vector<T> normal = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    const T steep = dot(normal, direction);
    return {dot(direction, cross(p[0], p[1])), dot(direction, cross(p[1], p[2])),
            dot(direction, cross(p[2], p[0])), steep, dot(normal, p[0]) - T(ray.tmin) * steep};
}

template <typename T>
int sign(const T& x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}

bool meets_by(const std::array<int, 5>& signs) {
    const int turn = signs[3];
    return turn != 0 && signs[0] * turn >= 0 && signs[1] * turn >= 0 && signs[2] * turn >= 0 &&
           signs[4] * turn > 0;
}

} // namespace

bool meets(const Ray& ray, std::span<const glm::vec3, 3> triangle) {
    const std::array<double, 5> rough = terms<double>(ray, triangle);
    double farthest = std::abs(static_cast<double>(ray.tmin));
    for (const glm::vec3& p : triangle)
        for (int axis = 0; axis < 3; ++axis)
            farthest = std::max(farthest, std::abs(static_cast<double>(p[axis])) +
                                              std::abs(static_cast<double>(ray.origin[axis])));
    // Some ten roundings of products of three, one a direction's, of which there are eighteen.
    const double wrong = 0x1p-53 * 1024 * farthest * farthest * (1 + farthest);
    std::array<int, 5> signs{};
    bool all_known = true;
    for (std::size_t i = 0; i < 5; ++i) {
        signs[i] = sign(rough[i]);
        all_known = all_known && std::abs(rough[i]) > wrong;
    }
    if (all_known) return meets_by(signs);
    // Known to pass beside it: two edges on different sides.
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t k = (i + 1) % 3;
        if (std::abs(rough[i]) > wrong && std::abs(rough[k]) > wrong && signs[i] != signs[k]) return false;
    }
    const std::array<Rational, 5> exact = terms<Rational>(ray, triangle);
    for (std::size_t i = 0; i < 5; ++i) signs[i] = sign(exact[i]);
    return meets_by(signs);
}

bool meets(const Ray& ray, const Scene& scene) {
    for (const glm::uvec3 each : scene.triangles) {
        const std::array<glm::vec3, 3> triangle{scene.positions[each.x], scene.positions[each.y],
                                                scene.positions[each.z]};
        if (meets(ray, std::span<const glm::vec3, 3>(triangle))) return true;
    }
    return false;
}

} // namespace gnomon::hybrid
