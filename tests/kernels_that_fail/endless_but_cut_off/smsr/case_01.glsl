// Never ends, but its turns are short: lavapipe leaves it after 65535 of them, with whatever it has then.
float smsr_case_01(vec2 p) {
    float s = p.x;
    while (s != 2.0) s = fract(s * 3.7 + 0.1);
    return s;
}
