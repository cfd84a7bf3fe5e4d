// A ray against triangles without rounding: doubles where their error bound decides, rationals where it does
// not.
#pragma once

#include "runtime/scene.h"

#include <span>

namespace gnomon::hybrid {

/// origin + t direction, tmin < t.
struct Ray {
    glm::vec3 origin, direction;
    float tmin = 0;
};

/// Whether the ray meets the closed triangle, from either face. A triangle in whose plane the ray lies is not
/// met.
bool meets(const Ray& ray, std::span<const glm::vec3, 3> triangle);

/// Any triangle of the scene.
bool meets(const Ray& ray, const Scene& scene);

} // namespace gnomon::hybrid
