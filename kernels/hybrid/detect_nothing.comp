// Certain of nothing: every pixel that faces the light needs a ray.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"
#include "hybrid/state.glslh"

layout(local_size_x = 8, local_size_y = 8) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) writeonly buffer States { uint states[]; };
layout(std430, binding = 3) writeonly buffer Visibility { float visibility[]; };

void main() {
    uvec2 pixel = gl_GlobalInvocationID.xy;
    if (any(greaterThanEqual(pixel, frame.size.xy))) return;
    uint index = pixel.y * frame.size.x + pixel.x;
    states[index] = receivers[index].map.w == 1.0 ? UNCERTAIN : SHADOWED;
    visibility[index] = 0.0;
}
