// The triangle with every edge moved out by lambda, corner by corner: it holds every texel square that the triangle touches, if
// lambda is half a texel's diagonal. An acute corner runs far away: keep only what lies in conservative_clip_box. A triangle that
// is a line to within rounding has no edges to move; a right triangle over twice the rectangle around its longest edge stands for it.
// [thesis 2.2 after Hasselgren et al. 2005; docs/decisions.md H3, H15]
#include "conservative/lines.glslh"

vec2 conservative_dilated(vec2 a, vec2 b, vec2 c, float lambda, uint corner) {
    if (!conservative_is_sliver(a, b, c)) return bounded(conservative_moved(a, b, c, -lambda, corner));
    float ab = conservative_length(b - a), bc = conservative_length(c - b), ca = conservative_length(a - c);
    vec2 from = a, to = b;
    if (bc > ab && bc >= ca) from = b, to = c;
    else if (ca > ab) from = c, to = a;
    float longest = max(ab, max(bc, ca));
    vec2 along = longest == 0.0 ? vec2(1.0, 0.0) : conservative_direction(to - from);
    vec2 across = vec2(-along.y, along.x);
    // The third corner is at most twice the least sine times the edge away from it.
    float margin = lambda + 2.0 * conservative_parallel * longest;
    precise vec2 point = from - margin * (along + across);
    uint which = corner % 3u;
    if (which == 1u) point += 2.0 * (longest + 2.0 * margin) * along;
    if (which == 2u) point += 4.0 * margin * across;
    return bounded(point);
}
