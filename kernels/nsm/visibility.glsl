// Plain shadow mapping: the nearest texel's shadow test, the same over the whole texel.   [Williams 1978]
#include "revectorize/lit.glslh"

float nsm_visibility(ivec2 texel, vec2 p) {
    return lit(texel) ? 1.0 : 0.0;
}
