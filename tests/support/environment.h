// What every test program needs to know about where it runs.
#pragma once

#include <filesystem>

namespace gnomon::testing {

std::filesystem::path source_folder();
inline std::filesystem::path kernels_folder() { return source_folder() / "kernels"; }
inline std::filesystem::path fixtures_folder() { return source_folder() / "fixtures"; }

/// Points GNOMON_CACHE into the build folder, so that tests leave the user's cache alone.
void use_test_cache();

} // namespace gnomon::testing
