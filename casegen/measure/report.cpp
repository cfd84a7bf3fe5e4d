#include "casegen/measure/report.h"

#include "casegen/atlas/html.h"
#include "casegen/measure/charts.h"
#include "casegen/measure/page.h"
#include "casegen/measure/tables.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>

namespace gnomon::measure {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json json_of(const Quantiles& q) {
    return {{"median", number(q.median)},
            {"p90", number(q.p90)},
            {"p99", number(q.p99)},
            {"max", number(q.most)},
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
        if (has_limit) json["limit"] = number(step.limit);
        steps.push_back(std::move(json));
    }
    Json json{{"locus", locus.name}, {"class", locus.group}};
    json.update(json_of(locus.all, has_limit));
    json["distances"] = std::move(steps);
    return json;
}

Json json_of_variant(const GroupResult& result, std::size_t n) {
    const Variant& variant = result.group.variants[n];
    const Accuracy& accuracy = result.accuracy[n];
    Json json{{"kernel", variant.kernel->name},
              {"trigonometry", to_string(variant.trigonometry)},
              {"label", variant.label},
              {"all", json_of(accuracy.all, result.has_limit)}};
    Json classes = Json::object(), loci = Json::array();
    for (std::size_t i = 0; i < result.classes.size(); ++i)
        classes[result.classes[i]] = json_of(accuracy.classes[i], result.has_limit);
    for (const LocusSummary& locus : accuracy.loci) loci.push_back(json_of(locus, result.has_limit));
    json["classes"] = std::move(classes);
    json["loci"] = std::move(loci);
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
    json["nanoseconds"] = std::move(times);
    json["dominated_by"] = std::move(dominated);
    return json;
}

std::string details(const Table& table) {
    return table.rows.empty() ? ""
                              : fmt::format("<details><summary>{}</summary>\n{}</details>\n",
                                            atlas::escape_html(table.title), to_html(table));
}

/// With a picture only if there is something to compare.
std::string pareto_of(const GroupResult& result) {
    return result.group.variants.size() > 1 ? pareto_chart(result) : "";
}

} // namespace

std::string bench_json(const Bench& bench) {
    Json groups = Json::array();
    for (const GroupResult& result : bench.groups) {
        Json classes = Json::object(), timing = Json::object(), variants = Json::array();
        for (std::size_t i = 0; i < result.classes.size(); ++i)
            classes[result.classes[i]] = result.class_counts[i];
        for (const Timings& t : result.timings)
            timing[t.inputs] = {{"reading", t.floor}, {"against_itself", t.again}, {"noise", t.noise()}};
        for (std::size_t n = 0; n < result.group.variants.size(); ++n)
            variants.push_back(json_of_variant(result, n));
        groups.push_back({{"quantity", result.group.name},
                          {"error_unit", result.unit},
                          {"seed", fmt::format("{:#018x}", result.seed)},
                          {"inputs", result.inputs},
                          {"outside_the_domain", result.left_out},
                          {"classes", std::move(classes)},
                          {"timing", std::move(timing)},
                          {"variants", std::move(variants)}});
    }
    return Json{{"gnomon", GNOMON_VERSION},
                {"machine", bench.machine},
                {"rounds", bench.options.rounds},
                {"groups", std::move(groups)}}
               .dump(2, ' ', false, Json::error_handler_t::replace) +
           "\n";
}

std::string bench_page(const Bench& bench) {
    std::string body = "<h1>Error and time of kernels</h1>\n";
    for (const std::string& remark : remarks(bench))
        body += fmt::format("<p class=\"soft\">{}</p>\n", atlas::escape_html(remark));
    std::vector<const GroupResult*> lone;
    for (const GroupResult& result : bench.groups) {
        const bool shown = result.group.variants.size() > 1 || bench.groups.size() == 1 ||
                           !result.accuracy.front().loci.empty();
        if (!shown) {
            lone.push_back(&result);
            continue;
        }
        const Table table = overall_table(result);
        body += fmt::format("<h2>{}</h2>\n{}", atlas::escape_html(table.title), to_html(table));
        body += figure(pareto_of(result)) + figure(distance_chart(result));
        if (result.classes.size() > 1) body += details(class_table(result)) + details(locus_table(result));
    }
    if (!lone.empty()) {
        const Table table = lone_table(lone);
        body += fmt::format("<h2>{}</h2>\n{}", table.title, to_html(table));
    }
    return html_page("gnomon bench", body);
}

void require_report_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    require_writable(folder / "report.html");
}

void write_report(const fs::path& folder, const Bench& bench) {
    for (const GroupResult& result : bench.groups) {
        std::string name = result.group.name;
        std::ranges::replace(name, '/', '_');
        if (const std::string svg = distance_chart(result); !svg.empty())
            write_file(folder / (name + "_distance.svg"), svg);
        if (const std::string svg = pareto_of(result); !svg.empty())
            write_file(folder / (name + "_pareto.svg"), svg);
    }
    write_file(folder / "bench.json", bench_json(bench));
    write_file(folder / "report.html", bench_page(bench));
}

} // namespace gnomon::measure
