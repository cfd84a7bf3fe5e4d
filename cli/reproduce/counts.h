// Counts of pixels: those that the thesis prints, and ours under the same names.
#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gnomon::cli {

/// What was counted: the columns of fixtures/thesis/counts.csv, whose README says what the quantities are.
struct CountKey {
    std::string view;
    int width = 0, height = 0, map = 0; ///< map 0: no shadow map is involved
    std::string technique, quantity;
    friend auto operator<=>(const CountKey&, const CountKey&) = default;
};

using Counts = std::map<CountKey, std::uint64_t>;

struct PrintedCount {
    int table = 0;
    CountKey key;
    std::uint64_t value = 0;
};

/// In the order of the file. Throws Error naming file and row.
std::vector<PrintedCount> read_printed_counts(const std::filesystem::path& path);

} // namespace gnomon::cli
