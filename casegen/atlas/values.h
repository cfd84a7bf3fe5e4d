// A kernel's values over the texel that leads to its case, beside the reference's.
#pragma once

#include "casegen/standalone.h"
#include "casegen/witness.h"
#include "runtime/image.h"

#include <cstdint>
#include <vector>

namespace gnomon::atlas {

/// The words of a call: for each parameter the fact that a mask tells of it; if none does, its domain's first
/// choice or lower end.
std::vector<std::uint32_t> words_of(const Case& c, const Facts& facts);

enum class Agreement : std::uint8_t {
    equal,
    allowed, ///< not the reference's value, but within the tolerance
    refused,
    undefined, ///< outside the kernel's domain: the reference says nothing
};

/// "options = 0": the parameters of which a mask tells nothing at this texel, with what stands for them.
std::vector<std::string> untold(const Case& c, const Facts& facts);

/// `side` × `side` points of a texel, row-major; row 0 is nearest to p.y = 0. Results of one component.
struct ValueMap {
    int side = 0;
    std::vector<double> want;         ///< NaN where it is undefined
    std::vector<double> got;          ///< NaN where the kernel wrote nothing; empty if it did not run
    std::vector<Agreement> agreement; ///< as long as `got`
    double largest_difference = 0;
    std::size_t differ = 0, refused = 0;
};

/// What a witness tells at the middle of its texel.
Facts facts_of(const Witness& witness);

/// The inputs of the map: the witness's facts at each point.
Records value_records(const Case& c, const Witness& witness, int side);

/// `outputs` may be null: then only the reference speaks.
ValueMap make_value_map(const Case& c, const Records& records, int side, const Outputs* outputs);

/// How large a difference is shown in full colour: the tolerance where it bounds the result, else the
/// result's whole range.
double difference_scale(const Case& c);

// Pictures. Values go from the colour of shadow (lowest) to that of light (highest); NaN is magenta.
inline constexpr Rgb shadow_colour{58, 66, 86}, light_colour{246, 238, 218};

Image values_image(const Case& c, const ValueMap& map, const std::vector<double>& values);
/// Pale where equal; amber where allowed, the stronger the larger; red where refused; grey where undefined.
Image difference_image(const Case& c, const ValueMap& map);

/// Adds inputs of a technique's kernel over a mask and the ring of texels around it, `scale` × `scale` points
/// a texel.
void add_mask_records(Records& records, const Case& visibility, const Mask& mask, int scale);
/// The picture of these records' results, the first of which is at `first`.
Image mask_image(const Case& visibility, const Mask& mask, int scale, const Outputs& outputs,
                 std::size_t first);

} // namespace gnomon::atlas
