// The shape of a texel's edge, as silhouette/decision numbers it; 0 where the texel is shadowed or nothing around it differs.   [Optimized RBSM 2017, figure 2]
#include "rbsm/silhouette/decision.glsl"
#include "revectorize/edge.glslh"

uint rbsm_silhouette_number(ivec2 texel) {
    if (!lit(texel)) return 0u;
    Edge edge = revectorize_edge(texel);
    return rbsm_silhouette_decision(edge.sides, edge.type);
}
