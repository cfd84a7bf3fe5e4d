// A lit texel whose only shadowed neighbour lies towards +x: dark between that side and the line from the run's end to its
// beginning.   [SMSR case 12]
float smsr_case_12(vec2 p, float along_y) {
    return 1.0 - p.x < along_y ? 0.0 : 1.0;
}
