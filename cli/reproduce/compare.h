// Printed counts beside ours: how far apart, and where too far.
#pragma once

#include "cli/reproduce/counts.h"

#include <optional>
#include <string>
#include <vector>

namespace gnomon::cli {

struct Compared {
    PrintedCount printed;
    std::uint64_t ours = 0;
    std::uint64_t pixels = 0;    ///< of the view's image
    std::optional<double> share; ///< that a target allows of the printed count; none: reported only
    /// Of the printed count; of one pixel where it is 0.
    double difference() const;
    /// Within the target, or within `few` of the image's pixels, which is what small counts can be asked for.
    bool holds() const;
    static constexpr double few = 2e-5;
};

/// The printed counts that were counted here too, in the order of the tables.
/// Ray-traced, NSM's and Beister's counts have a target of 0.2 %; CRSM's 0.2 % and CRSMA's 0.5 %, at map
/// sizes up to 2048; views whose camera is not the printed one none.
std::vector<Compared> compare_counts(const std::vector<PrintedCount>& printed, const Counts& ours);

/// Every table with both counts and their difference.
std::string compared_tables(const std::vector<Compared>& all);

/// A line for each target, and the cells that miss it.
std::string compared_summary(const std::vector<Compared>& all);

} // namespace gnomon::cli
