// A lit texel whose only shadowed neighbour lies towards -y: dark between that side and the line from the run's end to its
// beginning.   [SMSR case 10]
float smsr_case_10(vec2 p, float along_x) {
    return p.y < along_x ? 0.0 : 1.0;
}
