// Kernels folders with something wrong in them.
#pragma once

#include "runtime/files.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
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

/// A copy of kernels/ in which one text of one file, which must say it exactly once, is another.
class ChangedKernels {
public:
    ChangedKernels(const std::string& file, const std::string& from, const std::string& to) {
        std::filesystem::copy(kernels_folder(), folder(), std::filesystem::copy_options::recursive);
        std::string text = read_file(folder() / file);
        const std::size_t at = text.find(from);
        EXPECT_NE(at, text.npos) << file << " does not say " << from;
        if (at == text.npos) return;
        EXPECT_EQ(text.find(from, at + 1), text.npos) << file << " says more than once " << from;
        text.replace(at, from.size(), to);
        std::ofstream(folder() / file, std::ios::binary) << text;
    }
    std::filesystem::path folder() const { return temporary_.path() / "kernels"; }

private:
    TemporaryFolder temporary_;
};

} // namespace gnomon::testing
