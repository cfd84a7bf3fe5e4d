// A one-texel step whose y side is +y: the diagonal of the texel, dark towards the corner of the two sides.   [SMSR case 6]
float smsr_case_06(vec2 p, float along_x) {
    return 1.0 - along_x < p.y ? 0.0 : 1.0;
}
