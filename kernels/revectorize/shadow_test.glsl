// Lit where nothing lies nearer to the light than the receiver; equal depths are lit.   [Optimized RBSM 2017, equation 1]
// The bias moves the receiver towards the light, so that a surface does not shadow itself by rounding.
bool revectorize_shadow_test(float receiver, float bias, float occluder) {
    return receiver - bias <= occluder;
}
