// The same by the rule that the thesis's counts follow: nothing is left either where an edge, before or after, is shorter than
// 2 lambda. After is enough: erosion shortens every edge.   [docs/decisions.md H12]
#include "conservative/eroded_edges.glslh"

bool conservative_erodes_as_published(vec2 a, vec2 b, vec2 c, float lambda) {
    ConservativeEdges edges = conservative_eroded_edges(a, b, c, lambda);
    if (!conservative_keep_direction(edges)) return false;
    for (int i = 0; i < 3; ++i)
        if (conservative_length(edges.after[i]) < 2.0 * edges.lambda) return false;
    return true;
}
