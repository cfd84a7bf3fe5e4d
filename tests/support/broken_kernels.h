// Kernels folders with something wrong in them.
#pragma once

#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <string>

namespace gnomon::testing {

/// A copy of kernels/ with the files of tests/kernels_that_fail/NAME laid over it; gone with the object.
class BrokenKernels {
public:
    explicit BrokenKernels(const std::string& name) {
        namespace fs = std::filesystem;
        const auto options = fs::copy_options::recursive | fs::copy_options::overwrite_existing;
        fs::copy(kernels_folder(), folder(), options);
        fs::copy(source_folder() / "tests/kernels_that_fail" / name, folder(), options);
    }
    std::filesystem::path folder() const { return temporary_.path() / "kernels"; }

private:
    TemporaryFolder temporary_;
};

} // namespace gnomon::testing
