// Whether c and d lie certainly on opposite sides of the line ab, each coordinate within `margin` of its true one: two triangles
// over ab then cover both sides of it. Projected sides, not winding: a fold has both on one side, whichever way its faces wind.
//                                                                                       [hybrid.md, sound classifiers: sheet, pitfalls]
bool column_opposite(vec2 a, vec2 b, vec2 c, vec2 d, float margin) {
    precise vec2 ab = b - a, ac = c - a, ad = d - a;
    precise float on_c = ab.x * ac.y - ab.y * ac.x, on_d = ab.x * ad.y - ab.y * ad.x;
    vec2 across = vec2(abs(ac.x) + abs(ac.y), abs(ad.x) + abs(ad.y));
    float along = abs(ab.x) + abs(ab.y);
    // Moving all points by the margin turns |ab| and moves c against it. And the arithmetic's own: differences, products and theirs carry
    // four roundings of the products, which are no more than along * across: twice that. And what vanishes below 2^-126, six times at most.
    vec2 unsure = 2.0 * margin * (along + across) + 4.76837158203125e-7 * along * across + 1e-37;
    return on_c > unsure.x && on_d < -unsure.y || on_c < -unsure.x && on_d > unsure.y;
}
