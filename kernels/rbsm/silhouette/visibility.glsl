// Shadow map silhouette revectorisation by the shape of an edge: four functions for SMSR's twelve cases.
// [Optimized RBSM 2017, listing 4]
#include "rbsm/along.glslh"
#include "rbsm/silhouette/decision.glsl"
#include "revectorize/edge.glslh"
#include <rbsm/silhouette/cases>

float rbsm_silhouette_visibility(ivec2 texel, vec2 p) {
    if (!lit(texel)) return 0.0;
    Edge edge = revectorize_edge(texel);
    uint number = rbsm_silhouette_decision(edge.sides, edge.type);
    float along_x = rbsm_along(edge.reach.xy, edge.type.x, p.x);
    float along_y = rbsm_along(edge.reach.zw, edge.type.y, p.y);
    return rbsm_silhouette_case(number, edge, along_x, along_y, p);
}
