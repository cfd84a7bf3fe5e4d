#include "casegen/mask.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/image.h"

namespace gnomon {
namespace {

constexpr int longest_side = 16384;

Mask from_image(const Image& image) {
    Mask mask(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            const Rgb& pixel = image.at(x, y);
            mask.set(x, y, pixel.r + pixel.g + pixel.b >= 3 * 128);
        }
    return mask;
}

} // namespace

Mask parse_mask(std::string_view text, char separator, const std::string& name) {
    std::vector<std::string_view> rows;
    while (!text.empty()) {
        const std::size_t end = text.find(separator);
        std::string_view row = text.substr(0, end);
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
        if (!row.empty() && row.back() == '\r') row.remove_suffix(1);
        rows.push_back(row);
    }
    while (!rows.empty() && rows.back().empty()) rows.pop_back();
    if (rows.empty() || rows.front().empty())
        throw Error("{}: no texels; a mask is rows of '#' (shadow) and '.' (lit)", name);
    const std::size_t width = rows.front().size();
    if (width > longest_side || rows.size() > longest_side)
        throw Error("{}: {} x {} texels; at most {} on a side", name, width, rows.size(), longest_side);
    Mask mask(static_cast<int>(width), static_cast<int>(rows.size()));
    for (std::size_t y = 0; y < rows.size(); ++y) {
        if (rows[y].size() != width)
            throw Error("{}: row {} has {} texels, the first has {}; all rows must be equally long", name,
                        y + 1, rows[y].size(), width);
        for (std::size_t x = 0; x < width; ++x) {
            const char texel = rows[y][x];
            if (texel != '#' && texel != '.')
                throw Error("{}: row {}, column {} is {}; only '#' (shadow) and '.' (lit) are texels", name,
                            y + 1, x + 1,
                            texel >= ' ' && texel <= '~'
                                ? fmt::format("'{}'", texel)
                                : fmt::format("byte {:#04x}", static_cast<unsigned char>(texel)));
            mask.set(static_cast<int>(x), static_cast<int>(y), texel == '.');
        }
    }
    return mask;
}

std::string format_mask(const Mask& mask, char separator) {
    std::string text;
    for (int y = 0; y < mask.height; ++y) {
        if (y > 0) text += separator;
        for (int x = 0; x < mask.width; ++x) text += mask.lit(x, y) ? '.' : '#';
    }
    return text;
}

Mask load_mask(const std::filesystem::path& path) {
    const std::string bytes = read_file(path);
    if (std::string_view(bytes).starts_with("\x89PNG")) return from_image(read_png(path));
    return parse_mask(bytes, '\n', path.string());
}

Mask without_isolated(const Mask& mask) {
    Mask result = mask;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) {
            const bool here = mask.lit(x, y);
            if (mask.lit(x - 1, y) != here && mask.lit(x + 1, y) != here && mask.lit(x, y - 1) != here &&
                mask.lit(x, y + 1) != here)
                result.set(x, y, !here);
        }
    return result;
}

Mask transposed(const Mask& mask) {
    Mask result(mask.height, mask.width, true, mask.outside);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) result.set(y, x, mask.lit(x, y));
    return result;
}

Mask mirrored_x(const Mask& mask) {
    Mask result(mask.width, mask.height, true, mask.outside);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) result.set(mask.width - 1 - x, y, mask.lit(x, y));
    return result;
}

Mask mirrored_y(const Mask& mask) {
    Mask result(mask.width, mask.height, true, mask.outside);
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) result.set(x, mask.height - 1 - y, mask.lit(x, y));
    return result;
}

} // namespace gnomon
