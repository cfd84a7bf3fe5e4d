// GLSL text to SPIR-V words, with includes between kernel files and errors on the author's line.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::glsl {

/// Where `#include` looks. `#include "smsr/case_09.glsl"` is a file below `root`; `#include <smsr/cases>` is
/// a text that the program generates. Either is included at most once in a translation unit, so a kernel
/// includes what it uses without guards.
struct Sources {
    std::filesystem::path root;                   ///< the kernels folder
    std::map<std::string, std::string> generated; ///< name between <> to text
    /// Path below `root` to a text that stands for the file's: a file changed without touching it.
    std::map<std::string, std::string> overlaid = {};
};

/// The text of a file below `root`, or what stands for it. Throws Error (read_file).
std::string text_of(const Sources& sources, const std::string& file);

/// The same with the texts that all files of the folder have now: who compiles from it later, maybe in
/// another process, sees no edit. Folders behind symbolic links are not among them.
Sources frozen(Sources sources);

enum class Stage { compute, vertex, fragment, geometry };

using Spirv = std::vector<std::uint32_t>;

/// `text` with every include replaced by what it names, and #line directives that lead an error back to the
/// author's file. `name` stands for `text` itself in messages. Throws CompileError at the line of an include
/// that finds nothing.
std::string expand(const Sources& sources, std::string_view text, std::string_view name);

/// The files below `sources.root` that expanding `text` reads, in the order in which it first does:
/// "smsr/case_09.glsl". Throws CompileError as expand does.
std::vector<std::string> included_files(const Sources& sources, std::string_view text);

/// Compiles for Vulkan 1.3 and validates the result; keeps it on disk under a key of the expanded text, the
/// stage and glslang's version, and takes it from there the next time. A damaged cache file is compiled anew.
/// Throws CompileError "kernels/smsr/case_09.glsl:12: …" (all of glslang's messages, a line each).
/// Thread-safe.
Spirv compile(const Sources& sources, std::string_view text, std::string_view name, Stage stage);

/// The same of a text that was expanded already: what it was expanded from may have changed since. `kept`
/// false neither looks into the cache nor leaves anything there.
Spirv compile_expanded(const std::string& expanded, std::string_view name, Stage stage, bool kept = true);

/// The same as compile without looking into the cache and without leaving anything there: to measure it.
Spirv compile_anew(const Sources& sources, std::string_view text, std::string_view name, Stage stage);

/// What a translation unit that was expanded already is in the cache; empty if it is not there.
Spirv find_cached(std::string_view expanded, Stage stage);

/// Builds glslang's tables (70–100 ms, once a process). compile() does it when it must; calling this in
/// another thread while Vulkan starts hides it.
void warm_up();

/// "glslang 12.0.0", as part of the cache key and of `gnomon --version`.
std::string version();

} // namespace gnomon::glsl
