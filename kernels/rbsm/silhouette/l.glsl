// An L: dark towards the corner where its two ends meet, up to the line between its beginnings; along the axis across an edge
// a run is one texel, so that the same line cuts straight edges and corners.   [Optimized RBSM 2017, listing 4]
float rbsm_silhouette_l(float along_x, float along_y) {
    return 1.0 - along_y < along_x ? 0.0 : 1.0;
}
