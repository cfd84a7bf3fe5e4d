#include "casegen/atlas/picture.h"

#include "casegen/atlas/html.h"
#include "casegen/csv.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

namespace gnomon::atlas {
namespace {

constexpr int unit = texel_pixels;

std::string opened(const Mask& mask, const char* attributes, int pixels) {
    const int columns = mask.width + 2, rows = mask.height + 2;
    return fmt::format("<svg {} width=\"{}\" height=\"{}\" viewBox=\"0 0 {} {}\">", attributes,
                       columns * pixels, rows * pixels, columns * unit, rows * unit);
}

std::string rectangle(const char* what, int x, int y, int width, int height) {
    return fmt::format("<rect class=\"{}\" x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\"/>", what, x * unit,
                       y * unit, width * unit, height * unit);
}

/// From inside the texel at (x, y) over the side that lies towards (dx, dy).
std::string arrow(int x, int y, int dx, int dy) {
    const double cx = (x + 0.5) * unit, cy = (y + 0.5) * unit;
    const auto at = [&](double along, double across) {
        return fmt::format("{:g} {:g}", cx + unit * (dx * along - dy * across),
                           cy + unit * (dy * along + dx * across));
    };
    return fmt::format("<path class=\"shaft\" d=\"M{} L{}\"/><path class=\"head\" d=\"M{} L{} L{} Z\"/>",
                       at(0.12, 0), at(0.62, 0), at(0.86, 0), at(0.58, -0.15), at(0.58, 0.15));
}

std::string outline(const Witness& witness) {
    return rectangle("tested", witness.texel.x + 1, witness.texel.y + 1, 1, 1);
}

} // namespace

std::string witness_svg(const Witness& witness, const std::string& alternative, int pixels) {
    const Mask& mask = witness.mask;
    std::string svg = opened(mask, "class=\"mask\" role=\"img\"", pixels);
    svg += fmt::format("<title>{}</title>", escape_html(alternative));
    for (int y = -1; y <= mask.height; ++y)
        for (int x = -1; x <= mask.width; ++x) {
            const bool inside = x >= 0 && y >= 0 && x < mask.width && y < mask.height;
            svg += rectangle(mask.lit(x, y) ? "lit" : "dark", x + 1, y + 1, 1, 1);
            if (!inside) svg += rectangle("beyond", x + 1, y + 1, 1, 1);
        }
    svg += rectangle("border", 1, 1, mask.width, mask.height);
    svg += outline(witness);
    const glm::uvec2 sides = reference::edge(mask, witness.texel).sides;
    const int x = witness.texel.x + 1, y = witness.texel.y + 1;
    if ((sides.x & reference::minus) != 0) svg += arrow(x, y, -1, 0);
    if ((sides.x & reference::plus) != 0) svg += arrow(x, y, 1, 0);
    if ((sides.y & reference::minus) != 0) svg += arrow(x, y, 0, -1);
    if ((sides.y & reference::plus) != 0) svg += arrow(x, y, 0, 1);
    return svg + "</svg>";
}

std::string grid_svg(const Witness& witness) {
    const Mask& mask = witness.mask;
    std::string svg = opened(mask, "class=\"grid\" aria-hidden=\"true\"", unit);
    for (int x = 1; x < mask.width + 2; ++x)
        svg += fmt::format("<path d=\"M{} 0V{}\"/>", x * unit, (mask.height + 2) * unit);
    for (int y = 1; y < mask.height + 2; ++y)
        svg += fmt::format("<path d=\"M0 {}H{}\"/>", y * unit, (mask.width + 2) * unit);
    return svg + outline(witness) + "</svg>";
}

std::string witness_words(const Witness& witness) {
    const Mask& mask = witness.mask;
    std::vector<std::string> shadow;
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            if (!mask.lit(x, y)) shadow.push_back(fmt::format("{},{}", x, y));
    return fmt::format("texel {},{} of {} × {} texels, {} around; in shadow: {}", witness.texel.x,
                       witness.texel.y, mask.width, mask.height, to_string(mask.outside),
                       shadow.empty() ? "none" : fmt::format("{}", fmt::join(shadow, " ")));
}

} // namespace gnomon::atlas
