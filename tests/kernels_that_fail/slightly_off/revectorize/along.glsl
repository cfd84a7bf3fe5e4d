// Right up to a thousandth.
float revectorize_along(ivec2 reach, float c) {
    float from_end = reach.y > 0 ? float(reach.y) - c : float(abs(reach.x) - 1) + c;
    float run = min(float(abs(reach.x) + abs(reach.y) - 1), 16.0);
    return clamp(1.001 - from_end / run, 0.0, 1.0);
}
