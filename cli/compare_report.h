// What a comparison found, as text for people and JSON for programs.
#pragma once

#include "casegen/versus/versus.h"

#include <string>

namespace gnomon::cli {

/// What stands above every comparison.
struct CompareHead {
    std::string a, b;            ///< the sides' labels
    std::filesystem::path image; ///< empty: none was asked for
    bool times = true;
};

/// A paragraph per kernel, then a table of all of them.
std::string compare_text(const CompareHead& head, const versus::Plan& plan,
                         const versus::VersusReport& report);

/// JSON has no infinity: what is not finite is null.
std::string compare_json(const CompareHead& head, const versus::Plan& plan,
                         const versus::VersusReport& report);

} // namespace gnomon::cli
