#include "casegen/measure/charts.h"
#include "casegen/measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::measure {
namespace {

constexpr double panel_width = 350, panel_height = 300, gap = 26, margin = 20;
constexpr double left = 46, right = 10, top = 26, bottom = 42;
constexpr double lane = 14; // above the axis: errors that are not finite
constexpr double row = 18;  // of the legend

struct Axes {
    LogAxis time, error;
};

void draw_axes(Svg& svg, double x, double y, const Axes& axes, Rank rank) {
    const double x0 = axes.time.from, x1 = axes.time.to, y0 = axes.error.from, y1 = axes.error.to;
    svg.text(x + left, y + 12, fmt::format("{} error", to_string(rank)),
             "font-weight=\"600\" font-size=\"13\"");
    const int every = axes.error.upper - axes.error.lower > 8 ? 2 : 1;
    for (int decade = axes.error.lower; decade <= axes.error.upper; ++decade) {
        const double at = axes.error(std::pow(10.0, decade));
        svg.line(x0, at, x1, at, "stroke=\"#e4e1d9\"");
        if ((decade - axes.error.lower) % every == 0)
            svg.text(x0 - 6, at + 4, power_of_ten(decade), "text-anchor=\"end\" fill=\"#5d6470\"");
    }
    // Times span a decade or two: mark 1, 2 and 5 of each.
    for (int decade = axes.time.lower; decade <= axes.time.upper; ++decade)
        for (const int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10.0, decade);
            if (value > std::pow(10.0, axes.time.upper) * 1.01) continue;
            const double at = axes.time(value);
            svg.line(at, y0, at, y1, digit == 1 ? "stroke=\"#e4e1d9\"" : "stroke=\"#f1efe9\"");
            if (digit == 1 || axes.time.upper - axes.time.lower <= 3)
                svg.text(at, y0 + 16, fmt::format("{:g}", value), "text-anchor=\"middle\" fill=\"#5d6470\"");
        }
    svg.line(x0, y0, x1, y0, "stroke=\"#5d6470\"");
    svg.line(x0, y0, x0, y1, "stroke=\"#5d6470\"");
    svg.rectangle(x0, y1 - lane, x1 - x0, lane, "fill=\"#f6e3df\"");
    svg.text(x1 - 4, y1 - 4, "not finite", "text-anchor=\"end\" font-size=\"10\" fill=\"#8a5248\"");
    svg.text((x0 + x1) / 2, y0 + 33, "ns per evaluation", "text-anchor=\"middle\" fill=\"#5d6470\"");
}

} // namespace

std::string pareto_chart(const GroupResult& result) {
    if (result.timings.empty()) return {};
    const Timings& timings = result.timings.back();
    const std::size_t variants = result.group.variants.size();
    std::vector<double> times, errors;
    for (std::size_t n = 0; n < variants; ++n) {
        for (const double value :
             {timings.variants[n].least, timings.variants[n].median, timings.variants[n].most})
            times.push_back(std::max(value, timings.least_time()));
        for (const Rank rank : ranks) errors.push_back(error_at(result.accuracy[n].all.of_scale, rank));
    }
    double entry = 0;
    for (const Variant& variant : result.group.variants)
        entry = std::max(entry, 34 + 6.4 * static_cast<double>(variant.label.size()));
    const double width = 2 * margin + 3 * panel_width + 2 * gap;
    const auto per_line = static_cast<std::size_t>(std::max(1.0, (width - 2 * margin) / entry));
    const double legend = row * static_cast<double>((variants + per_line - 1) / per_line);
    const double head = margin + 66 + legend;
    Svg svg(width, head + panel_height + margin);
    const std::string title = result.group.name + ": time against error";
    svg.text(margin, margin + 8, title, "font-size=\"16\" font-weight=\"600\"");
    svg.text(
        margin, margin + 27,
        fmt::format(
            "Up: error {}, over {} inputs (\"{}\"); what lies beyond an edge is drawn on it. Right: time; "
            "bars: fastest to slowest round.",
            result.has_limit ? "as a fraction of the scale ∫|f|" : "in " + result.unit, result.inputs,
            timings.inputs),
        "fill=\"#5d6470\"");
    svg.text(
        margin, margin + 43,
        fmt::format(
            "Hollow: dominated by a variant that is faster beyond the noise ({:.0f} %), or no slower, and "
            "no less accurate.",
            100 * timings.noise()),
        "fill=\"#5d6470\"");
    for (std::size_t n = 0; n < variants; ++n) {
        const double x = margin + static_cast<double>(n % per_line) * entry;
        const double y = margin + 66 + row * static_cast<double>(n / per_line);
        svg.marker(n, x + 6, y - 4, 4.5, fmt::format("fill=\"{}\"", colour(n)));
        svg.text(x + 17, y, result.group.variants[n].label, "font-size=\"12\"");
    }

    Axes axes{axis_around(times, -2, 6), axis_around(errors, -12, 2)};
    for (std::size_t r = 0; r < ranks.size(); ++r) {
        const double x = margin + static_cast<double>(r) * (panel_width + gap), y = head;
        axes.time.from = x + left;
        axes.time.to = x + panel_width - right;
        axes.error.from = y + panel_height - bottom;
        axes.error.to = y + top + lane;
        draw_axes(svg, x, y, axes, ranks[r]);
        for (std::size_t n = 0; n < variants; ++n) {
            const double error = error_at(result.accuracy[n].all.of_scale, ranks[r]);
            const Timing& time = timings.variants[n];
            const double px = axes.time(std::max(time.median, timings.least_time()));
            const double py = std::isfinite(error) ? axes.error(error) : axes.error.to - lane / 2;
            const auto& by = result.dominated[r][n];
            const std::string stroke = fmt::format("stroke=\"{}\"", colour(n));
            svg.open_group(fmt::format("{}: {:.1f} ns, {} error {:.2g}{}", result.group.variants[n].label,
                                       time.median, to_string(ranks[r]), error,
                                       by ? ", dominated by " + result.group.variants[*by].label : ""));
            svg.line(axes.time(std::max(time.least, timings.least_time())), py, axes.time(time.most), py,
                     stroke + " opacity=\"0.6\"");
            svg.marker(n, px, py, 5,
                       by ? "fill=\"#fff\" " + stroke + " stroke-width=\"1.5\""
                          : fmt::format("fill=\"{}\"", colour(n)));
            svg.close_group();
        }
    }
    return svg.finish(title);
}

} // namespace gnomon::measure
