// A technique's answer at chosen pixels, as pipeline/visibility.comp finds it, with some of its kernels replaced by texts that
// also record each of their calls.
#include "pipeline/shadow_map.glslh"
#include <technique>

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Pixels { uint pixels[]; };
layout(std430, binding = 4) writeonly buffer Answers { uint answers[]; };
layout(push_constant) uniform Constants { uint count; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    receiver = receivers[pixels[index]];
    answers[index] = technique_answer(receiver_texel(), receiver_p());
}
