// A semicolon is missing on line 4.
float smsr_case_09(vec2 p, float along_x) {
    float distance = 1.0 - p.y;
    float result = 1.0
    return distance < along_x ? 0.0 : result;
}
