#include "casegen/worst/file.h"

#include "casegen/csv.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gnomon::worst {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& folder, const Case& c) { return folder / (c.name + ".csv"); }

std::string csv_of(const Case& c, const std::vector<Row>& rows) {
    std::string text = fmt::format("{}\n", fmt::join(columns(c), ","));
    for (const Row& row : rows) {
        std::vector<std::string> cells;
        if (row.mask) cells = {format_mask(*row.mask, '/'), to_string(row.mask->outside)};
        for (std::size_t i = 0; i < row.words.size(); ++i)
            cells.push_back(format_word(c.reference.words[i], row.words[i]));
        text += fmt::format("{}\n", fmt::join(cells, ","));
    }
    return text;
}

std::vector<Row> merged(const Found& found) {
    std::vector<Row> rows = found.rows;
    for (const Row& old : found.before) {
        const auto same = [&](const Row& row) {
            return row.words == old.words &&
                   (row.mask == old.mask || (row.mask && old.mask && *row.mask == *old.mask));
        };
        if (rows.size() < most_rows && std::ranges::none_of(rows, same)) rows.push_back(old);
    }
    return rows;
}

void require_worst_file(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path.parent_path(), error);
    if (error) throw Error("{}: cannot be made a folder: {}", path.parent_path().string(), error.message());
    require_writable(path);
}

void write_worst(const fs::path& path, const Case& c, const Found& found) {
    if (const std::vector<Row> rows = merged(found); !rows.empty()) write_file(path, csv_of(c, rows));
}

} // namespace gnomon::worst
