// The comparison is turned round.
float smsr_case_09(vec2 p, float along_x) {
    return 1.0 - p.y > along_x ? 0.0 : 1.0;
}
