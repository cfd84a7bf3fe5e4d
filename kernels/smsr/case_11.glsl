// A lit texel whose only shadowed neighbour lies towards -x: dark between that side and the line from the run's end to its
// beginning.   [SMSR case 11]
float smsr_case_11(vec2 p, float along_y) {
    return p.x < along_y ? 0.0 : 1.0;
}
