// sin x, the same bits on every device. Beyond |x| = 65536: 0.   [Taylor, Cody and Waite]
#include "integral/elementary/sine_ahead.glslh"

float integral_elementary_sin(float x) { return sine_ahead(x, 0u); }
