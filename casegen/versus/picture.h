// A picture of where two kernels differ: two of their inputs vary over it, the others stand still.
#pragma once

#include "casegen/csv.h"
#include "casegen/versus/difference.h"
#include "runtime/image.h"

#include <array>
#include <string>
#include <vector>

namespace gnomon::versus {

/// An input that varies along a side of the picture.
struct Axis {
    std::size_t word = 0; ///< of the record
    std::string name;     ///< "p.x"
    double from = 0, to = 1;
    std::vector<double> values; ///< whole numbers and choices: these, in bands of equal width
};

/// "p.x,p.y" or, with ranges of one's own, "p.x=0.2:0.4,k=-1:1". Throws Error that lists the components there
/// are.
std::array<Axis, 2> parse_axes(const Case& c, const std::string& text);

/// The two that say most about where two kernels differ: of the components that vary continuously those whose
/// range of differences holds the fewest samples, the first of equals; else the first ones. Throws Error if
/// the kernel has no two components.
std::array<Axis, 2> telling_axes(const Case& c, const std::vector<Whereabouts>& where);

struct PictureSize {
    int width = 512, height = 512;
};

/// The inputs: the first axis to the right, the second one downwards, everything else as in `rest`. Values
/// are those at the pixels' middles.
Records picture_records(const Case& c, const std::array<Axis, 2>& axes, PictureSize size,
                        const CsvInput& rest);

struct Picture {
    Image image;
    double scale = 0; ///< |B - A| that is shown in full colour: the largest there is
    std::size_t differ = 0, finiteness = 0, both_nan = 0, outside = 0; ///< pixels; outside: of the domain
};

/// Pale where the bits are the same; amber where B is larger, blue where it is smaller, the stronger the
/// more; red where one of them is not finite, or not in the same way; magenta where both are NaN; grey
/// outside the domain where the bits are the same.
Picture picture_of(const Case& c, const Records& records, PictureSize size, std::span<const std::uint32_t> a,
                   std::span<const std::uint32_t> b);

inline constexpr Rgb same_colour{232, 234, 238}, larger_colour{217, 142, 4}, smaller_colour{38, 98, 190},
    not_finite_colour{200, 24, 7}, both_nan_colour{192, 38, 211}, outside_colour{150, 155, 165};

} // namespace gnomon::versus
