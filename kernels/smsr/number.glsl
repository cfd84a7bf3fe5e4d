// The SMSR case at a texel of a map: 1 to 12; 0 where the texel is shadowed or nothing around it differs.   [docs/revectorization.md 2]
#include "revectorize/edge.glslh"
#include "smsr/decision.glsl"

uint smsr_number(ivec2 texel) {
    if (!lit(texel)) return 0u;
    Edge edge = revectorize_edge(texel);
    return smsr_decision(edge.sides, edge.type, edge.dominant);
}
