#include "cli/reproduce/counts.h"

#include "casegen/csv.h"
#include "runtime/error.h"

#include <limits>

namespace gnomon::cli {

std::vector<PrintedCount> read_printed_counts(const std::filesystem::path& path) {
    const Csv csv = read_csv(path);
    const std::size_t table = csv.column("table"), view = csv.column("view"), width = csv.column("width"),
                      height = csv.column("height"), map = csv.column("map"),
                      technique = csv.column("technique"), quantity = csv.column("quantity"),
                      value = csv.column("value");
    std::vector<PrintedCount> counts;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const auto number = [&](std::size_t column) {
            return parse_word(Scalar::uint32, csv.rows[row][column], csv.place(row, column));
        };
        const auto size = [&](std::size_t column) {
            const std::uint32_t value_there = number(column);
            if (value_there > std::numeric_limits<int>::max())
                throw Error("{} is {}; that is no table, size or map", csv.place(row, column), value_there);
            return static_cast<int>(value_there);
        };
        counts.push_back({size(table),
                          {csv.rows[row][view], size(width), size(height), size(map),
                           csv.rows[row][technique], csv.rows[row][quantity]},
                          number(value)});
    }
    return counts;
}

} // namespace gnomon::cli
