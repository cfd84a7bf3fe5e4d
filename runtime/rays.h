// Ray-traced visibility: the truth that shadow maps are judged against.
#pragma once

#include "runtime/scene.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// A bounding-volume hierarchy over a scene's triangles (Embree, robust mode, both faces of every triangle).
class RayTracer {
public:
    /// Copies what it needs. Throws Error if Embree reports one (out of memory, say). `embree_options` are
    /// what rtcNewDevice takes: "isa=sse2" traces as on a processor without wider vectors.
    explicit RayTracer(const Scene& scene, const std::string& embree_options = {});
    ~RayTracer();
    RayTracer(RayTracer&&) noexcept;
    RayTracer& operator=(RayTracer&&) noexcept;

    /// For every receiver i: 1 if the open segment from origins[i] towards the light meets no triangle, else
    /// 0. Directional light: `to_light(i)` = -direction, unbounded. Point light: up to the light's position.
    /// `origins` are in world units; hits nearer than `tmin` (world units, > 0) are ignored, so that a
    /// receiver does not shadow itself. Receivers with active[i] == 0 are skipped and get 1. Packets of 16,
    /// all cores; the result does not depend on the number of threads. Throws Error if `tmin`, the light or
    /// an active origin is not usable (not finite, no direction).
    std::vector<std::uint8_t> visible_along(std::span<const glm::vec3> origins,
                                            std::span<const std::uint8_t> active,
                                            glm::vec3 direction_to_light, float tmin) const;
    std::vector<std::uint8_t> visible_from(std::span<const glm::vec3> origins,
                                           std::span<const std::uint8_t> active, glm::vec3 light_position,
                                           float tmin) const;
    /// The same for a ray buffer: all are active, w does not matter.
    std::vector<std::uint8_t> visible_along(std::span<const glm::vec4> origins, glm::vec3 direction_to_light,
                                            float tmin) const;
    std::vector<std::uint8_t> visible_from(std::span<const glm::vec4> origins, glm::vec3 light_position,
                                           float tmin) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
