// One of the two sides of a comparison, as people name it: a kernel's file, a kernel of the catalogue, a
// folder of kernels, or a git revision of one.
#pragma once

#include "casegen/kernel_case.h"
#include "runtime/glsl/compiler.h"

#include <filesystem>
#include <map>
#include <string>

namespace gnomon::versus {

struct Side {
    std::string label;            ///< as it was named; of a revision with its commit: "HEAD~3 (4dbb942)"
    std::filesystem::path folder; ///< the kernels' folder: for a revision a copy in the cache
    const Case* kernel = nullptr; ///< the one that was named; null: any kernel of the folder
    std::map<std::string, std::string> overlaid; ///< as glsl::Sources has it: the text of a lone file
    std::string options; ///< what `gnomon eval` needs to run this side: " --kernels 'there'"
};

/// What `text` names, the first of these that there is:
///   "git:HEAD~3", "HEAD~3:"   that revision of the repository in which `kernels` lies
///   a folder                  with kernels below it
///   a file                    the kernel whose function it defines; its includes are looked for in the
///   folder
///                             that it lies in as a kernel's file does (there/smsr/case_09.glsl), else in
///                             `kernels`
///   "smsr/case_09"            the kernel of exactly this name in `kernels`
///   "HEAD~3"                  the revision
/// `kernel_name`, if not empty, says which kernel a file stands for, whatever its function is called. Throws
/// Error if nothing is named so, or a file defines no kernel's function, or several.
Side side_of(const std::string& text, const std::filesystem::path& kernels,
             const std::string& kernel_name = {});

/// The text of a file that is to stand for kernel `c`: as it is if it defines the kernel's function; with a
/// function of that name added which calls the only one that takes as many parameters otherwise. Throws Error
/// naming the file.
std::string text_for(const Case& c, const std::filesystem::path& file);

glsl::Sources sources_of(const Side& side);

/// Whether there is a text for the kernel.
bool has_kernel(const Side& side, const Case& c);

} // namespace gnomon::versus
