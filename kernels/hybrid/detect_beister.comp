// What taps of one shadow map say together of every pixel that faces the light: <certainty> holds certainty_of_taps(texel, p).
// What the map does not cover is lit, as for every technique of one map.   [hybrid.md, convention 8]
#include "pipeline/shadow_map.glslh"
#include "hybrid/state.glslh"
#include <certainty>

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) writeonly buffer States { uint states[]; };
layout(std430, binding = 4) writeonly buffer Visibility { float visibility[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    receiver = receivers[index];
    uint state = receiver.map.w == 1.0 ? LIT : SHADOWED;
    if (state == LIT && receiver_in_map()) state = certainty_of_taps(receiver_texel(), receiver_p());
    states[index] = state;
    visibility[index] = state == LIT ? 1.0 : 0.0;
}
