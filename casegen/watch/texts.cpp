#include "casegen/watch/texts.h"

#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <string_view>

namespace gnomon::watch {
namespace {

namespace fs = std::filesystem;

/// The folder by a path whose last part is its name: "kernels/" and "." have none.
fs::path named(const fs::path& folder) {
    const fs::path absolute = fs::absolute(folder).lexically_normal();
    return absolute.has_filename() ? absolute : absolute.parent_path();
}

/// Else it is an editor's or somebody's own, and read only if something includes it.
bool is_glsl(const fs::path& file) { return file.extension() == ".glsl" || file.extension() == ".glslh"; }

} // namespace

FolderTexts::FolderTexts(const fs::path& folder) : sources_(kernel_sources(named(folder))) { read_all(); }

void FolderTexts::read(const std::string& file) {
    if (!is_glsl(file)) return;
    try {
        sources_.overlaid[file] = read_file(sources_.root / file);
    } catch (const Error&) {
        sources_.overlaid.erase(file);
    }
}

void FolderTexts::read_all() {
    sources_.overlaid.clear();
    std::error_code error;
    for (fs::recursive_directory_iterator entry(sources_.root, error), end; !error && entry != end;
         entry.increment(error))
        read(entry->path().lexically_relative(sources_.root).generic_string());
}

Texts FolderTexts::of(const Case& c) const {
    Texts texts;
    try {
        texts.alone = standalone_text(c, sources_);
        texts.repeated = glsl::expand(sources_, repeated_source(c, Repeated::calls), standalone_name);
        texts.files = files_of(texts.alone, name());
    } catch (const CompileError& error) {
        texts = {};
        texts.error = error.what();
    }
    return texts;
}

std::set<std::string> files_of(const std::string& expanded, const std::string& folder) {
    std::set<std::string> files;
    const std::string begin = fmt::format("\n#line 1 \"{}/", folder);
    for (std::size_t at = expanded.find(begin); at != expanded.npos; at = expanded.find(begin, at)) {
        at += begin.size();
        files.insert(expanded.substr(at, expanded.find('"', at) - at));
    }
    return files;
}

} // namespace gnomon::watch
