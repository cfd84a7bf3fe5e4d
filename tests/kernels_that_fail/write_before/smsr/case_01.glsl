// Right, but writes into the first word of the results' buffer, before the first result.
layout(std430, binding = 1) buffer Stray { uint stray[]; };
float smsr_case_01(vec2 p) {
    if (p.x < 0.01) stray[0] = 1u;
    return 1.0;
}
