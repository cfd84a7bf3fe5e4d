// Keeps of a grown triangle what lies in the box around it.   [thesis fig. 8; hybrid.md, convention 9]
#include "pipeline/frame.glslh"
#include "conservative/in_clip_box.glsl"

layout(std430, binding = 0) readonly buffer Frames { Frame frame; };
layout(location = 0) flat in vec4 box;

void main() {
    if (!conservative_in_clip_box(gl_FragCoord.xy * (2.0 / float(frame.size.z)) - 1.0, box)) discard;
}
