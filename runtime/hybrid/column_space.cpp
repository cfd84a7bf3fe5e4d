#include "runtime/hybrid/column_space.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace gnomon {

using glm::dvec2, glm::dvec3, glm::dvec4, glm::vec3, glm::vec4;

shared::ColumnSpace column_space(const shared::Frame& frame, const Box& receivers) {
    // Away from the light exactly as the ray tracer's directions go, whatever rounding the frame's axes
    // carry.
    const dvec3 towards(vec3(glm::normalize(dvec3(vec3(frame.light_origin)))));
    const dvec3 away = -glm::normalize(towards);
    const dvec3 texel_x(frame.texel_x), texel_y(frame.texel_y);
    const dvec3 across_x = glm::normalize(texel_x - away * glm::dot(away, texel_x));
    dvec3 across_y = texel_y - away * glm::dot(away, texel_y);
    across_y = glm::normalize(across_y - across_x * glm::dot(across_x, across_y));
    const double width = glm::length(texel_x), height = glm::length(texel_y);

    // Amid the receivers, moved onto a corner of the map's texels. What rounding leaves of the way there
    // moves the whole grid, by a ten-thousandth of a texel or so.
    const dvec3 middle(receivers.centre());
    const dvec4 clip = glm::dmat4(frame.light) * dvec4(middle, 1.0);
    const double half = 0.5 * frame.size.z;
    const dvec2 texels = half * (dvec2(clip) + 1.0), corner = glm::round(texels);
    const vec3 centre(middle + texel_x * (corner.x - texels.x) + texel_y * (corner.y - texels.y));

    double reach = 0; // of the receivers from there
    for (int i = 0; i < 8; ++i) {
        const vec3 point((i & 1) ? receivers.upper.x : receivers.lower.x,
                         (i & 2) ? receivers.upper.y : receivers.lower.y,
                         (i & 4) ? receivers.upper.z : receivers.lower.z);
        reach = std::max(reach, glm::length(dvec3(point) - dvec3(centre)));
    }
    // In units of 2^-24 of the distance from the centre. A receiver: the subtraction of the centre, the rows'
    // rounding, three products and two sums: 5. A corner: half an ulp, 1. What the ray tracer subtracts and
    // multiplies about an edge or a plane grows with the corner's distance from the receiver: 4 of both.
    const double unit = 0x1p-24, texel = std::min(width, height);
    const auto of = [&](double units, double distance) {
        return static_cast<float>(units * unit * distance);
    };

    shared::ColumnSpace space{};
    space.centre = vec4(centre, 0.0f);
    space.x = vec4(vec3(across_x / width), 0.0f);
    space.y = vec4(vec3(across_y / height), 0.0f);
    space.z = vec4(vec3(away), 0.0f);
    const dvec2 begin = -corner, end = begin + static_cast<double>(frame.size.z);
    space.map = vec4(dvec4(begin, end));
    space.receiver = {of(9, reach / texel), of(9, reach), frame.eye.w, 0.0f};
    space.corner = {of(5, 1 / texel), of(5, 1), of(2, 1 / texel), of(2, 1)};
    space.size.x = frame.size.z;
    return space;
}

std::vector<glm::vec4> column_places(const shared::ColumnSpace& space, const Scene& scene) {
    const dvec3 centre(space.centre), x(space.x), y(space.y), z(space.z);
    std::vector<vec4> places(scene.positions.size());
    tbb::parallel_for(std::size_t{0}, places.size(), [&](std::size_t i) {
        const dvec3 from = dvec3(scene.positions[i]) - centre;
        places[i] = vec4(dvec4(glm::dot(x, from), glm::dot(y, from), glm::dot(z, from), glm::length(from)));
    });
    return places;
}

} // namespace gnomon
