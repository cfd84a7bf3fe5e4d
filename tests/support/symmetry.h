// Transposition and mirror images, of masks, texels, points and case numbers.
#pragma once

#include "casegen/mask.h"
#include "casegen/reference/revectorize.h"

#include <ostream>
#include <utility>

namespace gnomon::testing {

struct Symmetry {
    const char* name;
    Mask (*of_mask)(const Mask& mask);
    glm::ivec2 (*of_texel)(const Mask& mask, glm::ivec2 texel);
    glm::dvec2 (*of_point)(glm::dvec2 p);
    /// The case of the image of a texel with `sides`.
    unsigned (*of_number)(unsigned number, glm::uvec2 sides);
};
inline std::ostream& operator<<(std::ostream& out, const Symmetry& symmetry) { return out << symmetry.name; }

namespace detail {

inline unsigned exchange(unsigned number, std::initializer_list<std::pair<unsigned, unsigned>> pairs) {
    for (const auto& [a, b] : pairs) {
        if (number == a) return b;
        if (number == b) return a;
    }
    return number;
}

} // namespace detail

inline const Symmetry symmetries[] = {
    {"transposed", transposed, [](const Mask&, glm::ivec2 t) { return glm::ivec2(t.y, t.x); },
     [](glm::dvec2 p) { return glm::dvec2(p.y, p.x); },
     [](unsigned number, glm::uvec2 sides) {
         // A lone step is numbered by its y side, which was the x side.
         if (number == 6 || number == 7) return sides.x == reference::plus ? 6u : 7u;
         return detail::exchange(number, {{4, 5}, {9, 12}, {10, 11}});
     }},
    {"mirrored_x", mirrored_x,
     [](const Mask& mask, glm::ivec2 t) { return glm::ivec2(mask.width - 1 - t.x, t.y); },
     [](glm::dvec2 p) { return glm::dvec2(1 - p.x, p.y); },
     [](unsigned number, glm::uvec2) {
         return detail::exchange(number, {{11, 12}});
     }},
    {"mirrored_y", mirrored_y,
     [](const Mask& mask, glm::ivec2 t) { return glm::ivec2(t.x, mask.height - 1 - t.y); },
     [](glm::dvec2 p) { return glm::dvec2(p.x, 1 - p.y); },
     [](unsigned number, glm::uvec2) {
         return detail::exchange(number, {{6, 7}, {9, 10}});
     }},
};

} // namespace gnomon::testing
