// A lit texel beside an edge without an end: nothing to filter on this side.   [RSMSS case 1]
float rsmss_case_01(vec2 p) {
    return 1.0;
}
