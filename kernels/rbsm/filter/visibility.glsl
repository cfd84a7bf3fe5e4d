// Filtering revectorisation by the shape of an edge: five functions for RSMSS's 31 cases.   [Optimized RBSM 2017, listing 5]
#include "rbsm/along.glslh"
#include "rbsm/filter/decision.glsl"
#include "revectorize/edge.glslh"
#include <rbsm/filter/cases>

float rbsm_filter_visibility(ivec2 texel, vec2 p) {
    Edge edge = revectorize_edge(texel);
    uint number = rbsm_filter_decision(edge.sides, edge.type);
    float along_x = rbsm_along(edge.reach.xy, edge.type.x, p.x);
    float along_y = rbsm_along(edge.reach.zw, edge.type.y, p.y);
    return rbsm_filter_case(number, edge, along_x, along_y, edge.lit, edge.type);
}
