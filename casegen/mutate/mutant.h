// Mutants: kernels' files with one small change, and who compiles them.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/mutate/operators.h"
#include "runtime/glsl/compiler.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace gnomon::mutate {

struct Mutant {
    /// Ten hexadecimal digits. The same as long as the file's name and the changed function's text are,
    /// whatever is edited elsewhere, comments and blanks included.
    std::string id;
    std::string file; ///< below the kernels folder: "smsr/case_09.glsl"
    Mutation mutation;
    std::string
        before;       ///< what is replaced; of stale ones what includes the file, and so sees another version
    std::string text; ///< the changed file
    /// Whose checks may notice, those with the least text first: the file's own kernel, or, for what several
    /// kernels share (.glslh), all that include it, or, for a stale one, the kernel that sees it.
    std::vector<const Case*> users;
};

/// All mutants that count for one of `cases`: those of its own file, of each .glslh that it includes, and a
/// stale version of each other kernel's file that it includes. In the order of the files' names, then of the
/// text. Kernels that must fail have none, and notice none. Throws Error if two have one id; CompileError for
/// an include that is not there.
std::vector<Mutant> mutants_of(std::span<const Case* const> cases, const glsl::Sources& sources,
                               std::span<const Operator> operators);

/// Whether a mutant counts for a kernel. `files`: what the kernel includes.
bool counts_for(const Mutant& mutant, const Case& c, std::span<const std::string> files);

/// What a kernel's text includes (glsl::included_files), its own file among them.
std::vector<std::string> files_of(const Case& c, const glsl::Sources& sources);

/// `sources` as the mutant's users see them.
glsl::Sources with(const glsl::Sources& sources, const Mutant& mutant);

/// The whole line that is changed, before and after, without indentation: "- a < b" and "+ a <= b", each with
/// "\n". Of a change over several lines the first and the last, with "…" between.
std::string difference(const Mutant& mutant, const glsl::Sources& sources);

} // namespace gnomon::mutate
