// The integral of φ sin(φ + p) over φ0 … φ1: m C1 and what is odd about the middle m.
// [Appendix B, Equation 7, C3; docs/integrals.md, section 3]
// A reversed interval negates the result; inputs that are not finite: 0, or the largest float if they overflow.
#include "integral/guard.glslh"
#include "integral/sinc/wave.glslh"

// Half the integral of t sin t over -h … h. It is sin h - h cos h, h³/3 near 0, where the difference would lose it.
// Taylor: at 1 the first term left out is 1e-9.
float odd_part(float h) {
    float z = h * h;
    precise float series =
        h * z * (0.333333333 + z * (-3.33333333e-2 + z * (1.19047619e-3 + z * (-2.20458554e-5 + z * 2.50521084e-7))));
    vec2 turned = turn(h);
    float difference = turned.y - h * turned.x;
    return abs(h) < 1.0 ? series : difference;
}

float sinc_c3(float phi0, float phi1, float p) {
    float m = 0.5 * (phi0 + phi1), h = 0.5 * (phi1 - phi0);
    precise float sum = m * wave_of_sin(m, h, 1.0, p) + 2.0 * cosine(m + p) * odd_part(h);
    return sum;
}

float integral_sinc_c3(float phi0, float phi1, float p) {
    if (!is_finite(vec3(phi0, phi1, p))) return 0.0;
    return bounded(sinc_c3(phi0, phi1, p));
}
