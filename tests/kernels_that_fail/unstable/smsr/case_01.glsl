// Answers by what was in memory before: another value in every run.
layout(std430, binding = 1) buffer Before { uint before[]; };
float smsr_case_01(vec2 p) {
    return (before[0] & 0x80000000u) != 0u ? 1.0 : 0.0;
}
