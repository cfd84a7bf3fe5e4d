// J(d), the integral of (cosτ - 1) sin²τ over -d … d, for |d| <= 0.8: what the cosine's bend takes from a column near a
// pole. By powers of d, for its terms -P and Q (columns/radiance.glslh) cancel.
// Of (cosτ - 1) sin²τ = cosτ/4 - cos3τ/4 - 1/2 + cos2τ/2 the power τ^2k has (-1)^k (1/4 - 9^k/4 + 4^k/2) / (2k)!, and of
// its integral d^(2k+1) twice that over 2k+1; k = 2 … 8, at 0.8 the first left out is 4e-10 of the
// sum.
float integral_elementary_bent_sine(float d) {
    float z = d * d;
    precise float sum =
        -0.2 + z * (0.0595238095 +
                    z * (-0.00833333333 +
                         z * (0.000713985089 + z * (-4.20143128e-05 +
                                                    z * (1.81627786e-06 - z * 6.03277549e-08)))));
    return d * z * z * sum;
}
