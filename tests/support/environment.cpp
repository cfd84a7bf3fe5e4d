#include "tests/support/environment.h"

#include <cstdlib>

namespace gnomon::testing {

std::filesystem::path source_folder() { return GNOMON_SOURCE_DIR; }

void use_test_cache() { setenv("GNOMON_CACHE", GNOMON_TEST_CACHE, 1); }

} // namespace gnomon::testing
