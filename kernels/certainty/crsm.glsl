// What the maps of grown (big) and shrunken (small) triangles say together: 1 certainly lit if the big one's centre and diagonal
// tests are all lit, 0 certainly shadowed if the small one's diagonal tests and the big one's centre are all in shadow, else 2,
// uncertain, to be traced. Tests are 0 in shadow. CRSMA asks the same of its own small map.   [thesis ch. 4; docs/hybrid.md]
uint certainty_crsm(uint big_centre, uvec4 big_diagonal, uvec4 small_diagonal) {
    if (big_centre != 0u && all(notEqual(big_diagonal, uvec4(0u)))) return 1u;
    if (big_centre == 0u && all(equal(small_diagonal, uvec4(0u)))) return 0u;
    return 2u;
}
