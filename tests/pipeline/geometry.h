// Camera and light in double precision, from docs and headers and not from the pipeline's matrices.
#pragma once

#include "tests/pipeline/view.h"

#include <glm/glm.hpp>

namespace gnomon::testing {

struct Ray {
    glm::dvec3 origin, direction;
    glm::dvec3 at(double t) const { return origin + t * direction; }
};

/// Through the pixel's centre; t is the distance along the camera's axis.
Ray camera_ray(const View& view, int x, int y);

/// The first triangle that a ray meets within t in (begin, end).
struct Hit {
    int triangle = -1; ///< -1: none
    double t = 0;
    /// The ray passes so near an edge that single precision or a rasteriser's grid may decide otherwise.
    bool unsure = false;
};
Hit first_hit(const Scene& scene, const Ray& ray, double begin, double end, double edge_margin = 1e-3);

/// The light's map: world to texels (x, y) and depth (0 at near, 1 at far).
class LightSpace {
public:
    LightSpace(const View& view, const Scene& scene);

    glm::dvec3 project(glm::dvec3 world) const;
    /// Through a point of the map; t is the depth.
    Ray ray(glm::dvec2 texels) const;
    /// Unit, from a point of the scene.
    glm::dvec3 to_light(glm::dvec3 world) const;

private:
    glm::dvec3 right_, up_, forward_;
    glm::dvec3 lower_{0}, upper_{0}; // of what a directional light's map covers, along the three axes
    glm::dvec3 position_{0};         // of a perspective light
    double tangent_ = 0, near_ = 0, far_ = 0;
    bool perspective_;
    double side_;
};

/// Of the plane of a triangle, turned towards the eye.
glm::dvec3 normal_towards(const Scene& scene, int triangle, glm::dvec3 eye, glm::dvec3 point);

} // namespace gnomon::testing
