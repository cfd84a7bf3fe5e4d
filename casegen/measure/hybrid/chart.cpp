#include "casegen/measure/hybrid/report.h"
#include "casegen/measure/pareto.h"
#include "casegen/measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gnomon::measure {
namespace {

constexpr double panel_width = 340, panel_height = 260, gap = 26, margin = 20;
constexpr double left = 46, right = 12, top = 26, bottom = 42;
constexpr double row_height = 18; // of the legend
constexpr double noise = 0.05;    // of times on a machine that is not idle

/// What a row of panels has upwards.
struct Quantity {
    const char* title;
    double (*of)(const HybridRow&);
};
constexpr Quantity quantities[] = {
    {"pixels that need a ray", [](const HybridRow& row) { return row.uncertain_share(); }},
    {"wrong pixels", [](const HybridRow& row) { return row.wrong_share(); }},
};

using Viewport = std::vector<const HybridCombination*>;

/// In the order they were measured in.
std::vector<Viewport> viewports_of(const HybridBench& bench) {
    std::vector<Viewport> result;
    for (const HybridCombination& c : bench.combinations) {
        const auto known = std::ranges::find_if(result, [&](const Viewport& v) {
            return v.front()->width == c.width && v.front()->height == c.height;
        });
        (known == result.end() ? result.emplace_back() : *known).push_back(&c);
    }
    return result;
}

void draw_axes(Svg& svg, const LogAxis& time, const LogAxis& up, const std::string& title) {
    svg.text(time.from, up.to - 10, title, "font-weight=\"600\" font-size=\"13\"");
    for (int decade = up.lower; decade <= up.upper; ++decade) {
        const double at = up(std::pow(10.0, decade));
        svg.line(time.from, at, time.to, at, "stroke=\"#e4e1d9\"");
        svg.text(time.from - 6, at + 4, decade == up.lower ? "0" : power_of_ten(decade),
                 "text-anchor=\"end\" fill=\"#5d6470\"");
    }
    for (int decade = time.lower; decade <= time.upper; ++decade)
        for (const int digit : {1, 2, 5}) {
            const double value = digit * std::pow(10.0, decade);
            if (value > std::pow(10.0, time.upper) * 1.01) continue;
            const double at = time(value);
            svg.line(at, up.from, at, up.to, digit == 1 ? "stroke=\"#e4e1d9\"" : "stroke=\"#f1efe9\"");
            svg.text(at, up.from + 16, fmt::format("{:g}", value), "text-anchor=\"middle\" fill=\"#5d6470\"");
        }
    svg.line(time.from, up.from, time.to, up.from, "stroke=\"#5d6470\"");
    svg.line(time.from, up.from, time.from, up.to, "stroke=\"#5d6470\"");
    svg.text((time.from + time.to) / 2, up.from + 33, "time of a frame, raytraced = 1",
             "text-anchor=\"middle\" fill=\"#5d6470\"");
}

double time_of(const HybridCombination& c, const HybridRow& row) {
    return row.times.milliseconds / c.rows.front().times.milliseconds;
}

void draw_panel(Svg& svg, const Viewport& viewport, const Quantity& quantity, const LogAxis& time,
                const LogAxis& up) {
    // All maps of a viewport compete: who is dominated by whom.
    std::vector<Point> points;
    for (const HybridCombination* c : viewport)
        for (const HybridRow& row : c->rows) points.push_back({time_of(*c, row), quantity.of(row)});
    const std::vector<std::optional<std::size_t>> by = dominated_by(points, noise);
    std::map<std::string, std::pair<std::size_t, std::vector<std::pair<double, double>>>> lines;
    for (const HybridCombination* c : viewport)
        for (std::size_t n = 0; n < c->rows.size(); ++n) {
            auto& line = lines[c->rows[n].technique];
            line.first = n;
            line.second.emplace_back(time(time_of(*c, c->rows[n])), up(quantity.of(c->rows[n])));
        }
    for (const auto& [name, line] : lines)
        svg.polyline(line.second, fmt::format("stroke=\"{}\" opacity=\"0.5\"", colour(line.first)));
    std::size_t i = 0;
    for (const HybridCombination* c : viewport)
        for (std::size_t n = 0; n < c->rows.size(); ++n, ++i) {
            const HybridRow& row = c->rows[n];
            svg.open_group(
                fmt::format("{}, shadow map {}: {:.2f} of raytraced, {:.3f} % of pixels need a ray, {} "
                            "pixels wrong{}",
                            row.technique, c->shadow_map, points[i].time, 100 * row.uncertain_share(),
                            row.wrong, by[i] ? ", dominated" : ""));
            svg.marker(n, time(points[i].time), up(points[i].error), 5,
                       by[i] ? fmt::format("fill=\"#fff\" stroke=\"{}\" stroke-width=\"1.5\"", colour(n))
                             : fmt::format("fill=\"{}\"", colour(n)));
            svg.close_group();
        }
}

} // namespace

std::string hybrid_chart(const HybridBench& bench) {
    const std::vector<Viewport> viewports = viewports_of(bench);
    std::vector<double> times;
    for (const HybridCombination& c : bench.combinations)
        for (const HybridRow& row : c.rows) times.push_back(time_of(c, row));
    std::vector<std::string> legend;
    for (const HybridCombination& c : bench.combinations)
        for (const HybridRow& row : c.rows)
            if (std::ranges::find(legend, row.technique) == legend.end()) legend.push_back(row.technique);
    const auto columns = static_cast<double>(std::max<std::size_t>(viewports.size(), 1));
    const double width = 2 * margin + columns * panel_width + (columns - 1) * gap;
    constexpr double entry = 130;
    const auto per_line = static_cast<std::size_t>(std::max(1.0, (width - 2 * margin) / entry));
    const double head =
        margin + 66 + row_height * static_cast<double>((legend.size() + per_line - 1) / per_line);
    Svg svg(width, head + static_cast<double>(std::size(quantities)) * (panel_height + gap) + margin);
    const std::string title = bench.scene + ": time against rays and errors";
    svg.text(margin, margin + 8, title, "font-size=\"16\" font-weight=\"600\"");
    svg.text(margin, margin + 27, "Lines join a technique's shadow maps.", "fill=\"#5d6470\"");
    svg.text(margin, margin + 43, "Hollow: another is faster and no worse, or no slower and better.",
             "fill=\"#5d6470\"");
    for (std::size_t n = 0; n < legend.size(); ++n) {
        const double x = margin + static_cast<double>(n % per_line) * entry;
        const double y = margin + 66 + row_height * static_cast<double>(n / per_line);
        svg.marker(n, x + 6, y - 4, 4.5, fmt::format("fill=\"{}\"", colour(n)));
        svg.text(x + 17, y, legend[n], "font-size=\"12\"");
    }
    double y = head;
    for (const Quantity& quantity : quantities) {
        std::vector<double> values{1}; // shares: up to all of them
        for (const HybridCombination& c : bench.combinations)
            for (const HybridRow& row : c.rows) values.push_back(quantity.of(row));
        LogAxis time = axis_around(times, -3, 4), up = axis_around(values, -7, 0);
        --up.lower; // room for 0
        for (std::size_t i = 0; i < viewports.size(); ++i) {
            const double x = margin + static_cast<double>(i) * (panel_width + gap);
            time.from = x + left;
            time.to = x + panel_width - right;
            up.from = y + panel_height - bottom;
            up.to = y + top;
            draw_axes(svg, time, up,
                      fmt::format("{}, {} x {}", quantity.title, viewports[i].front()->width,
                                  viewports[i].front()->height));
            draw_panel(svg, viewports[i], quantity, time, up);
        }
        y += panel_height + gap;
    }
    return svg.finish(title);
}

} // namespace gnomon::measure
