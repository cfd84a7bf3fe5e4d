// The RSMSS case at a texel of a map: 1 to 31; 0 where it keeps its shadow test.   [docs/revectorization.md 4]
#include "revectorize/edge.glslh"
#include "rsmss/decision.glsl"

uint rsmss_number(ivec2 texel) {
    Edge edge = revectorize_edge(texel);
    return rsmss_decision(edge.lit, edge.sides, edge.type, edge.dominant);
}
