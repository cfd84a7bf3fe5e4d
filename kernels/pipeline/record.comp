// A technique's answer at chosen pixels, as pipeline/visibility.comp finds it, with one of its kernels replaced by a text that
// also records each of its calls.
#include "pipeline/record.glslh"
#include "pipeline/shadow_map.glslh"
#include <technique>

layout(local_size_x = 64) in;
layout(std430, binding = 3) readonly buffer Pixels { uint pixels[]; };
layout(std430, binding = 6) writeonly buffer Counts { uint counts[]; };
layout(std430, binding = 7) writeonly buffer Answers { uint answers[]; };
layout(push_constant) uniform Constants { uint count; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    receiver = receivers[pixels[index]];
    record_next = firsts[index];
    record_end = firsts[index + 1u];
    answers[index] = technique_answer(receiver_texel(), receiver_p());
    counts[index] = record_next - firsts[index];
}
