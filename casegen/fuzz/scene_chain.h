// A sound hybrid technique over whole scenes, as a subject of fuzzing.
#pragma once

#include "casegen/fuzz/chain.h"

namespace gnomon::fuzz {

/// Random scenes that no modeller would make (casegen/hybrid/soups.h): of the pixels that the technique is
/// certain of, none may be contradicted by an exact ray.
Chain scene_chain(const std::string& technique);

} // namespace gnomon::fuzz
