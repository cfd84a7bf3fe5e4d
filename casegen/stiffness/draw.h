// What the generators of stiff inputs draw with.
#pragma once

#include "casegen/stiffness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gnomon::stiffness {

constexpr double pi = std::numbers::pi;
constexpr double most_turns =
    1000; ///< whole turns that φ is moved by: beyond 8192 radians no float knows its sine
constexpr double sharpest = 1e6; ///< λq
using Span = std::span<double>;

inline double uniform(Random& random, double lower, double upper) {
    return lower + (upper - lower) * random.unit();
}
inline double over_decades(Random& random, double lower, double upper) {
    return std::exp(uniform(random, std::log(lower), std::log(upper)));
}
inline double either(Random& random, double value) { return random.chance(0.5) ? -value : value; }
/// A distance that is not the same on both sides, nor at both ends.
inline double about(Random& random, double distance) {
    return either(random, distance * uniform(random, 0.5, 1));
}
inline double inverse(double distance, double most) {
    return distance > 0 ? std::min(1 / distance, most) : most;
}

inline glm::dvec3 direction(Random& random) {
    const double z = uniform(random, -1, 1), phi = uniform(random, -pi, pi), u = std::sqrt(1 - z * z);
    return {u * std::cos(phi), u * std::sin(phi), z};
}
inline glm::dvec3 direction(double phi, double theta) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
inline void put(Span to, glm::dvec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

inline bool is_polar(double theta) { return theta >= -1e-5 && theta <= pi + 1e-5; }
/// What the device sees of it.
inline double as_float(double number) { return static_cast<double>(static_cast<float>(number)); }

/// An axis at a distance from a part of a cell: lit cells are tried with the same as cells alone (axes.cpp).
struct AxisLocus {
    const char* name;
    glm::dvec3 (*axis)(Random&, double d, double phi, double half, double theta0, double theta1);
};
std::span<const AxisLocus> axis_loci();

} // namespace gnomon::stiffness
