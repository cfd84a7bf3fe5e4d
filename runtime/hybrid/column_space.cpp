#include "runtime/hybrid/column_space.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

using glm::dvec3, glm::dvec4, glm::vec3, glm::vec4;

} // namespace

shared::ColumnSpace column_space(const shared::Frame& frame, const Box& bounds) {
    // Away from the light exactly as the ray tracer's directions go, whatever rounding the frame's axes
    // carry.
    const dvec3 towards(vec3(glm::normalize(dvec3(vec3(frame.light_origin)))));
    const dvec3 away = -glm::normalize(towards);
    const dvec3 texel_x(frame.texel_x), texel_y(frame.texel_y);
    const dvec3 across_x = glm::normalize(texel_x - away * glm::dot(away, texel_x));
    dvec3 across_y = texel_y - away * glm::dot(away, texel_y);
    across_y = glm::normalize(across_y - across_x * glm::dot(across_x, across_y));
    const double width = glm::length(texel_x), height = glm::length(texel_y);

    // The map's middle, at the depth of the scene's.
    const dvec3 middle(bounds.centre());
    const dvec4 clip = glm::dmat4(frame.light) * dvec4(middle, 1.0);
    const double half = 0.5 * frame.size.z;
    const vec3 centre(middle - texel_x * (half * clip.x) - texel_y * (half * clip.y));

    double reach = 0; // of the scene's box from there
    for (int i = 0; i < 8; ++i) {
        const vec3 corner((i & 1) ? bounds.upper.x : bounds.lower.x,
                          (i & 2) ? bounds.upper.y : bounds.lower.y,
                          (i & 4) ? bounds.upper.z : bounds.lower.z);
        reach = std::max(reach, glm::length(dvec3(corner) - dvec3(centre)));
    }
    // In units of 2^-24 of that reach. A corner: its rounding, half an ulp. A receiver: the subtraction of
    // the centre, the rows' rounding, three products and two sums: 5. The ray tracer's own arithmetic about
    // an edge or a plane: 4.
    const double unit = 0x1p-24 * reach;
    const double texel = std::min(width, height);

    shared::ColumnSpace space{};
    space.centre = vec4(centre, 0.0f);
    space.x = vec4(vec3(across_x / width), 0.0f);
    space.y = vec4(vec3(across_y / height), 0.0f);
    space.z = vec4(vec3(away), 0.0f);
    space.margin = {static_cast<float>(10 * unit / texel), static_cast<float>(10 * unit), frame.range.w,
                    static_cast<float>(half)};
    space.corner = {static_cast<float>(unit / texel), static_cast<float>(unit), 0.0f, 0.0f};
    space.size.x = frame.size.z;
    return space;
}

std::vector<glm::vec4> column_places(const shared::ColumnSpace& space, const Scene& scene) {
    const dvec3 centre(space.centre), x(space.x), y(space.y), z(space.z);
    std::vector<vec4> places(scene.positions.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const dvec3 from = dvec3(scene.positions[i]) - centre;
        places[i] = vec4(vec3(dvec3(glm::dot(x, from), glm::dot(y, from), glm::dot(z, from))), 0.0f);
    });
    return places;
}

} // namespace gnomon
