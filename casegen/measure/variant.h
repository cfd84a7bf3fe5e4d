// Kernels that compute one quantity in different ways, side by side.
#pragma once

#include "casegen/kernel_case.h"
#include "casegen/trigonometry.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace gnomon::measure {

/// One kernel as it is measured.
struct Variant {
    const Case* kernel = nullptr;
    Trigonometry trigonometry = Trigonometry::portable;
    std::string label; ///< what tables and pictures call it: "sinc", "sinc, built-in"
};

/// "integral/sinc/a0", or with its mode of trigonometry behind: "integral/sinc/a0, built-in".
std::string full_name(const Variant& variant);

/// Variants of one quantity: they share parameters, generator and reference, and run on the same inputs.
struct Group {
    std::string name; ///< the quantity's, or that of a kernel that is alone
    /// What is asked of all of them. Its domain is that of any kernel of the quantity, those that are not
    /// measured included: a form that is good on a part of it only is measured on all of it.
    Case quantity;
    std::vector<Variant> variants;
};

/// `cases` by their quantity, in the order of their first ones; a kernel without a quantity is a group of
/// its own, and so are those that share a quantity's name and not its parameters. Every kernel in each mode
/// in which its text differs from that in the modes before.
std::vector<Group> group(std::span<const Case* const> cases, std::span<const Trigonometry> modes,
                         const std::filesystem::path& kernels);

/// For each of `patterns` (see pattern.h) the kernels of a quantity of exactly this name; if there are none,
/// those that find_cases finds. Throws Error as find_cases does.
std::vector<const Case*> find_variants(const std::string& patterns);

} // namespace gnomon::measure
