// The box around the triangle grown by lambda on every side, smallest x and y first: what a dilated triangle is clipped to,
// whose acute corners reach beyond every texel that the triangle touches.   [thesis fig. 8; Hasselgren et al. 2005]
#include "conservative/lines.glslh"

vec4 conservative_clip_box(vec2 a, vec2 b, vec2 c, float lambda) {
    precise vec2 lower = min(a, min(b, c)) - lambda;
    precise vec2 upper = max(a, max(b, c)) + lambda;
    return vec4(bounded(lower), bounded(upper));
}
