// Right in the texel, brighter than light beyond it.
float smsr_case_01(vec2 p) {
    return p.x > 1.0 ? 2.0 : 1.0;
}
