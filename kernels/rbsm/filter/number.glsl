// The shape of a texel's edge, as filter/decision numbers it; 0 where nothing around it differs.   [Optimized RBSM 2017, figure 2]
#include "rbsm/filter/decision.glsl"
#include "revectorize/edge.glslh"

uint rbsm_filter_number(ivec2 texel) {
    Edge edge = revectorize_edge(texel);
    return rbsm_filter_decision(edge.sides, edge.type);
}
