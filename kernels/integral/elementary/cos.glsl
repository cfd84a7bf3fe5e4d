// cos x, the same bits on every device. Beyond |x| = 65536: 1.   [Taylor, Cody and Waite]
#include "integral/elementary/sine_ahead.glslh"

float integral_elementary_cos(float x) { return sine_ahead(x, 1u); }
