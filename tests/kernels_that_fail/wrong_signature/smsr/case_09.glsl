// Takes a vector where its table declares a number.
float smsr_case_09(vec2 p, vec2 along) {
    return 1.0 - p.y < along.x ? 0.0 : 1.0;
}
