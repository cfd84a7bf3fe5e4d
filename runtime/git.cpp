#include "runtime/git.h"

#include "runtime/command.h"
#include "runtime/error.h"

#include <charconv>
#include <string_view>
#include <vector>

namespace gnomon::git {
namespace {

CommandResult run_git(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                      std::string_view input = {}) {
    std::vector<std::string> words{"git", "-C", folder.string()};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_command(words, input);
}

std::string first_line(const std::string& text) { return text.substr(0, text.find('\n')); }

/// A name that git could take for an option is none of a revision's.
bool could_be_revision(const std::string& revision) {
    return !revision.empty() && revision.front() != '-' && revision.find('\n') == revision.npos;
}

CommandResult find_commit(const std::filesystem::path& folder, const std::string& revision) {
    return run_git(folder, {"rev-parse", "--verify", "--quiet", "--short", revision + "^{commit}"});
}

std::string require_git(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                        std::string_view input = {}) {
    CommandResult result = run_git(folder, arguments, input);
    if (result.exit_code != 0)
        throw Error("{}: git {}: {}", folder.string(), arguments.front(), first_line(result.err));
    return std::move(result.out);
}

/// "<hash> blob <size>\n<bytes>\n" once per object that was asked for.
std::string_view next_blob(std::string_view& batch, const std::string& path) {
    const std::size_t end = batch.find('\n');
    const std::string_view header = batch.substr(0, end);
    const std::size_t blank = header.rfind(' ');
    std::size_t size = 0;
    if (end == batch.npos || blank == header.npos || header.find(" blob ") == header.npos ||
        std::from_chars(header.data() + blank + 1, header.data() + header.size(), size).ec != std::errc() ||
        size > batch.size() - end - 1)
        throw Error("git cat-file gave no text for {}: {}", path, header);
    const std::string_view bytes = batch.substr(end + 1, size);
    batch.remove_prefix(std::min(batch.size(), end + 1 + size + 1));
    return bytes;
}

} // namespace

bool is_revision(const std::filesystem::path& folder, const std::string& revision) {
    return could_be_revision(revision) && find_commit(folder, revision).exit_code == 0;
}

FolderAt find_folder(const std::filesystem::path& folder, const std::string& revision) {
    if (const CommandResult inside = run_git(folder, {"rev-parse", "--is-inside-work-tree"});
        inside.exit_code != 0)
        throw Error("{}: no git repository that could hold revision \"{}\": {}", folder.string(), revision,
                    first_line(inside.err));
    if (!could_be_revision(revision)) throw Error("\"{}\" names no git revision", revision);
    const CommandResult commit = find_commit(folder, revision);
    if (commit.exit_code != 0)
        throw Error("{}: its git repository has no revision \"{}\"", folder.string(), revision);
    const CommandResult tree =
        run_git(folder, {"rev-parse", "--verify", "--quiet", revision + "^{commit}:./"});
    if (tree.exit_code != 0)
        throw Error("{}: this folder does not exist in revision {}", folder.string(), revision);
    return {first_line(commit.out), first_line(tree.out)};
}

std::map<std::string, std::string> files_of(const std::filesystem::path& folder, const FolderAt& at) {
    const std::string listing = require_git(folder, {"ls-tree", "-r", "-z", "--full-tree", at.tree});
    std::vector<std::string> paths;
    std::string wanted;
    for (std::string_view rest = listing; !rest.empty();) { // "100644 blob <hash>\t<path>\0"
        const std::string_view entry = rest.substr(0, rest.find('\0'));
        rest.remove_prefix(std::min(rest.size(), entry.size() + 1));
        const std::size_t tab = entry.find('\t');
        if (!entry.starts_with("100") || tab == entry.npos) continue; // a link, or another repository
        paths.emplace_back(entry.substr(tab + 1));
        const std::size_t blank = entry.rfind(' ', tab);
        wanted += fmt::format("{}\n", entry.substr(blank + 1, tab - blank - 1));
    }
    const std::string batch = require_git(folder, {"cat-file", "--batch"}, wanted);
    std::map<std::string, std::string> files;
    std::string_view rest = batch;
    for (const std::string& path : paths) files[path] = next_blob(rest, path);
    return files;
}

} // namespace gnomon::git
