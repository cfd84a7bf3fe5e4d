// Where a point lies along a run that ends on one side: 1 at its end, 0 at its beginning, linear between: one component of
// d_on. `reach` holds the walks towards - and +, `c` the point's position within its texel along the same axis.
// Runs longer than 16 texels are taken as 16 long from their end, so that they fade instead of jumping where walks give up.
// [docs/revectorization.md 1.3; docs/decisions.md, A7; RBSM 2016, equation 1]
float revectorize_along(ivec2 reach, float c) {
    float longest = 16.0;
    precise float from_end = reach.y > 0 ? float(reach.y) - c : float(abs(reach.x) - 1) + c;
    float run = min(float(abs(reach.x) + abs(reach.y) - 1), longest);
    precise float position = 1.0 - from_end / run; // the same bits wherever this file is included
    return clamp(position, 0.0, 1.0);
}
