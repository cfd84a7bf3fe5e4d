// The ends of a run along one axis: +1 it ends at both, -1 at neither, 0 at exactly one.   [docs/revectorization.md 1.2; Optimized RBSM 2017, equation 5]
// `reach` holds the walks towards - and towards +.
int revectorize_edge_type(ivec2 reach) {
    bool minus = reach.x > 0;
    bool plus = reach.y > 0;
    if (minus && plus) return 1;
    if (!minus && !plus) return -1;
    return 0;
}
