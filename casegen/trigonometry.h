// Where the kernels' sin, cos and exp come from. Vulkan promises little of its own: sin and cos within 2⁻¹¹
// on -π … π and nothing beyond, exp within 3 + 2|x| ulps.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

enum class Trigonometry {
    portable, ///< kernels/integral/elementary: the same bits on every device
    built_in, ///< the device's
    coarse,   ///< built-in, made as wrong as a device may be: what a phone could do
};

/// "portable", "built-in", "coarse": the default first.
const std::vector<std::string>& trigonometry_names();
/// Throws Error with the names that there are.
Trigonometry parse_trigonometry(const std::string& name);
std::string to_string(Trigonometry trigonometry);

/// What kernels include as <integral/trigonometry>.
std::string trigonometry_source(Trigonometry trigonometry);

} // namespace gnomon
