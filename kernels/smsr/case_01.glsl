// A lit texel along an edge that ends at neither side: nothing to straighten, the texel stays lit.   [SMSR case 1]
float smsr_case_01(vec2 p) {
    return 1.0;
}
