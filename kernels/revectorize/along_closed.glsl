// Where a point lies along a run that ends on both sides: its distance from the nearer end as part of the run, 0 to 0.5.
// `reach` holds the walks towards - and +, `c` the point's position within its texel along the same axis.
// Only one printed form of case 5 and 7 asks for it.   [RBSM 2016, equation 1; docs/decisions.md, A3]
float revectorize_along_closed(ivec2 reach, float c) {
    float run = min(float(abs(reach.x) + abs(reach.y) - 1), 16.0);
    precise float from_minus = float(abs(reach.x) - 1) + c;
    precise float from_plus = float(abs(reach.y)) - c;
    precise float position = min(from_minus, from_plus) / run;
    return clamp(position, 0.0, 1.0);
}
