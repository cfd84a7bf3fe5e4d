// From a dispatch's results to a report: what check and watch have in common.
#pragma once

#include "casegen/check.h"
#include "casegen/standalone.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace gnomon {

/// Results, and what judging them said, per record.
struct Judged {
    std::vector<std::uint32_t> results;
    std::vector<double> errors;
    std::vector<std::uint8_t> failed;
};

/// Judges a dispatch's results, on all cores. `truths`: of each record, or none at all if the reference has
/// none. `earlier`, of the same records, may be null: what came out with the same bits there is not judged
/// again.
Judged judge_all(const Case& c, const Records& records, std::vector<std::uint32_t> results,
                 std::span<const Truth> truths, const Judged* earlier = nullptr);

/// Counts failures into the report, and keeps the worst finding: of equals the first. `begin`: the number of
/// the first record.
void add_judged(const Case& c, const Records& records, std::size_t begin, const Judged& judged,
                CheckReport& report);

/// What became of `records`' input number `i`; `index` is the sample's number in the whole run.
Finding make_finding(const Case& c, const Records& records, std::size_t i, std::size_t index,
                     std::span<const std::uint32_t> got, double error);

/// What is wrong with a dispatch as a whole, whatever its results are worth: sets verdict, message and, where
/// a result is missing, the finding. False if nothing is. `begin`: the number of the first record.
bool add_complaint(const Case& c, const Records& records, std::size_t begin, const Outputs& outputs,
                   CheckReport& report);

/// Turns the verdict on a kernel around whose table says that it must fail; leaves those of others.
void expect_what_the_table_says(CheckReport& report);

} // namespace gnomon
