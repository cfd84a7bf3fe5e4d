// A regression: one input that a kernel, or a chain of them, once got wrong, shrunk, in a file of its own
// that says all that is needed to run it again. Every check begins with the kernel's regressions.
#pragma once

#include "casegen/fuzz/failure.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::fuzz {

struct Regression {
    std::string kernel;  ///< "smsr/case_09"; a chain's name: "scene/sheet"
    std::string failure; ///< as failure_of says it, or of a dispatch
    Input input;
    std::string got, want, allowed; ///< as they were when it was found: for people
    std::string found;              ///< how: "gnomon fuzz smsr --seed 7, unit 12"; its input before shrinking
};

/// The file's text: JSON, a line per field, the input by the names that a CSV's columns have and in
/// hexadecimal floats; a scene with all its triangles. Ends in '\n'.
std::string format_regression(const Regression& regression);

/// `name` stands for the text in messages. Throws Error naming it and the field: no JSON, a field missing, of
/// another type or unknown, a kernel that there is not, an input that is none of it.
Regression parse_regression(std::string_view text, const std::string& name);

/// "smsr.case_09.wrong.1a2b3c4d.json": kernel, failure, and a hash of the input.
std::string file_name(const Regression& regression);

/// All of a folder, by kernel, in the order of their names; none if there is no such folder. Throws Error
/// (a file in its place; see parse_regression; a file that is not called *.json: it would be overlooked).
std::map<std::string, std::vector<Regression>> load_regressions(const std::filesystem::path& folder);

/// If there is none. Throws Error.
void make_regressions_folder(const std::filesystem::path& folder);

} // namespace gnomon::fuzz
