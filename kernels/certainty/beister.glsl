// What the four texels diagonally next to this one say together: 0 certainly shadowed, 1 certainly lit, 2 uncertain, to be traced.
// p does not matter: nearest taps one texel away in x and in y are these four wherever in the texel they begin.
// [Beister et al. 2005 as the thesis measured it: docs/hybrid.md]
#include "revectorize/lit.glslh"

uint certainty_beister(ivec2 texel, vec2 p) {
    int votes = int(lit(texel + ivec2(-1, -1))) + int(lit(texel + ivec2(1, -1))) + int(lit(texel + ivec2(-1, 1))) +
                int(lit(texel + ivec2(1, 1)));
    return votes == 0 ? 0u : votes == 4 ? 1u : 2u;
}
