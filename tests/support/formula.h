// The value of a formula that a table shows to people (Case::formula), so that it can be held against the
// reference.
#pragma once

#include <map>
#include <string>

namespace gnomon::testing {

/// By the grammar of casegen/atlas/mathml.h; the first row whose condition holds. Fails the test and gives
/// NaN for a name that `names` lacks, for what is no formula, and if no row holds.
double value_of_formula(const std::string& formula, const std::map<std::string, double>& names);

} // namespace gnomon::testing
