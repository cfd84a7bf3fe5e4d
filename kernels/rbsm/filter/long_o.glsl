// A long O: ends at both sides along both axes, not all next to the texel: turned round.   [Optimized RBSM 2017, listing 5]
float rbsm_filter_long_o(bool entering) {
    return entering ? 0.0 : 1.0;
}
