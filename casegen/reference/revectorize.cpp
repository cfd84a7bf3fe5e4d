#include "casegen/reference/revectorize.h"

#include <algorithm>
#include <cstdlib>

namespace gnomon::reference {
namespace {

bool lit(const Mask& mask, glm::ivec2 texel) { return mask.lit(texel.x, texel.y); }

/// Side bits of one axis from the two neighbours along `step`.
unsigned sides_along(const Mask& mask, glm::ivec2 texel, glm::ivec2 step) {
    const bool here = lit(mask, texel);
    return (lit(mask, texel - step) != here ? minus : neither) |
           (lit(mask, texel + step) != here ? plus : neither);
}

} // namespace

glm::uvec2 discontinuity(const Mask& mask, glm::ivec2 texel) {
    return {sides_along(mask, texel, {1, 0}), sides_along(mask, texel, {0, 1})};
}

int walk(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides, glm::ivec2 heading) {
    const glm::ivec2 across(heading.y != 0, heading.x != 0);
    const unsigned run = heading.x != 0 ? sides.y : sides.x;
    for (int k = 1; k <= longest_walk; ++k) {
        const glm::ivec2 reached = texel + k * heading;
        if (lit(mask, reached) != lit(mask, texel)) return k;
        if ((sides_along(mask, reached, across) & run) == 0) return -k;
    }
    return -(longest_walk + 1);
}

glm::ivec4 traversal(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides) {
    return {walk(mask, texel, sides, {-1, 0}), walk(mask, texel, sides, {1, 0}),
            walk(mask, texel, sides, {0, -1}), walk(mask, texel, sides, {0, 1})};
}

int edge_type(glm::ivec2 reach) {
    const int ends = (reach.x > 0 ? 1 : 0) + (reach.y > 0 ? 1 : 0);
    return ends - 1;
}

double along(glm::ivec2 reach, double c) {
    const double length = std::min(std::abs(reach.x) + std::abs(reach.y) - 1, longest_walk);
    const double to_end = std::max(reach.x, reach.y); // the positive one
    const double p_o = reach.y > 0 ? c : 1 - c;       // measured towards the end
    return std::clamp(1 - to_end / length + p_o / length, 0.0, 1.0);
}

double along_unclamped(glm::ivec2 reach, double c) {
    const double length = std::abs(reach.x) + std::abs(reach.y) - 1;
    const double from_beginning = reach.y > 0 ? std::abs(reach.x) - 1 + c : std::abs(reach.y) - c;
    return std::clamp(from_beginning / length, 0.0, 1.0);
}

double along_closed(glm::ivec2 reach, double c) {
    const double length = std::min(std::abs(reach.x) + std::abs(reach.y) - 1, longest_walk);
    const double middle =
        0.5 * (std::abs(reach.y) - std::abs(reach.x) + 1); // of the run, seen from this texel
    const double half = 0.5 * (std::abs(reach.x) + std::abs(reach.y) - 1);
    return std::clamp((half - std::abs(c - middle)) / length, 0.0, 1.0);
}

glm::bvec2 dominance(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides) {
    const auto single = [](unsigned side) { return side == minus || side == plus; };
    if (!single(sides.x) || !single(sides.y)) return glm::bvec2(false);
    // o_rg = (8 (0.5 - d_c) - 1) o; the neighbours are (x - o_r, y) and (x, y + o_g), in the printed codes.
    const double dc_r = sides.x == minus ? 0.5 : 0.25, dc_g = sides.y == plus ? 0.5 : 0.25;
    const int o_r = static_cast<int>(8 * (0.5 - dc_r) - 1), o_g = static_cast<int>(8 * (0.5 - dc_g) - 1);
    return {sides_along(mask, {texel.x, texel.y + o_g}, {1, 0}) != 0,
            sides_along(mask, {texel.x - o_r, texel.y}, {0, 1}) != 0};
}

glm::uvec2 neighbours(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides) {
    const bool across_x = sides.x == both;
    const glm::ivec2 across(across_x, !across_x), step(!across_x, across_x);
    return {sides_along(mask, texel - step, across), sides_along(mask, texel + step, across)};
}

unsigned breach(const Mask& mask, glm::ivec2 texel, glm::uvec2 sides) {
    const bool across_x = sides.x == both;
    const glm::ivec2 across(across_x, !across_x), step(!across_x, across_x);
    const unsigned closed = across_x ? sides.y : sides.x;
    // Each way by itself: how far its breach is, and which walls are left there.
    struct Found {
        int distance = longest_walk + 1;
        unsigned walls = unbroken;
    };
    const auto follow = [&](int direction) {
        for (int k = 1; k <= longest_walk; ++k) {
            const glm::ivec2 reached = texel + direction * k * step;
            if (lit(mask, reached) != lit(mask, texel)) break;
            if (const unsigned walls = sides_along(mask, reached, across); walls != both)
                return Found{k, walls};
        }
        return Found{};
    };
    const Found towards_minus = (closed & minus) != 0 ? Found{} : follow(-1);
    const Found towards_plus = (closed & plus) != 0 ? Found{} : follow(+1);
    if (towards_minus.distance != towards_plus.distance)
        return towards_minus.distance < towards_plus.distance ? towards_minus.walls : towards_plus.walls;
    if (towards_minus.walls == towards_plus.walls) return towards_minus.walls;
    if (towards_minus.walls == neither || towards_plus.walls == neither) return neither;
    return both;
}

Edge edge(const Mask& mask, glm::ivec2 texel) {
    Edge e;
    e.sides = discontinuity(mask, texel);
    e.reach = traversal(mask, texel, e.sides);
    e.type = {edge_type({e.reach.x, e.reach.y}), edge_type({e.reach.z, e.reach.w})};
    e.dominant = dominance(mask, texel, e.sides);
    e.lit = lit(mask, texel);
    return e;
}

} // namespace gnomon::reference
