// The parameters that kernels of revectorisation share. One name means one thing everywhere: inputs computed
// from masks are matched to parameters by it (Facts).
#pragma once

#include "casegen/kernel_case.h"

namespace gnomon::vocabulary {

using reference::both, reference::minus, reference::neither, reference::plus;

inline Parameter p() {
    return {"p", {0, 1, {}}, "texels", "position within the texel, growing with x and y"};
}
inline Parameter along_x() {
    return {
        "along_x", {0, 1, {}}, "1", "position along the run in x: 1 at its end, 0 at its beginning (d_on.r)"};
}
inline Parameter along_y() {
    return {
        "along_y", {0, 1, {}}, "1", "position along the run in y: 1 at its end, 0 at its beginning (d_on.g)"};
}
inline Parameter side_x() {
    return {"side_x",
            {0, 0, {{minus}, {plus}}},
            "bits",
            "side on which the x neighbour differs: 1 -x, 2 +x (d_c.r)"};
}
inline Parameter side_y() {
    return {"side_y",
            {0, 0, {{minus}, {plus}}},
            "bits",
            "side on which the y neighbour differs: 1 -y, 2 +y (d_c.g)"};
}
inline Parameter sides() {
    return {"sides",
            {0, 3, {}},
            "bits",
            "sides that differ along x and y: 0 neither, 1 minus, 2 plus, 3 both (d_c.rg)"};
}
inline Parameter texel() {
    return {"texel", {-1e4, 1e4, {}}, "texels", "column and row in the map; beyond it the surround answers"};
}
inline Parameter type() {
    return {"type", {-1, 1, {}}, "1", "ends of the runs along x and y: 1 both, 0 one, -1 none (t_h, t_v)"};
}
inline Parameter type_x() {
    return {"type_x", {0, 0, {{0}, {1}}}, "1", "ends of the run along x: 1 both, 0 one (t_h)"};
}
inline Parameter type_y() {
    return {"type_y", {0, 0, {{0}, {1}}}, "1", "ends of the run along y: 1 both, 0 one (t_v)"};
}
inline Parameter entering() { return {"entering", {0, 1, {}}, "1", "whether the texel is lit (1 - d_c.b)"}; }
inline Parameter neighbours() {
    return {"neighbours",
            {0, 3, {}},
            "bits",
            "sides across the slot or bar of the texels next along it, towards - and + (n(d_c))"};
}
inline Parameter neighbour() {
    return {"neighbour",
            {0, 3, {}},
            "bits",
            "sides across the slot or bar of the texel next along it, away from its closed end"};
}
inline Parameter breach() {
    return {"breach",
            {0, 4, {}},
            "bits",
            "sides left where the slot or bar loses a wall; 3 each way another, 4 nowhere (d_cb)"};
}
inline Parameter options() {
    return {"options", {0, 127, {}}, "bits", "readings of the document, as in kernels/rsmss/options.glslh"};
}
inline Parameter dominant() {
    return {"dominant",
            {0, 1, {}},
            "1",
            "whether the x side's and the y side's edge go on beyond a corner (D_r, D_g)"};
}
inline Parameter reach() {
    return {"reach",
            {-(reference::longest_walk + 1), reference::longest_walk, {}},
            "texels",
            "walks towards - and +: positive to an end, negative to a beginning, never 0"};
}
inline Parameter c() { return {"c", {0, 1, {}}, "texels", "position within the texel along the run"}; }
inline Parameter heading() {
    return {"heading", {0, 0, {{-1, 0}, {1, 0}, {0, -1}, {0, 1}}}, "texels", "the step of the walk"};
}

} // namespace gnomon::vocabulary
