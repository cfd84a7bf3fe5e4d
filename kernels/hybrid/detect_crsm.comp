// What the maps of grown and of shrunken triangles say together of every pixel that faces the light: the receiver's own depth
// against the texel that holds it and the four diagonally next to that one.   [thesis ch. 4; hybrid.md, convention 9]
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"
#include "hybrid/state.glslh"
#include "certainty/crsm.glsl"
#include "revectorize/shadow_test.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) readonly buffer Big { float big[]; };
layout(std430, binding = 3) readonly buffer Small { float small[]; };
layout(std430, binding = 4) writeonly buffer States { uint states[]; };
layout(std430, binding = 5) writeonly buffer Visibility { float visibility[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    vec4 at = receivers[index].map;
    int side = int(frame.size.z);
    uint state = at.w == 1.0 ? LIT : SHADOWED;
    // Both maps hold what casts on a receiver within them only.
    if (state == LIT && (any(lessThan(at.xy, vec2(0.0))) || any(greaterThanEqual(at.xy, vec2(side))))) {
        state = UNCERTAIN;
    } else if (state == LIT) {
        ivec2 texel = ivec2(floor(at.xy));
        uvec4 big_diagonal, small_diagonal;
        for (int i = 0; i < 4; ++i) {
            ivec2 tap = clamp(texel + ivec2(i % 2 == 0 ? -1 : 1, i < 2 ? -1 : 1), ivec2(0), ivec2(side - 1));
            big_diagonal[i] = uint(revectorize_shadow_test(at.z, frame.range.z, big[tap.y * side + tap.x]));
            small_diagonal[i] = uint(revectorize_shadow_test(at.z, frame.range.z, small[tap.y * side + tap.x]));
        }
        state = certainty_crsm(uint(revectorize_shadow_test(at.z, frame.range.z, big[texel.y * side + texel.x])), big_diagonal,
                               small_diagonal);
    }
    states[index] = state;
    visibility[index] = state == LIT ? 1.0 : 0.0;
}
