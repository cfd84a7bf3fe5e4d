// Not a number in a corner of the texel.
float smsr_case_03(vec2 p) {
    return p.x > 0.5 && p.y > 0.5 ? uintBitsToFloat(0x7fc00000u) : 0.0;
}
