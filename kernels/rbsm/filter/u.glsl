// A U: closed along one axis, so the ramp lies along the other; where that one ends nowhere the whole texel is turned round.
// [Optimized RBSM 2017, listing 5]
float rbsm_filter_u(float along_x, float along_y, ivec2 type, bool entering) {
    float along = clamp(type.x == 1 ? along_y : along_x, 0.0, 1.0);
    return entering ? 1.0 - along : along;
}
