// A U: shadow at both ends along one axis closes the texel.   [Optimized RBSM 2017, listing 4]
float rbsm_silhouette_u(vec2 p) {
    return 0.0;
}
