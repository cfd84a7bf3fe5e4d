// What the tests of the verbs that draw have in common.
#pragma once

#include "tests/support/child_process.h"
#include "tests/support/temporary_folder.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::testing {

using Arguments = std::vector<std::string>;

inline Arguments operator+(Arguments first, const Arguments& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
}

/// Runs gnomon and expects that it succeeds without a word on standard error.
Ran run_well(const Arguments& arguments);

/// Runs gnomon and expects one line that contains `what`, exit code 2, nothing on standard output, and as
/// many files in `folder` as before.
void expect_refused(const TemporaryFolder& folder, const Arguments& arguments, const std::string& what);

nlohmann::json read_json(const std::filesystem::path& path);

} // namespace gnomon::testing
