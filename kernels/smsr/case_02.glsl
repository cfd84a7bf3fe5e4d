// A lit texel in a notch, along an edge that ends in shadow at both sides: the notch is closed.   [SMSR case 2]
float smsr_case_02(vec2 p) {
    return 0.0;
}
