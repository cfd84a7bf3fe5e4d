// From a dispatch's results to a report: what check and watch have in common.
#pragma once

#include "casegen/check.h"
#include "casegen/standalone.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace gnomon {

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
