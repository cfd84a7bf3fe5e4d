// The truths that a kernel's results are judged by.
#pragma once

#include "casegen/standalone.h"

#include <vector>

namespace gnomon {

/// One per record, empty where the record is outside the case's domain; nothing at all if the case's
/// reference has no truth.
std::vector<Truth> truths(const Case& c, const Records& records);

} // namespace gnomon
