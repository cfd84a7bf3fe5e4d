#include "casegen/versus/side.h"

#include "casegen/catalogue.h"
#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/git.h"
#include "runtime/glsl/tokens.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include <unistd.h>

namespace gnomon::versus {
namespace {

namespace fs = std::filesystem;

const Case* find_exactly(const std::string& name) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (c.name == name) return &c;
    return nullptr;
}

std::vector<std::string> functions_of(const std::string& text) {
    std::vector<std::string> names;
    const std::vector<glsl::Token> tokens = glsl::tokens(text);
    for (const glsl::Function& function : glsl::functions(tokens)) names.emplace_back(function.name);
    return names;
}

/// Kernels whose function the text defines.
std::vector<const Case*> kernels_in(const std::string& text) {
    const std::vector<std::string> functions = functions_of(text);
    std::vector<const Case*> found;
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (std::ranges::find(functions, function_name(c)) != functions.end()) found.push_back(&c);
    return found;
}

/// "there" if the file is there/<name>.glsl; else nothing.
fs::path folder_around(const fs::path& file, const Case& c) {
    fs::path rest = fs::absolute(file).lexically_normal().replace_extension();
    const fs::path name = c.name;
    for (auto part = std::make_reverse_iterator(name.end()); part != std::make_reverse_iterator(name.begin());
         ++part) {
        if (rest.filename() != *part) return {};
        rest = rest.parent_path();
    }
    return rest;
}

/// The kernel whose file this is by where it lies.
const Case* kernel_at(const fs::path& file) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (!folder_around(file, c).empty()) return &c;
    return nullptr;
}

const Case& kernel_of(const fs::path& file, const std::string& text, const std::string& kernel_name) {
    if (!kernel_name.empty()) return find_case(kernel_name);
    if (const Case* there = kernel_at(file)) return *there;
    const std::vector<const Case*> found = kernels_in(text);
    if (found.size() == 1) return *found.front();
    if (found.empty())
        throw Error("{}: defines none of the catalogue's functions (it has: {}); --kernel NAME says which "
                    "kernel it stands for",
                    file.string(), fmt::join(functions_of(text), ", "));
    std::vector<std::string> names;
    for (const Case* c : found) names.push_back(c->name);
    throw Error("{}: defines the functions of several kernels ({}); --kernel NAME says which one is meant",
                file.string(), fmt::join(names, ", "));
}

Side side_of_file(const fs::path& file, const fs::path& kernels, const std::string& kernel_name) {
    if (file.extension() != ".glsl")
        throw Error("{}: not a kernel's file, whose name ends in .glsl", file.string());
    const Case& c = kernel_of(file, read_file(file), kernel_name);
    Side side;
    side.label = file.string();
    side.kernel = &c;
    const std::string text = text_for(c, file);
    const fs::path around = folder_around(file, c);
    side.folder = around.empty() ? kernels : around;
    side.options = fmt::format(" --kernels {}", in_quotes(side.folder.string()));
    if (around.empty() || text != read_file(file)) {
        side.overlaid[c.name + ".glsl"] = text;
        side.options += fmt::format(" --file {}", in_quotes(file.string()));
    }
    return side;
}

/// The revision's kernels in the cache, under the name of their content: written once, never changed.
fs::path unpacked(const fs::path& kernels, const git::FolderAt& at) {
    const fs::path folder = cache_directory() / "revisions" / at.tree / "kernels";
    if (fs::is_directory(folder)) return folder;
    const fs::path made = cache_directory() / "revisions" / fmt::format("{}-{}", at.tree, ::getpid());
    try {
        for (const auto& [name, text] : git::files_of(kernels, at)) {
            const fs::path path = made / "kernels" / name;
            fs::create_directories(path.parent_path());
            write_file(path, text);
        }
        fs::create_directories(made / "kernels"); // even if there was no file
        fs::rename(made, folder.parent_path());
    } catch (const fs::filesystem_error& error) {
        std::error_code ignored;
        fs::remove_all(made, ignored);
        if (!fs::is_directory(folder)) // another process may have been faster
            throw Error("{}: cannot hold the kernels of {}: {}", folder.string(), at.commit,
                        error.code().message());
    } catch (...) {
        std::error_code ignored;
        fs::remove_all(made, ignored);
        throw;
    }
    return folder;
}

Side side_of_revision(const std::string& revision, const fs::path& kernels) {
    const git::FolderAt at = git::find_folder(kernels, revision);
    Side side;
    side.label = revision == at.commit ? revision : fmt::format("{} ({})", revision, at.commit);
    side.folder = unpacked(kernels, at);
    side.options = fmt::format(" --kernels {}", in_quotes(side.folder.string()));
    return side;
}

/// A folder that holds one kernel's file at least, where a kernel's file belongs.
void require_kernels_below(const fs::path& folder) {
    for (const Family& family : catalogue())
        for (const Case& c : family.cases)
            if (fs::is_regular_file(folder / (c.name + ".glsl"))) return;
    throw Error("{}: holds no kernel, as {}.glsl would be; name the folder above the families'",
                folder.string(), catalogue().front().cases.front().name);
}

} // namespace

Side side_of(const std::string& text, const fs::path& kernels, const std::string& kernel_name) {
    if (text.starts_with("git:")) return side_of_revision(text.substr(4), kernels);
    if (text.size() > 1 && text.ends_with(':'))
        return side_of_revision(text.substr(0, text.size() - 1), kernels);
    if (fs::is_directory(text)) {
        require_kernels_below(text);
        Side side;
        side.label = text;
        side.folder = text;
        side.options = fmt::format(" --kernels {}", in_quotes(text));
        return side;
    }
    if (fs::is_regular_file(text)) return side_of_file(text, kernels, kernel_name);
    if (const Case* c = find_exactly(text)) {
        Side side;
        side.label = text;
        side.folder = kernels;
        side.kernel = c;
        side.options = fmt::format(" --kernels {}", in_quotes(kernels.string()));
        return side;
    }
    if (text.ends_with(".glsl")) throw Error("{}: no such file", text);
    try {
        return side_of_revision(text, kernels);
    } catch (const Error& error) {
        throw Error("\"{}\" is no folder, no file, no kernel's whole name, and no git revision: {}", text,
                    error.what());
    }
}

std::string text_for(const Case& c, const fs::path& file) {
    std::string text = read_file(file);
    const std::string wanted = function_name(c);
    const std::vector<glsl::Token> tokens = glsl::tokens(text);
    const std::vector<glsl::Function> functions = glsl::functions(tokens);
    if (std::ranges::any_of(functions, [&](const glsl::Function& f) { return f.name == wanted; }))
        return text;
    std::vector<std::string> able, all;
    for (const glsl::Function& function : functions) {
        all.emplace_back(function.name);
        const std::size_t close = glsl::closing(tokens, function.open);
        std::vector<std::string_view> types; // the words of the parameters that name a type of the table's
        std::size_t parameters = close > function.open + 1 ? 1 : 0;
        for (std::size_t i = function.open + 1; i < close; ++i) {
            if (tokens[i].is(",")) ++parameters;
            if (types.size() < parameters && types.size() < c.parameters.size() &&
                tokens[i].is(glsl_name(c.reference.parameters[types.size()])))
                types.push_back(tokens[i].text);
        }
        if (parameters == c.parameters.size() && types.size() == parameters &&
            tokens[function.type].is(glsl_name(c.reference.result)))
            able.emplace_back(function.name);
    }
    if (able.size() != 1)
        throw Error("{}: defines neither {} nor exactly one other function with its parameters (it has: {})",
                    file.string(), signature(c), fmt::join(all, ", "));
    std::vector<std::string> names;
    for (const Parameter& parameter : c.parameters) names.push_back(parameter.name);
    if (!text.ends_with('\n')) text += '\n';
    return text +
           fmt::format("{} {{ return {}({}); }}\n", signature(c), able.front(), fmt::join(names, ", "));
}

glsl::Sources sources_of(const Side& side) {
    glsl::Sources sources = kernel_sources(side.folder);
    sources.overlaid = side.overlaid;
    return sources;
}

bool has_kernel(const Side& side, const Case& c) {
    const std::string file = c.name + ".glsl";
    return side.overlaid.contains(file) || fs::is_regular_file(side.folder / file);
}

} // namespace gnomon::versus
