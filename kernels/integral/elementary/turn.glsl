// The point of the unit circle at the angle x: (cos x, sin x), the same bits on every device.   [Taylor, Cody and Waite]
#include "integral/elementary/sine_ahead.glslh"

// Drivers find what both have in common: it takes as long as one written for both.
vec2 integral_elementary_turn(float x) { return vec2(sine_ahead(x, 1u), sine_ahead(x, 0u)); }
