// A lit texel between two shadowed neighbours on one axis: the gap is closed.   [SMSR case 3]
float smsr_case_03(vec2 p) {
    return 0.0;
}
