// revectorize_along without its limit of 16 texels on the run's length: long runs keep their slope to the texel where the
// walk gives up, and jump there.   [docs/decisions.md, A7]
float revectorize_along_unclamped(ivec2 reach, float c) {
    precise float from_end = reach.y > 0 ? float(reach.y) - c : float(abs(reach.x) - 1) + c;
    precise float position = 1.0 - from_end / float(abs(reach.x) + abs(reach.y) - 1);
    return clamp(position, 0.0, 1.0);
}
