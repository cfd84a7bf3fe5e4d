// Shadow map silhouette revectorisation at the point `p` of a texel: shadow stays shadow, lit texels beside it are cut along
// the straightened edge.   [docs/revectorization.md 2; RBSM supplement, 2]
#include "revectorize/edge.glslh"
#include "smsr/decision.glsl"
#include <smsr/cases>

float smsr_visibility(ivec2 texel, vec2 p) {
    if (!lit(texel)) return 0.0;
    Edge edge = revectorize_edge(texel);
    uint number = smsr_decision(edge.sides, edge.type, edge.dominant);
    float along_x = revectorize_along(edge.reach.xy, p.x);
    float along_y = revectorize_along(edge.reach.zw, p.y);
    return smsr_case(number, edge, along_x, along_y, p, edge.sides.x, edge.sides.y);
}
