// e^x, the same bits on every device, denormal results included. Above 88.72 the largest float, below -104 zero.
// [Taylor, Cody and Waite]
float integral_elementary_exp(float x) {
    // NaN compares false: it becomes 0 here, and is the callers' to answer.
    float within = x >= -104.0 ? min(x, 88.72) : x < -104.0 ? -104.0 : 0.0;
    float count = floor(within * 1.44269504 + 0.5);
    // ln 2 in two parts, the first of 9 bits, so that its product with the count is exact.
    precise float r = (within - count * 0.693359375) + count * 2.12194440e-4;
    // At ln 2 / 2 the first term left out is 5e-9.
    precise float sum =
        ((((1.98412698e-4 * r + 1.38888889e-3) * r + 8.33333333e-3) * r + 4.16666667e-2) * r + 0.166666667) * r + 0.5;
    precise float power = 1.0 + (r + r * r * sum);
    // 2^count in two factors: one alone leaves the range of normal floats.
    int half_count = int(count) >> 1;
    float scale = uintBitsToFloat(uint(half_count + 127) << 23);
    float other = uintBitsToFloat(uint(int(count) - half_count + 127) << 23);
    precise float result = power * scale * other;
    return result;
}
