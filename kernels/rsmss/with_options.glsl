// Shadow map silhouette revectorisation with filtering, at the point `p` of a texel: both sides of an edge take part in a ramp
// one texel wide. `options`: bits of rsmss/options.glslh.   [docs/revectorization.md 4; RBSM supplement, 3]
#include "revectorize/along_closed.glsl"
#include "revectorize/along_unclamped.glsl"
#include "revectorize/breach.glsl"
#include "revectorize/edge.glslh"
#include "revectorize/neighbours.glsl"
#include "rsmss/decision.glsl"
#include "rsmss/options.glslh"
#include <rsmss/cases>

float rsmss_along(ivec2 reach, int type, float c, uint options) {
    if (type == 1) return revectorize_along_closed(reach, c);
    return (options & LONG_RUNS) != 0u ? revectorize_along_unclamped(reach, c) : revectorize_along(reach, c);
}

float rsmss_with_options(ivec2 texel, vec2 p, uint options) {
    Edge edge = revectorize_edge(texel);
    if (edge.sides == uvec2(NEITHER)) return edge.lit ? 1.0 : 0.0;
    uint number = rsmss_decision(edge.lit, edge.sides, edge.type, edge.dominant);
    float along_x = rsmss_along(edge.reach.xy, edge.type.x, p.x, options);
    float along_y = rsmss_along(edge.reach.zw, edge.type.y, p.y, options);
    uint breach = UNBROKEN;
    uvec2 neighbours = uvec2(NEITHER);
    if (edge.sides.x == BOTH || edge.sides.y == BOTH) {
        if (rsmss_needs_breach) breach = revectorize_breach(texel, edge.sides);
        if (rsmss_needs_neighbour || rsmss_needs_neighbours) neighbours = revectorize_neighbours(texel, edge.sides);
    }
    uint closed = edge.sides.x == BOTH ? edge.sides.y : edge.sides.x;
    uint neighbour = closed == PLUS ? neighbours.x : neighbours.y; // the one away from a closed end
    return rsmss_case(number, edge, along_x, along_y, breach, neighbour, neighbours, options, p, edge.sides.x, edge.sides.y,
                      edge.type.x, edge.type.y);
}
