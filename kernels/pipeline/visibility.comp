// A technique's answer for every pixel that faces the light. What the shadow map does not cover is lit.
#include "pipeline/shadow_map.glslh"
#include "revectorize/left_out.glslh"
#include <technique>

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 3) writeonly buffer Visibility { float visibility[]; };
layout(std430, binding = 4) buffer LeftOut { uint pixels_left_out; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    receiver = receivers[index];
    float result = receiver.map.w == 1.0 ? 1.0 : 0.0;
    if (result == 1.0 && receiver_in_map()) result = technique_visibility(receiver_texel(), receiver_p());
    visibility[index] = result;
    if (case_left_out) atomicAdd(pixels_left_out, 1u);
}
