// The integral of 1 over φ0 … φ1.   [Appendix B, Equation 7, C0]
float integral_printed_c0(float phi0, float phi1) { return phi1 - phi0; }
