// P(d) = d - sin d without its cancellation, for |d| <= 0.8: half the integral of 1 - cosτ over -d … d.   [Taylor]
float integral_elementary_missing_of_sine(float d) {
    float z = d * d;
    // At 0.8 the first term left out is 3e-8 of the sum.
    return d * z * (0.166666667 + z * (-8.33333333e-3 + z * (1.98412698e-4 - z * 2.75573192e-6)));
}
