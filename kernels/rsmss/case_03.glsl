// A shadowed texel lit on all four sides is opened.   [RSMSS case 3]
float rsmss_case_03(vec2 p) {
    return 1.0;
}
