#include "casegen/measure/overview.h"

#include "casegen/measure/scatter.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace gnomon::measure {
namespace {

std::string family_of(const std::string& kernel) { return kernel.substr(0, kernel.find('/')); }

/// Who dominates variant n by the 99 % error; by instructions where there are no times.
std::vector<std::optional<std::size_t>> dominated_in(const GroupResult& result, bool by_time) {
    constexpr std::size_t by_p99 = 1;
    if (by_time) return result.dominated[by_p99];
    std::vector<Point> points;
    for (std::size_t n = 0; n < result.group.variants.size(); ++n)
        points.push_back({static_cast<double>(result.instructions[n]),
                          error_at(result.accuracy[n].all.of_scale, Rank::p99)});
    return dominated_by(points, 0);
}

template <typename Visit>
void each_variant(const Bench& bench, Visit&& visit) {
    for (const GroupResult& result : bench.groups)
        for (std::size_t n = 0; n < result.group.variants.size(); ++n) visit(result, n);
}

Panel panel_of(const Bench& bench, const std::vector<std::string>& legend, bool by_time) {
    Panel panel;
    panel.title = "99 % error, each in its unit";
    panel.cost = by_time ? "ns per evaluation" : "instructions";
    for (const GroupResult& result : bench.groups) {
        const std::vector<std::optional<std::size_t>> by = dominated_in(result, by_time);
        for (std::size_t n = 0; n < result.group.variants.size(); ++n) {
            const Variant& variant = result.group.variants[n];
            Dot dot;
            dot.error = error_at(result.accuracy[n].all.of_scale, Rank::p99);
            dot.style = static_cast<std::size_t>(std::ranges::find(legend, family_of(variant.kernel->name)) -
                                                 legend.begin());
            dot.hollow = by[n].has_value();
            std::string cost = fmt::format("{} instructions", result.instructions[n]);
            dot.cost = static_cast<double>(result.instructions[n]);
            if (by_time) {
                const Timings& timings = result.timings.back();
                dot.cost = std::max(timings.variants[n].median, timings.least_time());
                cost = fmt::format("{:.1f} ns", timings.variants[n].median);
            }
            dot.title = fmt::format("{}: {}, 99 % error {:.2g} {}{}", full_name(variant), cost, dot.error,
                                    result.unit,
                                    by[n] ? ", dominated by " + result.group.variants[*by[n]].label : "");
            panel.dots.push_back(std::move(dot));
        }
    }
    return panel;
}

} // namespace

std::string overview_chart(const Bench& bench) {
    Scatter scatter;
    scatter.title = "Every kernel and variant: cost against error";
    bool timed = !bench.groups.empty();
    each_variant(bench, [&](const GroupResult& result, std::size_t n) {
        const std::string family = family_of(result.group.variants[n].kernel->name);
        if (std::ranges::find(scatter.legend, family) == scatter.legend.end())
            scatter.legend.push_back(family);
        timed = timed && !result.timings.empty();
    });
    if (scatter.legend.empty()) return {};
    scatter.notes = {"Hollow: another variant of the same quantity is cheaper and no less accurate, or no "
                     "dearer and more accurate. Rest the pointer on a mark for its name."};
    if (timed) scatter.panels.push_back(panel_of(bench, scatter.legend, true));
    scatter.panels.push_back(panel_of(bench, scatter.legend, false));
    return scatter_svg(scatter);
}

Table overview_table(const Bench& bench) {
    Table table;
    table.title = "Every kernel and variant";
    table.header = {"kernel", "quantity", "inputs", "error is",  "median",
                    "99 %",   "max",      "max/κu", "not finite"};
    const bool timed =
        std::ranges::any_of(bench.groups, [](const GroupResult& r) { return !r.timings.empty(); });
    if (timed)
        for (const char* name : {"ns", "least", "most", "over yardstick"}) table.header.emplace_back(name);
    table.header.emplace_back("instructions");
    table.header.emplace_back("dominated by");
    each_variant(bench, [&](const GroupResult& result, std::size_t n) {
        const Variant& variant = result.group.variants[n];
        const Summary& all = result.accuracy[n].all;
        std::vector<std::string> row{full_name(variant),
                                     result.group.variants.size() > 1 ? result.group.name : "",
                                     std::to_string(result.inputs), result.unit};
        for (const Rank rank : ranks) row.push_back(error_cell(error_at(all.of_scale, rank)));
        row.push_back(result.has_limit ? ratio_cell(all.of_limit.most) : "-");
        row.push_back(std::to_string(all.of_scale.non_finite));
        if (timed && result.timings.empty()) row.insert(row.end(), 4, "-");
        if (!result.timings.empty()) {
            const Timings& timings = result.timings.back();
            const Timing& time = timings.variants[n];
            for (const double value : {time.median, time.least, time.most})
                row.push_back(time_cell(value, timings));
            row.push_back(ratio_cell(time.over_yardstick.median));
        }
        row.push_back(std::to_string(result.instructions[n]));
        const auto by = dominated_in(result, !result.timings.empty())[n];
        row.push_back(by ? result.group.variants[*by].label : "");
        table.rows.push_back(std::move(row));
    });
    return table;
}

std::vector<std::string> failures(const Bench& bench) {
    std::vector<std::string> lines;
    each_variant(bench, [&](const GroupResult& result, std::size_t n) {
        if (result.beyond_tolerance[n] == 0) return;
        lines.push_back(fmt::format("WRONG: {} is beyond its tolerance on {} of {} inputs; gnomon check {} "
                                    "tells more",
                                    full_name(result.group.variants[n]), result.beyond_tolerance[n],
                                    result.inputs, result.group.variants[n].kernel->name));
    });
    return lines;
}

} // namespace gnomon::measure
