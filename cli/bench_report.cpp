#include "cli/bench_report.h"

#include "casegen/measure/frames/section.h"
#include "casegen/measure/overview.h"
#include "casegen/measure/tables.h"
#include "cli/junit.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>

namespace gnomon::cli {
namespace {

/// Of one kernel or technique: the lines that tell what became worse.
void add_moves(JunitCase& one, const measure::Report& report, const std::string& name) {
    if (!report.moved) return;
    for (const measure::Move& move : report.moved->moves) {
        if (move.name != name || !measure::is_bad(move.change)) continue;
        if (one.failure.empty()) one.failure = move.change == measure::Change::slower ? "slower" : "worse";
        one.text += fmt::format("{} than in {}: {}\n", to_string(move.change), report.baseline, move.what);
    }
}

} // namespace

std::string bench_text(const measure::Report& report, bool by_class) {
    std::string text;
    if (report.moved) {
        text = measure::to_text(*report.moved, report.baseline);
    } else {
        text = measure::to_text(report.bench, by_class);
        for (const measure::SceneResult& scene : report.scenes)
            text += fmt::format("\n{}", measure::to_text(measure::frames_table(scene)));
    }
    for (const std::string& line : measure::all_failures(report)) text += line + "\n";
    return text;
}

std::string bench_junit(const measure::Report& report) {
    std::vector<JunitCase> cases;
    for (const measure::GroupResult& result : report.bench.groups)
        for (std::size_t n = 0; n < result.group.variants.size(); ++n) {
            const measure::Variant& variant = result.group.variants[n];
            JunitCase one;
            one.name = measure::full_name(variant);
            one.group = one.name.substr(0, one.name.find('/'));
            if (!result.timings.empty())
                one.seconds =
                    result.timings.back().variants[n].median * static_cast<double>(result.inputs) * 1e-9;
            if (result.beyond_tolerance[n] > 0) {
                one.failure = "beyond tolerance";
                one.text = fmt::format("on {} of {} inputs; gnomon check {} tells more\n",
                                       result.beyond_tolerance[n], result.inputs, variant.kernel->name);
            }
            add_moves(one, report, one.name);
            cases.push_back(std::move(one));
        }
    for (const measure::SceneResult& scene : report.scenes)
        for (const measure::FrameRow& row : scene.rows) {
            JunitCase one;
            one.group = "techniques";
            one.name = fmt::format("{}: {}", scene.view.scene, row.technique);
            one.seconds = row.times.milliseconds * 1e-3;
            if (row.exact && row.differing > 0) {
                one.failure = "broken promise";
                one.text = fmt::format("{} pixels are not the ray tracer's\n", row.differing);
            }
            add_moves(one, report, one.name);
            cases.push_back(std::move(one));
        }
    return junit_xml("gnomon bench", cases);
}

bool is_bad(const measure::Report& report) {
    const bool moved =
        report.moved && std::ranges::any_of(report.moved->moves, [](const measure::Move& move) {
            return measure::is_bad(move.change);
        });
    return moved || !measure::all_failures(report).empty();
}

} // namespace gnomon::cli
