// What a bench found, as tables: of text for a terminal, of HTML for a page.
#pragma once

#include "casegen/measure/bench.h"

#include <string>
#include <vector>

namespace gnomon::measure {

struct Table {
    std::string title;
    std::vector<std::string> notes;  ///< lines between title and table
    std::vector<std::string> header; ///< the first column is text, the others are numbers if they look so
    std::vector<std::vector<std::string>> rows;
};

/// Variants of a group over all inputs, with times and who dominates whom.
Table overall_table(const GroupResult& result);

/// Of groups of one variant each: a row each.
Table lone_table(const std::vector<const GroupResult*>& results);

/// A row per class and variant.
Table class_table(const GroupResult& result);

/// A row per locus and variant.
Table locus_table(const GroupResult& result);

std::string to_text(const Table& table);
std::string to_html(const Table& table);
/// The same with a field to search it and headers that sort it, where the page's script runs.
std::string to_sortable_html(const Table& table);

// How cells show numbers.
std::string error_cell(double value);                              ///< "1.2e-07"
std::string ratio_cell(double value);                              ///< "0.25", "3e+06"
std::string time_cell(double nanoseconds, const Timings& timings); ///< "<0.3" where noise drowns it

/// All of a bench: lone kernels last, in one table; with tables by class if asked for.
std::string to_text(const Bench& bench, bool by_class);

/// Machine, noise, and what the numbers are: lines for the foot of the tables.
std::vector<std::string> remarks(const Bench& bench);

} // namespace gnomon::measure
