// Whether a result agrees with the reference, and by how much it does not.
#pragma once

#include "casegen/kernel_case.h"

#include <cstdint>
#include <span>

namespace gnomon {

struct Agreement {
    bool pass = false;
    /// In the tolerance's own unit (ulps, absolute, distance of the input, times the conditioning); infinity
    /// where no such number exists.
    double error = 0;
};

/// Floats from a to b: 0 for equal values (+0 and -0 are), infinity if one of them is NaN or they differ in
/// being infinite.
double ulps_between(float a, float b);

/// What `conditioned` measures the error of one component in: the truth's conditioning, but no less than one
/// rounding of its scale, nor than the smallest normal float, below which a device may flush to zero.
double unit_of_error(const Truth& truth, std::size_t component);

/// Whether the case asks for the reference's answer to the last bit here (Case::exact_where).
bool exact_at(const Case& c, const Arguments& arguments);

/// Whether a result at an input outside the domain is what the case's rule asks for (Case::outside).
bool keeps_rule(const Case& c, const Arguments& arguments, const Numbers& got);

/// The case's verdict on result words for one input. NaN never passes, nor does anything outside the result's
/// range, whatever the input (unless the case is not defended and the input outside its domain); agreement
/// with the reference is asked for on the case's domain only, and to the last bit where it is exact_at;
/// elsewhere the case's rule. `known`: the reference's truth there, if it is at hand.
Agreement judge(const Case& c, const Arguments& arguments, std::span<const std::uint32_t> result,
                const Truth* known = nullptr);

} // namespace gnomon
