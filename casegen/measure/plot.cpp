#include "casegen/measure/plot.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::measure {

void Svg::line(double x0, double y0, double x1, double y1, std::string_view style) {
    body_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" {}/>\n", x0, y0, x1, y1, style);
}

void Svg::polyline(const std::vector<std::pair<double, double>>& points, std::string_view style) {
    if (points.empty()) return;
    std::string list;
    for (const auto& [x, y] : points) list += fmt::format("{}{:.1f},{:.1f}", list.empty() ? "" : " ", x, y);
    body_ += fmt::format("<polyline points=\"{}\" fill=\"none\" {}/>\n", list, style);
}

void Svg::rectangle(double x, double y, double width, double height, std::string_view style) {
    body_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" {}/>\n", x, y,
                         width, height, style);
}

void Svg::text(double x, double y, std::string_view text, std::string_view style) {
    body_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, style, atlas::escape_html(text));
}

void Svg::marker(std::size_t shape, double x, double y, double radius, std::string_view style) {
    if (shape % 6 == 0) {
        body_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.1f}\" {}/>\n", x, y, radius, style);
        return;
    }
    // Corners on the unit circle's scale, areas about that of the circle.
    static const std::array<std::vector<std::pair<double, double>>, 6> shapes{{
        {},
        {{-0.9, -0.9}, {0.9, -0.9}, {0.9, 0.9}, {-0.9, 0.9}},
        {{0, -1.25}, {1.15, 0.85}, {-1.15, 0.85}},
        {{0, -1.3}, {1.3, 0}, {0, 1.3}, {-1.3, 0}},
        {{0, 1.25}, {-1.15, -0.85}, {1.15, -0.85}},
        {{-0.4, -1.2},
         {0.4, -1.2},
         {0.4, -0.4},
         {1.2, -0.4},
         {1.2, 0.4},
         {0.4, 0.4},
         {0.4, 1.2},
         {-0.4, 1.2},
         {-0.4, 0.4},
         {-1.2, 0.4},
         {-1.2, -0.4},
         {-0.4, -0.4}},
    }};
    std::string list;
    for (const auto& [dx, dy] : shapes[shape % 6])
        list += fmt::format("{}{:.1f},{:.1f}", list.empty() ? "" : " ", x + radius * dx, y + radius * dy);
    body_ += fmt::format("<polygon points=\"{}\" {}/>\n", list, style);
}

void Svg::open_group(std::string_view title) {
    body_ += fmt::format("<g><title>{}</title>\n", atlas::escape_html(title));
}
void Svg::close_group() { body_ += "</g>\n"; }

std::string Svg::finish(std::string_view title) const {
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" role=\"img\" font-family=\"'Source Sans 3','Segoe UI',system-ui,'DejaVu "
        "Sans',sans-serif\" font-size=\"11\" fill=\"#1d2129\" stroke-linejoin=\"round\">\n"
        "<title>{2}</title>\n<rect width=\"{0:.0f}\" height=\"{1:.0f}\" fill=\"#fff\"/>\n{3}</svg>\n",
        width_, height_, atlas::escape_html(title), body_);
}

double LogAxis::operator()(double value) const {
    double at = upper;
    if (!(value > 0))
        at = std::isnan(value) ? upper : lower;
    else if (std::isfinite(value))
        at = std::clamp(std::log10(value), static_cast<double>(lower), static_cast<double>(upper));
    return from + (to - from) * (at - lower) / (upper - lower);
}

LogAxis axis_around(const std::vector<double>& values, int lower, int upper) {
    double least = HUGE_VAL, most = 0;
    for (const double value : values)
        if (std::isfinite(value) && value > 0) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    LogAxis axis;
    if (most > 0) {
        axis.lower = static_cast<int>(std::floor(std::log10(least)));
        axis.upper = static_cast<int>(std::ceil(std::log10(most)));
    }
    axis.lower = std::clamp(axis.lower, lower, upper - 1);
    axis.upper = std::clamp(axis.upper, axis.lower + 1, upper);
    return axis;
}

std::string power_of_ten(int exponent) {
    static constexpr std::array digits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = "10";
    for (const char c : std::to_string(exponent))
        text += c == '-' ? "⁻" : digits[static_cast<std::size_t>(c - '0')];
    return exponent == 0 ? "1" : text;
}

const char* colour(std::size_t n) {
    static constexpr std::array colours{"#332288", "#cc6677", "#117733", "#dca300", "#88ccee",
                                        "#882255", "#44aa99", "#777711", "#aa4499"};
    return colours[n % colours.size()];
}

} // namespace gnomon::measure
