// Whether c and d lie certainly on opposite sides of the line ab, each coordinate within `margin` of its true one: two triangles
// over ab then cover both sides of it. Projected sides, not winding: a fold has both on one side, whichever way its faces wind.
//                                                                                       [hybrid.md, sound classifiers: sheet, pitfalls]
bool column_opposite(vec2 a, vec2 b, vec2 c, vec2 d, float margin) {
    precise vec2 ab = b - a, ac = c - a, ad = d - a;
    precise float on_c = ab.x * ac.y - ab.y * ac.x, on_d = ab.x * ad.y - ab.y * ad.x;
    float along = abs(ab.x) + abs(ab.y);
    // Moving all points by the margin turns |ab| and moves c against it.
    float unsure_c = 2.0 * margin * (along + abs(ac.x) + abs(ac.y)), unsure_d = 2.0 * margin * (along + abs(ad.x) + abs(ad.y));
    return on_c > unsure_c && on_d < -unsure_d || on_c < -unsure_c && on_d > unsure_d;
}
