// Binary shadow masks: a shadow map seen from one receiver, which is all that revectorisation sees.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon {

/// What a texel beyond the map answers: the nearest texel of the map (clamp-to-edge), or always one value.
enum class Outside : std::uint32_t { clamp, lit, shadow };

/// Row-major; row 0 is y = 0, the -y side; 1 lit, 0 shadowed.
struct Mask {
    int width = 0, height = 0;
    Outside outside = Outside::clamp;
    std::vector<std::uint8_t> texels;

    Mask() = default;
    Mask(int columns, int rows, bool filled_with = true, Outside surround = Outside::clamp)
        : width(columns), height(rows), outside(surround),
          texels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), filled_with ? 1 : 0) {}

    /// Any x and y, inside the map or not.
    bool lit(int x, int y) const {
        if (x < 0 || y < 0 || x >= width || y >= height) {
            if (outside != Outside::clamp) return outside == Outside::lit;
            x = x < 0 ? 0 : x >= width ? width - 1 : x;
            y = y < 0 ? 0 : y >= height ? height - 1 : y;
        }
        return texels[index(x, y)] != 0;
    }
    void set(int x, int y, bool lit) { texels[index(x, y)] = lit ? 1 : 0; }

    friend bool operator==(const Mask&, const Mask&) = default;

private:
    std::size_t index(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

/// Rows of '#' (shadow) and '.' (lit), the first row is y = 0; ended by `separator`, the last end may be
/// missing. `name` stands for the text in messages. Throws Error naming the row (and column): rows of
/// different lengths, any other character, no texels, more than 16384 on a side.
Mask parse_mask(std::string_view text, char separator, const std::string& name);

/// The same text; parse_mask(format_mask(m, c), c, …) has m's texels.
std::string format_mask(const Mask& mask, char separator);

/// A PNG (darker than 50 % is shadow) or a text file with rows as above. Throws Error naming the file.
Mask load_mask(const std::filesystem::path& path);

/// The mask with every texel flipped whose four neighbours all differ from it: what revectorisation sees if
/// isolated texels are not edges to their neighbours. docs/decisions.md, A9.
Mask without_isolated(const Mask& mask);

/// x and y exchanged; x mirrored; y mirrored.
Mask transposed(const Mask& mask);
Mask mirrored_x(const Mask& mask);
Mask mirrored_y(const Mask& mask);

} // namespace gnomon
