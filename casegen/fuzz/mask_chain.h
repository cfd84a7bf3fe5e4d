// Revectorisation from a mask to the light at a point, as a subject of fuzzing.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/fuzz/chain.h"

namespace gnomon::fuzz {

/// Of a technique with a decision list. On every input: a number and a value that its parts give too, the
/// number that the conditions say, a value as the reference has it and within its range, shadow that stays
/// shadow where nobody lights it, the same from a mask that is turned over, and on along a run; of a filter
/// the opposite from the mask's opposite, and of shapes what the cases give wherever they must agree.
Chain mask_chain(const Family& family);

} // namespace gnomon::fuzz
