// An I: the edge ends nowhere, so the lit texel stays lit.   [Optimized RBSM 2017, listing 4]
float rbsm_silhouette_i(vec2 p) {
    return 1.0;
}
