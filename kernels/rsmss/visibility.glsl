// RSMSS with the options that the assembly was made for.   [docs/revectorization.md 4; RBSM supplement, 3]
#include "rsmss/with_options.glsl"
#include <rsmss/options>

float rsmss_visibility(ivec2 texel, vec2 p) {
    return rsmss_with_options(texel, p, RSMSS_OPTIONS);
}
