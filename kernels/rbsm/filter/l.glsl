// An L: the ramp runs across the line between its beginnings, lit texels lighter and shadowed ones darker the farther they
// are from the corner where its two ends meet.   [Optimized RBSM 2017, listing 5]
float rbsm_filter_l(float along_x, float along_y, bool entering) {
    precise float distance = (1.0 - along_x) + (1.0 - along_y);
    return clamp(entering ? distance : 1.0 - distance, 0.0, 1.0);
}
