// Depth along the light's axis, linear for a perspective light too: the shadow test's bias then means one distance everywhere.
layout(location = 0) in float depth;

void main() {
    gl_FragDepth = depth;
}
