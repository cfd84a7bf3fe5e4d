#include "casegen/measure/report.h"

#include "casegen/atlas/html.h"
#include "casegen/measure/charts.h"
#include "casegen/measure/frames/section.h"
#include "casegen/measure/json_reading.h"
#include "casegen/measure/overview.h"
#include "casegen/measure/page.h"
#include "casegen/measure/tables.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace gnomon::measure {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using atlas::escape_html;

Json json_of(const Quantiles& q) {
    return {{"median", number_or_null(q.median)},
            {"p90", number_or_null(q.p90)},
            {"p99", number_or_null(q.p99)},
            {"max", number_or_null(q.most)},
            {"not_finite", q.non_finite_share()}};
}

Json json_of(const Summary& s, bool has_limit) {
    Json json{{"inputs", s.of_scale.count}, {"error", json_of(s.of_scale)}};
    if (has_limit) json["error_over_limit"] = json_of(s.of_limit);
    return json;
}

Json json_of(const LocusSummary& locus, bool has_limit) {
    Json steps = Json::array();
    for (const Step& step : locus.steps) {
        Json json{{"distance", locus_distance(step.step)}};
        json.update(json_of(step.summary, has_limit));
        if (has_limit) json["limit"] = number_or_null(step.limit);
        steps.push_back(std::move(json));
    }
    Json json{{"locus", locus.name}, {"class", locus.group}};
    json.update(json_of(locus.all, has_limit));
    json["distances"] = std::move(steps);
    return json;
}

Json json_of_variant(const GroupResult& result, std::size_t n, bool with_details) {
    const Variant& variant = result.group.variants[n];
    const Accuracy& accuracy = result.accuracy[n];
    Json json{{"kernel", variant.kernel->name},
              {"trigonometry", to_string(variant.trigonometry)},
              {"label", variant.label},
              {"all", json_of(accuracy.all, result.has_limit)},
              {"beyond_tolerance", result.beyond_tolerance[n]},
              {"instructions", result.instructions[n]}};
    Json classes = Json::object(), loci = Json::array();
    for (std::size_t i = 0; i < result.classes.size(); ++i)
        classes[result.classes[i]] = json_of(accuracy.classes[i], result.has_limit);
    for (const LocusSummary& locus : accuracy.loci) loci.push_back(json_of(locus, result.has_limit));
    if (with_details) {
        json["classes"] = std::move(classes);
        json["loci"] = std::move(loci);
    }
    if (result.timings.empty()) return json;
    Json times = Json::object(), dominated = Json::object();
    for (const Timings& t : result.timings)
        times[t.inputs] = {
            {"median", t.variants[n].median}, {"least", t.variants[n].least}, {"most", t.variants[n].most}};
    constexpr std::array names{"median", "p99", "max"};
    for (std::size_t r = 0; r < ranks.size(); ++r)
        dominated[names[r]] = result.dominated[r][n]
                                  ? Json(result.group.variants[*result.dominated[r][n]].label)
                                  : Json(nullptr);
    const Ratio& ratio = result.timings.back().variants[n].over_yardstick;
    json["nanoseconds"] = std::move(times);
    json["over_yardstick"] = {{"median", number_or_null(ratio.median)},
                              {"lower", number_or_null(ratio.interval.lower)},
                              {"upper", number_or_null(ratio.interval.upper)}};
    json["dominated_by"] = std::move(dominated);
    return json;
}

std::string details(const Table& table) {
    return table.rows.empty() ? ""
                              : fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                                            escape_html(table.title), to_html(table));
}

/// A page's sections, and a line of links to them.
struct Page {
    std::string body, links{}, sections{};
    void add(const std::string& id, const std::string& title, const std::string& html) {
        links += fmt::format("<a href=\"#{}\">{}</a> ", id, escape_html(title));
        sections +=
            fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n{}</section>\n", id, escape_html(title), html);
    }
    std::string text() const {
        return fmt::format("{}<nav aria-label=\"Sections\">{}</nav>\n<main>\n{}</main>\n", body, links,
                           sections);
    }
};

std::string moved_section(const Report& report) {
    Table table{"What moved", report.moved->notes, {"change", "what", "how"}, {}};
    for (const Move& move : report.moved->moves)
        table.rows.push_back({to_string(move.change), move.name, move.what});
    table.notes.push_back(fmt::format("{} kernels and {} techniques against {}", report.moved->kernels,
                                      report.moved->techniques, report.baseline));
    if (!table.rows.empty()) return to_html(table);
    std::string html = "<p class=\"good\">Nothing moved.</p>\n";
    for (const std::string& note : table.notes)
        html += fmt::format("<p class=\"soft\">{}</p>\n", escape_html(note));
    return html;
}

/// With a picture only if there is something to compare.
std::string pareto_of(const GroupResult& result) {
    return result.group.variants.size() > 1 ? pareto_chart(result) : "";
}

/// A quantity with variants, or with loci: there is more to see than a row of the table of all kernels.
bool has_pictures(const GroupResult& result) {
    return result.group.variants.size() > 1 || !result.accuracy.front().loci.empty();
}

std::string quantities_section(const Bench& bench) {
    std::string html;
    constexpr std::size_t few = 3; // are shown at once
    for (const GroupResult& result : bench.groups) {
        if (!has_pictures(result) && bench.groups.size() > 1) continue;
        html += fmt::format("<details{}><summary>{}: {} variant{}</summary>\n{}{}{}",
                            bench.groups.size() <= few ? " open" : "", escape_html(result.group.name),
                            result.group.variants.size(), result.group.variants.size() > 1 ? "s" : "",
                            to_html(overall_table(result)), figure(pareto_of(result)),
                            figure(distance_chart(result)));
        if (result.classes.size() > 1) html += details(class_table(result)) + details(locus_table(result));
        html += "</details>\n";
    }
    return html.empty() ? "<p class=\"soft\">None of these kernels has variants or loci.</p>\n" : html;
}

std::string how_section(const Report& report) {
    std::vector<std::string> lines = remarks(report.bench);
    lines.push_back(fmt::format(
        "Instructions: in the shader that calls the kernel once per input, as SPIRV-Tools optimises it. They "
        "have no noise. Inputs: {} ordinary ones a quantity{}; seed {}.",
        report.bench.options.samples,
        report.bench.options.repeats > 0
            ? fmt::format(", and {} near every locus at every distance", report.bench.options.repeats)
            : "",
        report.bench.options.seed ? fmt::format("{:#018x}", *report.bench.options.seed)
                                  : "each quantity's own, its name's hash"));
    if (report.bench.options.rounds > 0)
        lines.emplace_back(
            "Over yardstick: time, with the reading of its inputs, over that of a piece of work "
            "that never changes, in the same rounds.");
    if (!report.scenes.empty())
        lines.emplace_back(
            "Techniques: all over one G-buffer and one shadow map, fitted to what is seen; in turns, there "
            "and "
            "back; on the wall, from the shadow map to the last pixel's visibility, without G-buffer and "
            "shading. Wrong: lit where Embree's ray says shadow, or the other way round; visibility below a "
            "half is shadow. RMSE: of the visibility itself, so that soft edges count.");
    std::string html;
    for (const std::string& line : lines)
        html += fmt::format("<p class=\"soft\">{}</p>\n", escape_html(line));
    return html;
}

} // namespace

std::string bench_json(const Report& report, bool with_details) {
    const Bench& bench = report.bench;
    Json groups = Json::array();
    for (const GroupResult& result : bench.groups) {
        Json classes = Json::object(), timing = Json::object(), variants = Json::array();
        for (std::size_t i = 0; i < result.classes.size(); ++i)
            classes[result.classes[i]] = result.class_counts[i];
        for (const Timings& t : result.timings)
            timing[t.inputs] = {{"reading", t.floor},
                                {"yardstick", t.yardstick},
                                {"against_itself", t.again},
                                {"noise", t.noise()}};
        for (std::size_t n = 0; n < result.group.variants.size(); ++n)
            variants.push_back(json_of_variant(result, n, with_details));
        groups.push_back({{"quantity", result.group.name},
                          {"error_unit", result.unit},
                          {"seed", fmt::format("{:#018x}", result.seed)},
                          {"inputs", result.inputs},
                          {"outside_the_domain", result.left_out},
                          {"classes", std::move(classes)},
                          {"timing", std::move(timing)},
                          {"variants", std::move(variants)}});
    }
    Json json{{"gnomon", GNOMON_VERSION},   {"machine", bench.machine},       {"driver", bench.driver},
              {"compiler", bench.compiler}, {"rounds", bench.options.rounds}, {"groups", std::move(groups)},
              {"scenes", Json::array()},    {"wrong", all_failures(report)}};
    for (const SceneResult& scene : report.scenes) json["scenes"].push_back(frames_json(scene));
    if (report.moved) {
        Json moves = Json::array();
        for (const Move& move : report.moved->moves)
            moves.push_back({{"change", to_string(move.change)}, {"name", move.name}, {"what", move.what}});
        json["against"] = {
            {"baseline", report.baseline}, {"notes", report.moved->notes}, {"moved", std::move(moves)}};
    }
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::vector<std::string> all_failures(const Report& report) {
    std::vector<std::string> lines = failures(report.bench);
    for (const SceneResult& scene : report.scenes)
        for (std::string& line : broken_promises(scene)) lines.push_back(std::move(line));
    return lines;
}

std::string bench_page(const Report& report) {
    const Bench& bench = report.bench;
    Page page;
    page.body = fmt::format("<h1>Error against cost</h1>\n<p class=\"soft\">{}; {}; {}; gnomon {}</p>\n",
                            escape_html(bench.machine), escape_html(bench.driver),
                            escape_html(bench.compiler), GNOMON_VERSION);
    for (const std::string& line : all_failures(report))
        page.body += fmt::format("<p class=\"bad\">{}</p>\n", escape_html(line));
    if (report.moved) page.add("moved", "What moved", moved_section(report));
    if (!bench.groups.empty())
        page.add("kernels", "Kernels",
                 figure(overview_chart(bench)) + to_sortable_html(overview_table(bench)));
    for (std::size_t i = 0; i < report.scenes.size(); ++i)
        page.add(fmt::format("scene-{}", i + 1), "Techniques on " + report.scenes[i].view.scene,
                 frames_section(report.scenes[i]));
    if (!bench.groups.empty()) page.add("quantities", "Quantities", quantities_section(bench));
    if (!report.mutation.empty()) page.add("mutation", "Mutation", report.mutation);
    if (!report.coverage.empty()) page.add("coverage", "Coverage", report.coverage);
    page.add("how", "How it was measured", how_section(report));
    return html_page("gnomon bench", page.text());
}

void require_report_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    require_writable(folder / "report.html");
}

void write_report(const fs::path& folder, const Report& report) {
    for (const GroupResult& result : report.bench.groups) {
        std::string name = result.group.name;
        std::ranges::replace(name, '/', '_');
        if (const std::string svg = distance_chart(result); !svg.empty())
            write_file(folder / (name + "_distance.svg"), svg);
        if (const std::string svg = pareto_of(result); !svg.empty())
            write_file(folder / (name + "_pareto.svg"), svg);
    }
    write_file(folder / "bench.json", bench_json(report));
    write_file(folder / "report.html", bench_page(report));
}

} // namespace gnomon::measure
