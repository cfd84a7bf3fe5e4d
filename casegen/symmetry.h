// Transposition and mirror images, of masks, texels, points and case numbers: what revectorisation must not
// depend on.
#pragma once

#include "casegen/mask.h"
#include "casegen/reference/revectorize.h"

#include <ostream>
#include <utility>

namespace gnomon {

struct Symmetry {
    const char* name;
    Mask (*of_mask)(const Mask& mask);
    glm::ivec2 (*of_texel)(const Mask& mask, glm::ivec2 texel);
    glm::dvec2 (*of_point)(glm::dvec2 p);
    /// SMSR's case of the image of a texel with `sides`.
    unsigned (*of_number)(unsigned number, glm::uvec2 sides);
    /// RSMSS's; of the shapes of RBSM an image has the same one.
    unsigned (*of_rsmss_number)(unsigned number);
};
inline std::ostream& operator<<(std::ostream& out, const Symmetry& symmetry) { return out << symmetry.name; }

inline unsigned exchange_numbers(unsigned number,
                                 std::initializer_list<std::pair<unsigned, unsigned>> pairs) {
    for (const auto& [a, b] : pairs) {
        if (number == a) return b;
        if (number == b) return a;
    }
    return number;
}

inline const Symmetry symmetries[] = {
    {"transposed", transposed, [](const Mask&, glm::ivec2 t) { return glm::ivec2(t.y, t.x); },
     [](glm::dvec2 p) { return glm::dvec2(p.y, p.x); },
     [](unsigned number, glm::uvec2 sides) {
         // A lone step is numbered by its y side, which was the x side.
         if (number == 6 || number == 7) return sides.x == reference::plus ? 6u : 7u;
         return exchange_numbers(number, {{4, 5}, {9, 12}, {10, 11}});
     },
     [](unsigned number) {
         return exchange_numbers(number, {{4, 6},
                                          {5, 7},
                                          {8, 10},
                                          {9, 11},
                                          {12, 14},
                                          {13, 15},
                                          {16, 17},
                                          {20, 21},
                                          {22, 23},
                                          {24, 25},
                                          {28, 29},
                                          {30, 31}});
     }},
    {"mirrored_x", mirrored_x,
     [](const Mask& mask, glm::ivec2 t) { return glm::ivec2(mask.width - 1 - t.x, t.y); },
     [](glm::dvec2 p) { return glm::dvec2(1 - p.x, p.y); },
     [](unsigned number, glm::uvec2) {
         return exchange_numbers(number, {{11, 12}});
     },
     [](unsigned number) { return number; }},
    {"mirrored_y", mirrored_y,
     [](const Mask& mask, glm::ivec2 t) { return glm::ivec2(t.x, mask.height - 1 - t.y); },
     [](glm::dvec2 p) { return glm::dvec2(p.x, 1 - p.y); },
     [](unsigned number, glm::uvec2) {
         return exchange_numbers(number, {{6, 7}, {9, 10}});
     },
     [](unsigned number) { return number; }},
};

} // namespace gnomon
