// For every texel that holds a receiver: how far away the nearest sheet of triangles is that covers it. Triangles are connected where
// they share an edge and lie on opposite sides of it; a sheet covers the square if each of its edges that touch the square has such a
// neighbour: a point at the border of what is covered would lie on an edge with only one side.   [hybrid.md, sound classifiers: sheet]
#include "column/depth_bounds.glsl"
#include "column/opposite.glsl"
#include "column/touches.glsl"
#include "hybrid/columns.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 1) readonly buffer Places { vec4 places[]; };
layout(std430, binding = 2) readonly buffer Triangles { uint indices[]; };
layout(std430, binding = 3) readonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 4) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 5) readonly buffer Nodes { uvec2 nodes[]; };
layout(std430, binding = 6) readonly buffer Rings { uint next_half_edge[]; }; // round the same edge; 3 triangle + edge
layout(std430, binding = 7) writeonly buffer Sheets { float sheets[]; };      // depth; infinite: none

#define MOST 40 // triangles of one sheet over one texel; a sheet of more is given up

vec3 place(uint triangle, uint k) { return places[indices[3u * triangle + k]].xyz; }

/// Certainly within: all three edges pass the point on the same side.
bool contains(vec2 a, vec2 b, vec2 c, vec2 p) {
    precise vec2 pa = a - p, pb = b - p, pc = c - p, ab = pb - pa, bc = pc - pb, ca = pa - pc;
    precise vec3 at = vec3(pa.x * ab.y - pa.y * ab.x, pb.x * bc.y - pb.y * bc.x, pc.x * ca.y - pc.y * ca.x);
    vec3 unsure = 2.0 * space.margin.x * (abs(vec3(ab.x, bc.x, ca.x)) + abs(vec3(ab.y, bc.y, ca.y)));
    return all(greaterThan(at, unsure)) || all(lessThan(at, -unsure));
}

/// The neighbour across edge k of the triangle that lies on the edge's other side; NO_NODE if there is none.
uint across(uint triangle, uint k, vec2 a, vec2 b, vec2 c) {
    uint self = 3u * triangle + k;
    int turns = 0; // an edge of very many triangles is no sheet's
    for (uint h = next_half_edge[self]; h != self && turns < 16; h = next_half_edge[h], ++turns) {
        vec2 d = place(h / 3u, (h % 3u + 2u) % 3u).xy;
        if (column_opposite(a, b, c, d, space.margin.x)) return h / 3u;
    }
    return NO_NODE;
}

float sheet_from(uint start, vec2 centre, float worth) {
    float half_side = 0.5 + 2.0 * space.margin.x, depth = -1.0 / 0.0;
    uint members[MOST];
    members[0] = start;
    int count = 1;
    for (int i = 0; i < count; ++i) {
        uint triangle = members[i];
        vec3 p[3] = vec3[](place(triangle, 0u), place(triangle, 1u), place(triangle, 2u));
        depth = max(depth, column_depth_bounds(p[0], p[1], p[2], centre, half_side, space.margin.x).y);
        if (!(depth < worth)) return 1.0 / 0.0;
        for (uint k = 0u; k < 3u; ++k) {
            vec2 a = p[k].xy, b = p[(k + 1u) % 3u].xy, c = p[(k + 2u) % 3u].xy;
            if (!column_touches(a, b, centre, half_side)) continue;
            uint neighbour = across(triangle, k, a, b, c);
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
    ivec2 texel = ivec2(gl_GlobalInvocationID.xy);
    if (!in_map(texel)) return;
    uint index = texel_index(texel);
    if (farthest[index] == 0u) return;
    // A sheet farther than every receiver shadows none.
    float best = from_ordered(farthest[index]) - space.margin.z;
    bool found = false;
    vec2 centre = texel_centre(texel);
    for (uint node = heads[index]; node != NO_NODE; node = nodes[node].y) {
        uint triangle = nodes[node].x;
        if (!contains(place(triangle, 0u).xy, place(triangle, 1u).xy, place(triangle, 2u).xy, centre)) continue;
        float depth = sheet_from(triangle, centre, best);
        if (depth < best) {
            best = depth;
            found = true;
        }
    }
    sheets[index] = found ? best : 1.0 / 0.0;
}
