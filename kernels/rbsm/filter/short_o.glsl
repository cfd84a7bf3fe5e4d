// A short O, one texel with an edge on all four sides: turned round.   [Optimized RBSM 2017, listing 5]
float rbsm_filter_short_o(bool entering) {
    return entering ? 0.0 : 1.0;
}
