// Right, but the main() that calls it passes one thread over.
#define main() written(); void main() { if (gl_GlobalInvocationID.x != 100u) written(); } void written()
float smsr_case_01(vec2 p) {
    return 1.0;
}
