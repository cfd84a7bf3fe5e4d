// Comma-separated files: a header row of column names, then one row per sample. Numbers are decimal or
// hexadecimal floats
// ("0x1.8p-1", which names every bit), "nan", "inf"; no quoting, no empty cells.
#pragma once

#include "casegen/kernel_case.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

struct Csv {
    std::string name; ///< for messages
    std::vector<std::string> header;
    std::vector<std::vector<std::string>> rows; ///< each as long as the header

    /// Throws Error that lists the columns there are.
    std::size_t column(const std::string& title) const;
    /// "FILE: row 3, column p_x": rows count from 1 below the header.
    std::string place(std::size_t row, std::size_t column) const;
};

/// Throws Error naming file and row: no header, no rows, a row of another length, an empty or repeated column
/// name.
Csv parse_csv(std::string_view text, const std::string& name);
Csv read_csv(const std::filesystem::path& path);

/// A cell as a number. Throws Error naming `place` if it is text, or does not fit the scalar (an integer
/// column takes whole numbers in range only).
std::uint32_t parse_word(Scalar scalar, const std::string& cell, const std::string& place);

/// A word as a cell that parse_word reads back to the same bits.
std::string format_word(Scalar scalar, std::uint32_t word);

/// "clamp", "lit" or "shadow". Throws Error naming `place`.
Outside parse_outside(const std::string& text, const std::string& place);
std::string to_string(Outside outside);

struct CsvInput {
    std::vector<std::uint32_t> words;
    Mask mask; ///< empty unless the kernel takes one
};

/// A kernel's inputs from columns named as columns(case) has them; further columns are ignored. A mask is one
/// cell, its rows parted by '/': "#./.."; the column `outside` may be missing (clamp).
std::vector<CsvInput> read_inputs(const Case& c, const Csv& csv);
std::vector<CsvInput> read_inputs(const Case& c, const std::filesystem::path& path);

} // namespace gnomon
