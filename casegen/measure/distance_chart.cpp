#include "casegen/measure/charts.h"
#include "casegen/measure/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gnomon::measure {
namespace {

constexpr double chart_width = 372, chart_height = 270, gap = 16, margin = 20;
constexpr double left = 40, right = 8, top = 24, bottom = 30; // within a chart
constexpr double lane = 11;                                   // above the axis: results that are not finite
constexpr std::size_t columns = 3;
constexpr int lowest = -9, highest = 2; // of what is worth telling apart

/// Position of a step: 1e-1 at the left, 1e-12, a gap, and "on it".
double x_of(int step, double x) {
    const double inner = chart_width - left - right - 8, part = inner / 12.6;
    return x + left + 4 + (step == 0 ? inner : (step - 1) * part);
}

std::vector<double> all_errors(const GroupResult& result) {
    std::vector<double> values;
    for (const Accuracy& accuracy : result.accuracy)
        for (const LocusSummary& locus : accuracy.loci)
            for (const Step& step : locus.steps)
                for (const double value :
                     {step.summary.of_scale.median, step.summary.of_scale.most, std::min(step.limit, 1.0)})
                    values.push_back(value);
    return values;
}

void draw_axes(Svg& svg, double x, double y, const LogAxis& axis, const std::string& name) {
    const double x0 = x + left, x1 = x + chart_width - right;
    svg.text(x0, y + 9, name, "font-weight=\"600\" font-size=\"12\"");
    for (int decade = axis.lower; decade <= axis.upper; ++decade) {
        const double at = axis(std::pow(10.0, decade));
        const bool labelled = (decade - axis.lower) % 3 == 0;
        svg.line(x0, at, x1, at, labelled ? "stroke=\"#d5d2c8\"" : "stroke=\"#eeece6\"");
        if (labelled) svg.text(x0 - 5, at + 4, power_of_ten(decade), "text-anchor=\"end\" fill=\"#5d6470\"");
    }
    for (int nth = 1; nth <= locus_distances; ++nth) {
        const int step = nth % locus_distances;
        const bool labelled = step == 0 || step % 3 == 1;
        const double at = x_of(step, x);
        svg.line(at, axis.from, at, axis.from + (labelled ? 5 : 3), "stroke=\"#5d6470\"");
        if (labelled)
            svg.text(at, axis.from + 17, step == 0 ? "on" : power_of_ten(-step),
                     "text-anchor=\"middle\" fill=\"#5d6470\"");
    }
    svg.line(x0, axis.from, x1, axis.from, "stroke=\"#5d6470\"");
    svg.rectangle(x0, axis.to - lane, x1 - x0, lane, "fill=\"#f6e3df\"");
}

/// A line, broken where a value is not finite and before "on it", which lies at no distance.
void draw_line(Svg& svg, const std::vector<Step>& steps, double x, const LogAxis& axis,
               const std::string& style, auto&& value_of) {
    std::vector<std::pair<double, double>> points;
    for (const Step& step : steps) {
        const double value = value_of(step);
        if (step.step == 0 || !std::isfinite(value)) {
            svg.polyline(points, style);
            points.clear();
        }
        if (std::isfinite(value)) points.emplace_back(x_of(step.step, x), axis(value));
    }
    if (points.size() == 1) points.emplace_back(points.front().first + 2, points.front().second);
    svg.polyline(points, style);
}

void draw_variant(Svg& svg, const LocusSummary& locus, std::size_t n, double x, const LogAxis& axis) {
    const auto median = [](const Step& step) { return step.summary.of_scale.median; };
    const auto most = [](const Step& step) { return step.summary.of_scale.most; };
    draw_line(svg, locus.steps, x, axis, line_style(n) + " stroke-width=\"0.6\" opacity=\"0.6\"", most);
    draw_line(svg, locus.steps, x, axis, line_style(n) + " stroke-width=\"1.9\"", median);
    for (const Step& step : locus.steps)
        if (step.step == 0 && std::isfinite(median(step)))
            svg.marker(n, x_of(0, x), axis(median(step)), 3, fmt::format("fill=\"{}\"", colour(n)));
}

/// Marks of those whose results are not all finite at some step, side by side, so that none hides another.
void draw_non_finite(Svg& svg, const GroupResult& result, std::size_t l, double x, const LogAxis& axis) {
    std::map<int, std::vector<std::size_t>> marked;
    for (std::size_t n = 0; n < result.group.variants.size(); ++n)
        for (const Step& step : result.accuracy[n].loci[l].steps)
            if (step.summary.of_scale.non_finite > 0) marked[step.step].push_back(n);
    for (const auto& [step, variants] : marked)
        for (std::size_t i = 0; i < variants.size(); ++i) {
            const std::size_t n = variants[i];
            const std::vector<Step>& steps = result.accuracy[n].loci[l].steps;
            const auto at = std::ranges::find(steps, step, &Step::step);
            const bool most = !std::isfinite(at->summary.of_scale.median);
            const double spread = std::min(8.0, 18.0 / static_cast<double>(variants.size()));
            const double beside =
                (static_cast<double>(i) - 0.5 * static_cast<double>(variants.size() - 1)) * spread;
            svg.marker(n, x_of(step, x) + beside, axis.to - lane / 2, 2.8,
                       most ? fmt::format("fill=\"{}\"", colour(n))
                            : fmt::format("fill=\"#fff\" stroke=\"{}\"", colour(n)));
        }
}

} // namespace

std::string line_style(std::size_t n) {
    return fmt::format("stroke=\"{}\"{}", colour(n),
                       n < 9    ? ""
                       : n < 18 ? " stroke-dasharray=\"5 2\""
                                : " stroke-dasharray=\"1.5 2\"");
}

std::string distance_chart(const GroupResult& result) {
    const std::size_t loci = result.accuracy.front().loci.size();
    if (loci == 0) return {};
    const std::size_t across = std::min(columns, loci), rows = (loci + across - 1) / across;
    const std::size_t variants = result.group.variants.size();
    const double width =
        std::max(2 * margin + static_cast<double>(across) * (chart_width + gap) - gap, 640.0);

    // The legend: as many entries in a line as fit.
    double entry = 0;
    for (const Variant& variant : result.group.variants)
        entry = std::max(entry, 44 + 6.4 * static_cast<double>(variant.label.size()));
    const auto per_line = static_cast<std::size_t>(std::max(1.0, (width - 2 * margin) / entry));
    const double legend_height = 18 * static_cast<double>((variants + per_line - 1) / per_line);
    const double head = margin + 62 + legend_height;
    Svg svg(width, head + static_cast<double>(rows) * (chart_height + gap) + 24);
    const std::string title = result.group.name + ": error against distance";
    svg.text(margin, margin + 8, title, "font-size=\"16\" font-weight=\"600\"");
    svg.text(margin, margin + 27,
             fmt::format("Up: error{}. Right: ever closer to where the formula loses digits, at last on it.",
                         result.has_limit ? " as a fraction of the scale ∫|f|" : ", " + result.unit),
             "fill=\"#5d6470\"");
    svg.text(margin, margin + 43,
             "Bold: median; thin: largest; grey: κu, what rounding the inputs does. Red lane: some (hollow) "
             "or most "
             "(full) results are NaN or infinite. What lies beyond an edge is drawn on it.",
             "fill=\"#5d6470\"");
    for (std::size_t n = 0; n < variants; ++n) {
        const double x = margin + static_cast<double>(n % per_line) * entry;
        const double y = margin + 62 + 18 * static_cast<double>(n / per_line);
        svg.line(x, y - 4, x + 24, y - 4, line_style(n) + " stroke-width=\"2\"");
        svg.marker(n, x + 12, y - 4, 3, fmt::format("fill=\"{}\"", colour(n)));
        svg.text(x + 30, y, result.group.variants[n].label, "font-size=\"12\"");
    }

    LogAxis axis = axis_around(all_errors(result), lowest, highest);
    for (std::size_t l = 0; l < loci; ++l) {
        const double x = margin + static_cast<double>(l % across) * (chart_width + gap);
        const double y = head + static_cast<double>(l / across) * (chart_height + gap);
        axis.from = y + chart_height - bottom;
        axis.to = y + top + lane;
        const LocusSummary& locus = result.accuracy.front().loci[l];
        svg.open_group(fmt::format("{} ({})", locus.name, locus.group));
        draw_axes(svg, x, y, axis, locus.name);
        if (result.has_limit)
            draw_line(svg, locus.steps, x, axis, "stroke=\"#9a9a94\" stroke-width=\"3.2\"",
                      [](const Step& step) { return step.limit; });
        for (std::size_t n = 0; n < variants; ++n) draw_variant(svg, result.accuracy[n].loci[l], n, x, axis);
        draw_non_finite(svg, result, l, x, axis);
        if (locus.steps.empty())
            svg.text(x + left + 10, y + chart_height / 2, "no input of its domain lies here",
                     "fill=\"#5d6470\"");
        svg.close_group();
    }
    return svg.finish(title);
}

} // namespace gnomon::measure
