// A lit texel shadowed on all four sides is closed.   [RSMSS case 2]
float rsmss_case_02(vec2 p) {
    return 0.0;
}
