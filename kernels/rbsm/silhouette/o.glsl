// An O: shadow at both ends along both axes closes the texel.   [Optimized RBSM 2017, listing 4]
float rbsm_silhouette_o(vec2 p) {
    return 0.0;
}
