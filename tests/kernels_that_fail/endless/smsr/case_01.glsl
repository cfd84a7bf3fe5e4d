// Never ends. (Lavapipe leaves a loop after 65535 turns, so a turn must be long for it to seem endless.)
vec2 turn(vec2 s) {
    for (int i = 0; i < 16; ++i) s = fract(sin(s.yx * 3.7) + exp(s) + log(abs(s) + 1.0) + cos(s));
    return s;
}
float smsr_case_01(vec2 p) {
    vec2 s = p;
    while (s.x != 2.0) s = turn(s);
    return s.x;
}
