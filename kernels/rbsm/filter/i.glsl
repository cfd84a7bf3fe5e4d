// An I: the edge ends nowhere, so the texel keeps its shadow test.   [Optimized RBSM 2017, listing 5]
float rbsm_filter_i(bool entering) {
    return entering ? 1.0 : 0.0;
}
