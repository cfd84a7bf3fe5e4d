// For every texel that holds a receiver, by its slot: the eight triangles of its column that reach nearest to the light, and how near
// the ninth does. Equally near ones in the order of their numbers, so that the lists' order does not matter.
//                                                                                       [hybrid.md, sound classifiers: nearest-8]
#include "column/depth_bounds.glsl"
#include "hybrid/columns.glslh"
#include "hybrid/nearest.glslh"
#include "hybrid/solid.glslh"
#include "pipeline/frame.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) readonly buffer Farthest { uint farthest[]; };
layout(std430, binding = 4) readonly buffer Heads { uint heads[]; };
layout(std430, binding = 5) readonly buffer Nodes { uvec2 nodes[]; };
layout(std430, binding = 6) writeonly buffer NearestOf { Nearest nearest_of[]; };
layout(std430, binding = 7) readonly buffer Frames { Frame frame; };
layout(std430, binding = 8) readonly buffer Receivers { Receiver receivers[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint slot = pixel.y * frame.size.x + pixel.x;
    if (farthest[slot] == 0u) return; // no texel's slot
    vec2 centre = texel_centre(texel_of(to_column(receivers[slot].origin.xyz).xy));
    float depths[KEPT];
    Nearest nearest;
    for (int i = 0; i < KEPT; ++i) {
        depths[i] = 1.0 / 0.0;
        nearest.triangles[i] = NO_NODE;
    }
    nearest.next = 1.0 / 0.0;
    int length = 0;
    for (uint node = heads[slot]; node != NO_NODE; node = nodes[node].y) {
        if (++length > LONGEST) nearest.next = -1.0 / 0.0; // whatever else there is
        if (length > LONGEST) break;
        uint triangle = nodes[node].x;
        Solid t = solid(triangle);
        float depth = column_depth_bounds(t.p[0], t.p[1], t.p[2], centre, half_texel(t), t.margin).x - t.margin_z;
        // Sink it into the sorted eight; what falls out is the ninth so far.
        for (int i = 0; i < KEPT; ++i) {
            bool before = depth < depths[i] || depth == depths[i] && triangle < nearest.triangles[i];
            if (!before) continue;
            float d = depths[i];
            uint other = nearest.triangles[i];
            depths[i] = depth;
            nearest.triangles[i] = triangle;
            depth = d;
            triangle = other;
        }
        nearest.next = min(nearest.next, depth);
    }
    nearest_of[slot] = nearest;
}
