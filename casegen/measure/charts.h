// The pictures of a group.
#pragma once

#include "casegen/measure/bench.h"

#include <string>

namespace gnomon::measure {

/// Error against distance, a small chart per locus: medians in bold, largest errors thin, κu grey; a mark at
/// the upper edge where results are not finite. Empty without loci.
std::string distance_chart(const GroupResult& result);

/// Time against error over all inputs, a panel per rank; dominated variants hollow. Empty without times.
std::string pareto_chart(const GroupResult& result);

/// How variant `n` is drawn, everywhere: attributes of its line.
std::string line_style(std::size_t n);

} // namespace gnomon::measure
