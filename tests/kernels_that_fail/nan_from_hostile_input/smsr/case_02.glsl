// Right wherever the input is, but hands on an input that is not a number.
float smsr_case_02(vec2 p) {
    return isnan(p.x) ? p.x : 0.0;
}
