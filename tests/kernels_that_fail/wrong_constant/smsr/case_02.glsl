// Lights what it should darken.
float smsr_case_02(vec2 p) {
    return 1.0;
}
