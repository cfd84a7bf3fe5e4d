// Kernels that compute one quantity in different ways, side by side.
#pragma once

#include "casegen/kernel_case.h"
#include "runtime/glsl/compiler.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

/// Whose sine, cosine and exponential a kernel calls.
enum class Trigonometry { portable };
std::string to_string(Trigonometry trigonometry);
/// "portable". Throws Error that lists what there is.
Trigonometry parse_trigonometry(const std::string& text);

/// Where the kernels of a mode come from.
glsl::Sources sources_of(const std::filesystem::path& kernels, Trigonometry trigonometry);

/// One kernel as it is measured.
struct Variant {
    const Case* kernel = nullptr;
    Trigonometry trigonometry = Trigonometry::portable;
    std::string label; ///< what tables and pictures call it: "sinc", "sinc, built-in"
};

/// Variants of one quantity: they share parameters, generator and reference, and run on the same inputs.
struct Group {
    std::string name; ///< the quantity's, or that of a kernel that is alone
    std::vector<Variant> variants;
};

/// `cases` by their quantity, in the order of their first ones; a kernel without a quantity is a group of
/// its own, and so are those that share a quantity's name and not its parameters. Every kernel once in each
/// mode, where modes make a difference to it.
std::vector<Group> group(std::span<const Case* const> cases, std::span<const Trigonometry> modes);

/// Kernels of a quantity of exactly this name; else those that find_cases finds.
std::vector<const Case*> find_variants(const std::string& pattern);

} // namespace gnomon::measure
