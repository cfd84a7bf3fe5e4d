#include "casegen/measure/hybrid/break_even.h"

#include <algorithm>
#include <limits>

namespace gnomon::measure {

double break_even_nanoseconds(const FrameCost& hybrid, const FrameCost& raytraced) {
    const double overhead = hybrid.overhead() - raytraced.overhead();
    if (hybrid.rays >= raytraced.rays)
        return overhead > 0 || hybrid.rays > raytraced.rays ? std::numeric_limits<double>::infinity() : 0;
    return std::max(0.0, 1e6 * overhead / static_cast<double>(raytraced.rays - hybrid.rays));
}

} // namespace gnomon::measure
