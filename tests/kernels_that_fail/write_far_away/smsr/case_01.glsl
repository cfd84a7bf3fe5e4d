// Right, but writes a gigabyte behind its buffer: the device must drop it.
layout(std430, binding = 1) buffer Stray { uint stray[]; };
float smsr_case_01(vec2 p) {
    stray[0x10000000u] = 1u;
    return 1.0;
}
