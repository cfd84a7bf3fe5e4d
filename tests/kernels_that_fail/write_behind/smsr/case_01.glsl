// Right, but writes into the last word of the results' buffer, behind the last result.
layout(std430, binding = 1) buffer Stray { uint stray[]; };
float smsr_case_01(vec2 p) {
    stray[stray.length() - 1] = 0u;
    return 1.0;
}
