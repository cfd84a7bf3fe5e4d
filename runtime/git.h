// A folder as it was at a revision of the git repository that it lies in. The work tree, the index and the
// repository are only read.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace gnomon::git {

struct FolderAt {
    std::string commit; ///< short: "4dbb942"
    std::string tree;   ///< the whole name of the folder's content: two that are equal hold the same files
};

/// `revision` is anything that names a commit: "HEAD~3", a tag, a branch, a hash. Throws Error: git is not
/// installed, the folder lies in no repository, there is no such revision, or no such folder in it.
FolderAt find_folder(const std::filesystem::path& folder, const std::string& revision);

/// Whether find_folder would find a commit, its folder or not.
bool is_revision(const std::filesystem::path& folder, const std::string& revision);

/// Path below the folder to text, of all plain files. Throws Error.
std::map<std::string, std::string> files_of(const std::filesystem::path& folder, const FolderAt& at);

} // namespace gnomon::git
