// The file of a kernel's worst inputs: fixtures/worst/<kernel>.csv, which every check runs first.
#pragma once

#include "casegen/worst/search.h"

#include <filesystem>
#include <string>

namespace gnomon::worst {

/// "<folder>/smsr/case_09.csv".
std::filesystem::path file_of(const std::filesystem::path& folder, const Case& c);

/// A CSV file with columns(c) and a row each, every bit of a float in it.
std::string csv_of(const Case& c, const std::vector<Row>& rows);

/// What is written: the rows found, and what the file held before as far as there is room, which keeps rows
/// that a better kernel gets right now.
std::vector<Row> merged(const Found& found);

/// Makes the folders if they are missing, and writes the file whole. Nothing is written where there are no
/// rows. Throws Error.
void write_worst(const std::filesystem::path& path, const Case& c, const Found& found);

/// Throws Error now if write_worst would later.
void require_worst_file(const std::filesystem::path& path);

} // namespace gnomon::worst
