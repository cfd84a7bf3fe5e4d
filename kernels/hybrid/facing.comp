// Whether any pixel faces the light. Every thread looks through a run of pixels, until one of them has found one; the threads of a
// group begin far apart, so that over most frames the first group ends at once and the others do not begin.
#include "pipeline/frame.glslh"
#include "pipeline/receiver.glslh"

layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(std430, binding = 1) readonly buffer Receivers { Receiver receivers[]; };
layout(std430, binding = 2) volatile buffer Found { uint found; }; // set to 0 before

void main() {
    uint pixels = frame.size.x * frame.size.y, groups = gl_NumWorkGroups.x;
    uint length = (pixels + 64u * groups - 1u) / (64u * groups);
    uint begin = (gl_LocalInvocationID.x * groups + gl_WorkGroupID.x) * length;
    for (uint i = begin; i < min(begin + length, pixels); ++i) {
        if (found != 0u) return;
        if (receivers[i].map.w != 1.0) continue;
        atomicOr(found, 1u);
        return;
    }
}
