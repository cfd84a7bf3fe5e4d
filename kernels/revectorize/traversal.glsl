// The signed lengths of the four walks from a texel: towards -x, +x, -y, +y.   [docs/revectorization.md 1.1; RBSSM supplement, algorithm 1]
#include "revectorize/walk.glsl"

ivec4 revectorize_traversal(ivec2 texel, uvec2 sides) {
    return ivec4(revectorize_walk(texel, sides, ivec2(-1, 0)), revectorize_walk(texel, sides, ivec2(1, 0)),
                 revectorize_walk(texel, sides, ivec2(0, -1)), revectorize_walk(texel, sides, ivec2(0, 1)));
}
