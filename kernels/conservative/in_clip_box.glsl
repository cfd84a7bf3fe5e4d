// Whether p lies in the box (smallest x and y, then largest), its border included.   [thesis fig. 8]
bool conservative_in_clip_box(vec2 p, vec4 box) {
    return p.x >= box.x && p.y >= box.y && p.x <= box.z && p.y <= box.w;
}
