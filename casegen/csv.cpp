#include "casegen/csv.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <cstdlib>

namespace gnomon {
namespace {

std::string trimmed(std::string_view cell) {
    const std::size_t first = cell.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return std::string(cell.substr(first, cell.find_last_not_of(" \t") - first + 1));
}

std::vector<std::string> split(std::string_view line) {
    std::vector<std::string> cells;
    for (;;) {
        const std::size_t comma = line.find(',');
        cells.push_back(trimmed(line.substr(0, comma)));
        if (comma == std::string_view::npos) return cells;
        line.remove_prefix(comma + 1);
    }
}

} // namespace

std::size_t Csv::column(const std::string& title) const {
    const auto found = std::ranges::find(header, title);
    if (found == header.end())
        throw Error("{}: no column \"{}\"; it has {}", name, title, fmt::join(header, ", "));
    return static_cast<std::size_t>(found - header.begin());
}

std::string Csv::place(std::size_t row, std::size_t column) const {
    return fmt::format("{}: row {}, column {}", name, row + 1, header[column]);
}

Csv parse_csv(std::string_view text, const std::string& name) {
    Csv csv;
    csv.name = name;
    if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3); // a byte-order mark from a spreadsheet
    std::size_t number = 0;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        std::string_view line = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        ++number;
        if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
        if (line.starts_with('#') && csv.header.empty()) continue; // comments may stand above the header
        if (trimmed(line).empty()) continue;
        std::vector<std::string> cells = split(line);
        if (csv.header.empty()) {
            for (std::size_t i = 0; i < cells.size(); ++i) {
                if (cells[i].empty()) throw Error("{}: column {} has no name", name, i + 1);
                if (std::find(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(i), cells[i]) !=
                    cells.begin() + static_cast<std::ptrdiff_t>(i))
                    throw Error("{}: two columns are called \"{}\"", name, cells[i]);
            }
            csv.header = std::move(cells);
            continue;
        }
        if (cells.size() != csv.header.size())
            throw Error("{}: line {} has {} cells, the header has {}", name, number, cells.size(),
                        csv.header.size());
        csv.rows.push_back(std::move(cells));
    }
    if (csv.header.empty()) throw Error("{}: empty; the first row must name the columns", name);
    if (csv.rows.empty()) throw Error("{}: no rows below the header", name);
    return csv;
}

Csv read_csv(const std::filesystem::path& path) { return parse_csv(read_file(path), path.string()); }

std::uint32_t parse_word(Scalar scalar, const std::string& cell, const std::string& place) {
    char* end = nullptr;
    errno = 0;
    if (scalar == Scalar::float32) {
        const float value = std::strtof(cell.c_str(), &end);
        const bool overflow = errno == ERANGE && std::isinf(value);
        if (cell.empty() || end != cell.c_str() + cell.size() || overflow)
            throw Error("{} is \"{}\"; a number is needed{}", place, one_line(cell),
                        overflow ? " that a float can hold" : "");
        return std::bit_cast<std::uint32_t>(value);
    }
    const double value = std::strtod(cell.c_str(), &end);
    if (cell.empty() || end != cell.c_str() + cell.size())
        throw Error("{} is \"{}\"; a whole number is needed", place, one_line(cell));
    const double lower = scalar == Scalar::int32 ? -2147483648.0 : 0.0;
    const double upper = scalar == Scalar::int32    ? 2147483647.0
                         : scalar == Scalar::uint32 ? 4294967295.0
                                                    : 1.0;
    if (!(value >= lower && value <= upper) || value != std::floor(value))
        throw Error("{} is {}; a whole number from {:.0f} to {:.0f} is needed", place, one_line(cell), lower,
                    upper);
    return narrow(scalar, value);
}

std::string format_word(Scalar scalar, std::uint32_t word) {
    if (scalar != Scalar::float32) return fmt::format("{:.0f}", widen(scalar, word));
    const float value = std::bit_cast<float>(word);
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
    return fmt::format("{:a}", value);
}

Outside parse_outside(const std::string& text, const std::string& place) {
    if (text == "clamp") return Outside::clamp;
    if (text == "lit") return Outside::lit;
    if (text == "shadow") return Outside::shadow;
    throw Error("{} is \"{}\"; what lies outside is clamp, lit or shadow", place, text);
}

std::string to_string(Outside outside) {
    switch (outside) {
    case Outside::lit:
        return "lit";
    case Outside::shadow:
        return "shadow";
    case Outside::clamp:
        break;
    }
    return "clamp";
}

std::vector<CsvInput> read_inputs(const Case& c, const Csv& csv) {
    const std::vector<std::string> names = columns(c);
    const std::size_t fixed = c.reference.takes_mask ? 2 : 0;
    std::vector<std::size_t> number_columns;
    for (std::size_t i = fixed; i < names.size(); ++i) number_columns.push_back(csv.column(names[i]));
    const std::vector<Scalar>& scalars = c.reference.words;
    const bool has_outside = std::ranges::find(csv.header, "outside") != csv.header.end();

    std::vector<CsvInput> inputs;
    for (std::size_t row = 0; row < csv.rows.size(); ++row) {
        const std::vector<std::string>& cells = csv.rows[row];
        CsvInput input;
        if (c.reference.takes_mask) {
            const std::size_t mask = csv.column("mask");
            input.mask = parse_mask(cells[mask], '/', csv.place(row, mask));
            if (has_outside) {
                const std::size_t outside = csv.column("outside");
                input.mask.outside = parse_outside(cells[outside], csv.place(row, outside));
            }
        }
        for (std::size_t i = 0; i < number_columns.size(); ++i)
            input.words.push_back(
                parse_word(scalars[i], cells[number_columns[i]], csv.place(row, number_columns[i])));
        inputs.push_back(std::move(input));
    }
    return inputs;
}

std::vector<CsvInput> read_inputs(const Case& c, const std::filesystem::path& path) {
    return read_inputs(c, read_csv(path));
}

} // namespace gnomon
