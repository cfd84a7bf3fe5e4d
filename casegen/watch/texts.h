// What kernels compile from, at one moment: the folder's files as they were when they were last read, so that
// a kernel's verdict and its time are of one state, however quickly saves follow each other.
#pragma once

#include "casegen/kernel_case.h"
#include "runtime/glsl/compiler.h"

#include <filesystem>
#include <set>
#include <string>

namespace gnomon::watch {

struct Texts {
    std::string alone;           ///< standalone_text
    std::string repeated;        ///< repeated_source with all that it includes
    std::string error;           ///< why it does not even expand; then the others are empty
    std::set<std::string> files; ///< below the folder, of which `alone` consists; none if it does not expand
};

class FolderTexts {
public:
    /// Reads all files.
    explicit FolderTexts(const std::filesystem::path& folder);

    /// Reads one file again, or all; what is no more is forgotten.
    void read(const std::string& file);
    void read_all();

    Texts of(const Case& c) const;
    /// What messages call the folder.
    std::string name() const { return sources_.root.filename().string(); }

private:
    glsl::Sources sources_;
};

/// The files that an expanded text names in its #line directives, below the folder of this name.
std::set<std::string> files_of(const std::string& expanded, const std::string& folder);

} // namespace gnomon::watch
