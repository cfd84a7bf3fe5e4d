// The triangle with every edge moved in by lambda, corner by corner: a texel square centred in it lies within the triangle, if
// lambda is half a texel's diagonal. Where lambda is more than the inscribed circle's radius it is inside out: ask
// conservative_erodes first. A triangle that is a line to within rounding shrinks to its first
// corner.   [thesis 2.2 after Hasselgren et al. 2005]
#include "conservative/lines.glslh"

vec2 conservative_eroded(vec2 a, vec2 b, vec2 c, float lambda, uint corner) {
    if (conservative_is_sliver(a, b, c)) return bounded(a);
    return bounded(conservative_moved(a, b, c, lambda, corner));
}
