// For every texel that holds a receiver, by its slot: how far away the nearest sheet of triangles is that covers it. Triangles are
// connected where they share an edge and lie on opposite sides of it; a sheet covers the square if each of its edges that touch the
// square has such a neighbour: a point at the border of what is covered would lie on an edge with only one side. That the square's middle
// is covered says that the sheet reaches into it at all.                                   [hybrid.md, sound classifiers: sheet]
#include "column/coverage.glsl"
#include "column/depth_bounds.glsl"
#include "column/touches.glsl"
#include "hybrid/columns.glslh"
#include "hybrid/solid.glslh"
#include "hybrid/rings.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) readonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 4) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 5) readonly buffer Nodes { uvec2 nodes[]; };
layout(std430, binding = 6) readonly buffer Rings { uint next_half_edge[]; };
layout(std430, binding = 7) writeonly buffer Sheets { float sheets[]; }; // depth; infinite: none
layout(std430, binding = 8) readonly buffer Frames { Frame frame; };
layout(std430, binding = 9) readonly buffer Receivers { Receiver receivers[]; };

#define MOST 40 // triangles of one sheet over one texel; a sheet of more is given up

uint next_of(uint half_edge) { return next_half_edge[half_edge]; }

int edges = 0; // looked at by all sheets of this texel
#define MOST_EDGES 512

/// The depth of the sheet that holds `start`; infinite if it does not cover the texel or is not nearer than `worth`.
float sheet_from(uint start, vec2 centre, float worth) {
    float depth = -1.0 / 0.0;
    uint members[MOST];
    members[0] = start;
    int count = 1;
    for (int i = 0; i < count; ++i) {
        Solid t = solid(members[i]);
        float half_side = half_texel(t);
        depth = max(depth, column_depth_bounds(t.p[0], t.p[1], t.p[2], centre, half_side, t.margin).y + t.margin_z);
        if (!(depth < worth)) return 1.0 / 0.0;
        for (uint k = 0u; k < 3u; ++k) {
            if (++edges > MOST_EDGES) return 1.0 / 0.0;
            if (!column_touches(t.p[k].xy, t.p[(k + 1u) % 3u].xy, centre, half_side)) continue;
            uint neighbour = across(members[i], t, k);
            if (neighbour == NO_NODE) return 1.0 / 0.0;
            bool known = false;
            for (int j = 0; j < count && !known; ++j) known = members[j] == neighbour;
            if (known) continue;
            if (count == MOST) return 1.0 / 0.0;
            members[count++] = neighbour;
        }
    }
    return depth;
}

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint slot = pixel.y * frame.size.x + pixel.x;
    if (farthest[slot] == 0u) return; // no texel's slot
    vec2 centre = texel_centre(texel_of(to_column(receivers[slot].origin.xyz).xy));
    // A sheet farther than every receiver shadows none.
    float least = from_ordered(farthest[slot]) - space.receiver.z, best = least;
    int length = 0;
    for (uint node = heads[slot]; node != NO_NODE && length < LONGEST; node = nodes[node].y, ++length) {
        Solid t = solid(nodes[node].x);
        if (column_coverage(t.p[0].xy, t.p[1].xy, t.p[2].xy, centre, t.margin) == 0u)
            best = min(best, sheet_from(nodes[node].x, centre, best));
    }
    sheets[slot] = best < least ? best : 1.0 / 0.0;
}
