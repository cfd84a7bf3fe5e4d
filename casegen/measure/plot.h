// Scalable pictures with logarithmic axes, as text that needs nothing but itself.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace gnomon::measure {

/// Elements in the order they are drawn in; coordinates in pixels, y downwards.
class Svg {
public:
    Svg(double width, double height) : width_(width), height_(height) {}

    double width() const { return width_; }
    double height() const { return height_; }

    /// `style` is further attributes: "stroke=\"#000\"".
    void line(double x0, double y0, double x1, double y1, std::string_view style);
    void polyline(const std::vector<std::pair<double, double>>& points, std::string_view style);
    void rectangle(double x, double y, double width, double height, std::string_view style);
    void text(double x, double y, std::string_view text, std::string_view style = {});
    /// One of several shapes that can be told apart without colour.
    void marker(std::size_t shape, double x, double y, double radius, std::string_view style);
    /// Anything else; `title` is shown where the pointer rests.
    void open_group(std::string_view title);
    void close_group();

    std::string finish(std::string_view title) const;

private:
    double width_, height_;
    std::string body_;
};

/// Positions along an axis by decades.
struct LogAxis {
    int lower = 0, upper = 1; ///< powers of ten at the ends
    double from = 0, to = 1;  ///< pixels of the ends

    /// Clamped to the ends; 0 lies at the lower end, what is not finite at the upper one.
    double operator()(double value) const;
};

/// The whole decades around the positive finite ones among `values`, at least one, within `lower` … `upper`.
LogAxis axis_around(const std::vector<double>& values, int lower, int upper);

/// "10⁻⁷".
std::string power_of_ten(int exponent);

/// Colours that people with any colour vision can tell apart (Paul Tol's "muted" scheme), in a circle.
const char* colour(std::size_t n);

} // namespace gnomon::measure
