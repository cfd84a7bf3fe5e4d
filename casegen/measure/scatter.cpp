#include "casegen/measure/scatter.h"

#include "casegen/measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::measure {
namespace {

constexpr double width = 1120, panel_height = 400, gap = 30, margin = 20;
constexpr double left = 46, right = 10, top = 26, bottom = 44;
constexpr double lane = 34; // of errors that are 0, and of those that are not finite
constexpr double row = 18;  // of the legend and the notes

struct Axes {
    LogAxis cost, error;
};

void draw_lane(Svg& svg, const Axes& axes, double y, const char* name, const char* fill, const char* ink) {
    svg.rectangle(axes.cost.from, y, axes.cost.to - axes.cost.from, lane, fill);
    svg.text(axes.cost.to - 4, y + 11, name, fmt::format("text-anchor=\"end\" font-size=\"10\" {}", ink));
}

void draw_axes(Svg& svg, const Axes& axes, const Panel& panel) {
    const double x0 = axes.cost.from, x1 = axes.cost.to, y0 = axes.error.from, y1 = axes.error.to;
    svg.text(x0, y1 - lane - 10, panel.title, "font-weight=\"600\" font-size=\"13\"");
    draw_lane(svg, axes, y1 - lane, "not finite", "fill=\"#f6e3df\"", "fill=\"#8a5248\"");
    draw_lane(svg, axes, y0, "0", "fill=\"#e6f1e6\"", "fill=\"#3f6b45\"");
    const int every = axes.error.upper - axes.error.lower > 10 ? 2 : 1;
    for (int decade = axes.error.lower; decade <= axes.error.upper; ++decade) {
        const double at = axes.error(std::pow(10.0, decade));
        svg.line(x0, at, x1, at, "stroke=\"#e4e1d9\"");
        if ((decade - axes.error.lower) % every == 0)
            svg.text(x0 - 6, at + 4, power_of_ten(decade), "text-anchor=\"end\" fill=\"#5d6470\"");
    }
    for (int decade = axes.cost.lower; decade <= axes.cost.upper; ++decade)
        for (const int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10.0, decade);
            if (value > std::pow(10.0, axes.cost.upper) * 1.01) continue;
            const double at = axes.cost(value);
            svg.line(at, y0 + lane, at, y1 - lane, digit == 1 ? "stroke=\"#e4e1d9\"" : "stroke=\"#f1efe9\"");
            if (digit == 1 || axes.cost.upper - axes.cost.lower <= 3)
                svg.text(at, y0 + lane + 16, fmt::format("{:g}", value),
                         "text-anchor=\"middle\" fill=\"#5d6470\"");
        }
    svg.line(x0, y0 + lane, x1, y0 + lane, "stroke=\"#5d6470\"");
    svg.line(x0, y0 + lane, x0, y1 - lane, "stroke=\"#5d6470\"");
    svg.text((x0 + x1) / 2, y0 + lane + 34, panel.cost, "text-anchor=\"middle\" fill=\"#5d6470\"");
}

/// Dots of a lane would cover each other: they take turns at five heights.
double height_of(const Axes& axes, const Dot& dot, std::size_t n) {
    const double step = 5.0 * static_cast<double>(n % 5) - 10;
    if (!std::isfinite(dot.error)) return axes.error.to - lane / 2 + step;
    return dot.error > 0 ? axes.error(dot.error) : axes.error.from + lane / 2 + step;
}

void draw_dots(Svg& svg, const Axes& axes, const Panel& panel) {
    for (std::size_t n = 0; n < panel.dots.size(); ++n) {
        const Dot& dot = panel.dots[n];
        if (!std::isfinite(dot.cost)) continue;
        const double x = axes.cost(dot.cost), y = height_of(axes, dot, n);
        const std::string stroke = fmt::format("stroke=\"{}\"", colour(dot.style));
        svg.open_group(dot.title);
        if (dot.most > dot.least)
            svg.line(axes.cost(dot.least), y, axes.cost(dot.most), y, stroke + " opacity=\"0.5\"");
        svg.marker(dot.style, x, y, 4.5,
                   dot.hollow ? "fill=\"#fff\" " + stroke + " stroke-width=\"1.5\""
                              : fmt::format("fill=\"{}\"", colour(dot.style)));
        svg.close_group();
    }
}

} // namespace

std::string scatter_svg(const Scatter& scatter) {
    if (scatter.panels.empty()) return {};
    double entry = 60;
    for (const std::string& name : scatter.legend)
        entry = std::max(entry, 34 + 6.6 * static_cast<double>(name.size()));
    const auto per_line = static_cast<std::size_t>(std::max(1.0, (width - 2 * margin) / entry));
    const auto lines = static_cast<double>((scatter.legend.size() + per_line - 1) / per_line);
    const double notes = 16 * static_cast<double>(scatter.notes.size());
    const double head = margin + 26 + notes + 8 + row * lines + 10;
    Svg svg(width, head + panel_height + margin);
    svg.text(margin, margin + 8, scatter.title, "font-size=\"16\" font-weight=\"600\"");
    for (std::size_t i = 0; i < scatter.notes.size(); ++i)
        svg.text(margin, margin + 27 + 16 * static_cast<double>(i), scatter.notes[i], "fill=\"#5d6470\"");
    for (std::size_t i = 0; i < scatter.legend.size(); ++i) {
        const double x = margin + static_cast<double>(i % per_line) * entry;
        const double y = margin + 26 + notes + 14 + row * static_cast<double>(i / per_line);
        svg.marker(i, x + 6, y - 4, 4.5, fmt::format("fill=\"{}\"", colour(i)));
        svg.text(x + 17, y, scatter.legend[i], "font-size=\"12\"");
    }
    const auto count = static_cast<double>(scatter.panels.size());
    const double panel_width = (width - 2 * margin - (count - 1) * gap) / count;
    std::vector<double> errors;
    for (const Panel& panel : scatter.panels)
        for (const Dot& dot : panel.dots) errors.push_back(dot.error);
    for (std::size_t i = 0; i < scatter.panels.size(); ++i) {
        const Panel& panel = scatter.panels[i];
        std::vector<double> costs;
        for (const Dot& dot : panel.dots) costs.insert(costs.end(), {dot.cost, dot.least, dot.most});
        Axes axes{axis_around(costs, -3, 7), axis_around(errors, -12, 4)};
        axes.cost.from = margin + static_cast<double>(i) * (panel_width + gap) + left;
        axes.cost.to = axes.cost.from + panel_width - left - right;
        axes.error.from = head + panel_height - bottom - lane;
        axes.error.to = head + top + lane;
        draw_axes(svg, axes, panel);
        draw_dots(svg, axes, panel);
    }
    return svg.finish(scatter.title);
}

} // namespace gnomon::measure
