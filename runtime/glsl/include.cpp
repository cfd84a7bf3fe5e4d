#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/glsl/compiler.h"

#include <fmt/format.h>

#include <optional>
#include <set>

namespace gnomon::glsl {
namespace {

struct Include {
    std::string name;
    bool generated = false;
    bool alone = true; ///< on its line, but for a comment behind it
};

/// `#include "name"` or `#include <name>`
std::optional<Include> parse_include(std::string_view line) {
    const auto skip_blanks = [&] {
        while (!line.empty() && (line.front() == ' ' || line.front() == '\t')) line.remove_prefix(1);
    };
    skip_blanks();
    if (!line.starts_with('#')) return {};
    line.remove_prefix(1);
    skip_blanks();
    if (!line.starts_with("include")) return {};
    line.remove_prefix(7);
    skip_blanks();
    if (line.empty() || (line.front() != '"' && line.front() != '<')) return {};
    const bool generated = line.front() == '<';
    const std::size_t end = line.find(generated ? '>' : '"', 1);
    if (end == std::string_view::npos) return {};
    const std::string name(line.substr(1, end - 1));
    line.remove_prefix(end + 1);
    skip_blanks();
    return Include{name, generated, line.empty() || line == "\r" || line.starts_with("//")};
}

struct Expansion {
    const Sources& sources;
    std::set<std::string> seen;
    std::string text;
    std::vector<std::string> files;

    void append(std::string_view source, const std::string& name) {
        text += fmt::format("#line 1 \"{}\"\n", name);
        int number = 0;
        while (!source.empty()) {
            ++number;
            const std::size_t end = source.find('\n');
            const std::string_view line = source.substr(0, end);
            source.remove_prefix(end == std::string_view::npos ? source.size() : end + 1);
            if (line.find('\0') != line.npos) // glslang would take it for the text's end
                throw CompileError("{}:{}: a NUL byte: this is no text", name, number);
            const std::optional<Include> include = parse_include(line);
            if (!include) {
                text += line;
                text += '\n';
                continue;
            }
            if (!include->alone)
                throw CompileError("{}:{}: behind an include only a comment (//) may stand on its line", name,
                                   number);
            append_once(*include, name, number);
            text += fmt::format("#line {} \"{}\"\n", number + 1, name);
        }
    }

    void append_once(const Include& include, const std::string& from, int line) {
        const std::string name =
            include.generated ? "<" + include.name + ">" : display_name(sources.root, include.name);
        if (!seen.insert(name).second) return;
        if (include.generated) {
            const auto found = sources.generated.find(include.name);
            if (found == sources.generated.end())
                throw CompileError("{}:{}: nothing generates <{}>", from, line, include.name);
            append(found->second, name);
            return;
        }
        std::string source;
        try {
            source = text_of(sources, include.name);
        } catch (const Error&) {
            throw CompileError("{}:{}: cannot include \"{}\": no such file below {}", from, line,
                               include.name, sources.root.string());
        }
        files.push_back(include.name);
        append(source, name);
    }

    /// What a user calls the file: the kernels folder's own name and the path below it.
    static std::string display_name(const std::filesystem::path& root, const std::string& file) {
        const std::filesystem::path folder = root.has_filename() ? root : root.parent_path();
        return (folder.filename() / file).lexically_normal().generic_string();
    }
};

} // namespace

std::string text_of(const Sources& sources, const std::string& file) {
    const auto overlaid = sources.overlaid.find(file);
    return overlaid != sources.overlaid.end() ? overlaid->second : read_file(sources.root / file);
}

Sources frozen(Sources sources) {
    namespace fs = std::filesystem;
    std::error_code error, ignored;
    for (fs::recursive_directory_iterator entry(sources.root, error), end; !error && entry != end;
         entry.increment(error)) {
        const std::string file = entry->path().lexically_relative(sources.root).generic_string();
        if (!entry->is_regular_file(ignored) || sources.overlaid.contains(file)) continue;
        try {
            sources.overlaid[file] = read_file(entry->path());
        } catch (const Error&) { // it concerns nobody but those who include it, and they are told
        }
    }
    return sources;
}

std::string expand(const Sources& sources, std::string_view text, std::string_view name) {
    Expansion expansion{sources, {}, {}, {}};
    expansion.text = "#version 460\n#extension GL_GOOGLE_cpp_style_line_directive : require\n";
    expansion.append(text, std::string(name));
    return std::move(expansion.text);
}

std::vector<std::string> included_files(const Sources& sources, std::string_view text) {
    Expansion expansion{sources, {}, {}, {}};
    expansion.append(text, "<text>");
    return std::move(expansion.files);
}

} // namespace gnomon::glsl
