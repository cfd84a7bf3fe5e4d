#include "casegen/measure/frames/section.h"

#include "casegen/atlas/html.h"
#include "casegen/measure/json_reading.h"
#include "casegen/measure/page.h"
#include "casegen/measure/scatter.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace gnomon::measure {
namespace {

using Json = nlohmann::ordered_json;
using atlas::escape_html;

bool is_timed(const SceneResult& result) {
    return !result.rows.empty() && !result.rows.front().times.rounds.empty();
}

Panel panel_of(const SceneResult& result, const char* title, double (*error)(const FrameRow&)) {
    Panel panel;
    panel.title = title;
    panel.cost = "ms from the shadow map to the last pixel";
    for (std::size_t n = 0; n < result.rows.size(); ++n) {
        const FrameRow& row = result.rows[n];
        Dot dot;
        dot.cost = row.times.milliseconds;
        dot.least = row.times.least;
        dot.most = row.times.most;
        dot.error = error(row);
        dot.style = n;
        dot.hollow = row.dominated_by.has_value();
        dot.title =
            fmt::format("{}: {:.2f} ms, {} of {} pixels wrong, RMSE {:.4f}{}", row.technique, dot.cost,
                        row.counts.wrong_lit + row.counts.wrong_shadowed, row.counts.facing, row.rmse,
                        row.dominated_by ? ", dominated by " + result.rows[*row.dominated_by].technique : "");
        panel.dots.push_back(std::move(dot));
    }
    return panel;
}

std::string picture(const Image& image, const std::string& alt) {
    return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">", atlas::data_uri(image),
                       image.width, image.height, escape_html(alt));
}

std::string pictures_of(const SceneResult& result) {
    std::string html =
        "<p class=\"soft\">Left what was rendered; right what of it is wrong: red lit where truth is shadow, "
        "blue shadowed where truth is lit, light grey lit and dark grey shadowed as truth has it, slate "
        "faces away. Techniques whose pictures are the same share one.</p>\n<div class=\"pictures\">\n";
    std::vector<bool> shown(result.rows.size(), false);
    std::vector<std::size_t> order; // truth first: what the others are held against
    for (const bool of_truth : {true, false})
        for (std::size_t n = 0; n < result.rows.size(); ++n)
            if ((result.rows[n].image.pixels == result.truth.pixels) == of_truth) order.push_back(n);
    for (const std::size_t n : order) {
        if (shown[n]) continue;
        const FrameRow& row = result.rows[n];
        std::vector<std::string> names;
        for (std::size_t k = 0; k < result.rows.size(); ++k) {
            const FrameRow& other = result.rows[k];
            if (shown[k] || other.image.pixels != row.image.pixels ||
                other.errors.pixels != row.errors.pixels)
                continue;
            shown[k] = true;
            names.push_back(other.technique);
        }
        const std::string who = fmt::format("{}", fmt::join(names, ", "));
        const bool is_truth = row.image.pixels == result.truth.pixels;
        html += fmt::format(
            "<figure class=\"pair\"><figcaption><strong>{}</strong>: {}</figcaption>{}{}</figure>\n",
            escape_html(who),
            is_truth ? "the ray tracer's picture"
                     : fmt::format("{:.3f} % of {} pixels wrong, RMSE {:.4f}", 100 * row.counts.wrong_share(),
                                   row.counts.facing, row.rmse),
            picture(row.image, fmt::format("{} rendered by {}", result.view.scene, who)),
            picture(row.errors, fmt::format("What is wrong in it: {} lit where truth is shadow, {} shadowed "
                                            "where truth is lit",
                                            row.counts.wrong_lit, row.counts.wrong_shadowed)));
    }
    return html + "</div>\n";
}

} // namespace

std::string frames_chart(const SceneResult& result) {
    if (!is_timed(result)) return {};
    Scatter scatter;
    scatter.title = result.view.scene + ": time of a frame against error";
    scatter.notes = {fmt::format("{} pixels face the light. Bars: fastest to slowest of {} frames.",
                                 result.rows.front().counts.facing, result.rows.front().times.rounds.size()),
                     fmt::format("Hollow: another technique is faster beyond the noise ({:.0f} %) and has no "
                                 "more pixels wrong, or is no slower and has fewer.",
                                 100 * result.noise)};
    for (const FrameRow& row : result.rows) scatter.legend.push_back(row.technique);
    scatter.panels.push_back(panel_of(result, "wrong pixels, of those that face the light",
                                      [](const FrameRow& row) { return row.counts.wrong_share(); }));
    scatter.panels.push_back(
        panel_of(result, "RMSE of the visibility", [](const FrameRow& row) { return row.rmse; }));
    return scatter_svg(scatter);
}

Table frames_table(const SceneResult& result) {
    Table table;
    table.title = "Techniques on " + result.view.scene;
    const ViewSettings& settings = result.view.settings;
    table.notes.push_back(fmt::format("{}x{} pixels, {} triangles, shadow map {}; {} pixels face the light",
                                      settings.width, settings.height, result.triangles, settings.shadow_map,
                                      result.rows.empty() ? 0 : result.rows.front().counts.facing));
    table.header = {"technique", "wrongly lit", "wrongly shadowed", "wrong %", "RMSE"};
    const bool timed = is_timed(result);
    const std::string ratio = "over " + result.yardstick;
    if (timed)
        for (const std::string& name : {std::string("ms"), std::string("least"), std::string("most"), ratio})
            table.header.push_back(name);
    table.header.emplace_back("rays");
    if (timed) table.header.emplace_back("dominated by");
    for (const FrameRow& row : result.rows) {
        std::vector<std::string> cells{
            row.technique, std::to_string(row.counts.wrong_lit), std::to_string(row.counts.wrong_shadowed),
            fmt::format("{:.3f}", 100 * row.counts.wrong_share()), fmt::format("{:.4f}", row.rmse)};
        if (timed) {
            for (const double value : {row.times.milliseconds, row.times.least, row.times.most})
                cells.push_back(fmt::format("{:.2f}", value));
            cells.push_back(ratio_cell(row.over_yardstick.median));
        }
        cells.push_back(row.rays > 0 ? std::to_string(row.rays) : "-");
        if (timed) cells.push_back(row.dominated_by ? result.rows[*row.dominated_by].technique : "");
        table.rows.push_back(std::move(cells));
    }
    return table;
}

std::string frames_section(const SceneResult& result) {
    return figure(frames_chart(result)) + to_sortable_html(frames_table(result)) + pictures_of(result);
}

Json frames_json(const SceneResult& result) {
    Json techniques = Json::array();
    for (const FrameRow& row : result.rows) {
        Json json{{"technique", row.technique},
                  {"exact", row.exact},
                  {"wrong_lit", row.counts.wrong_lit},
                  {"wrong_shadowed", row.counts.wrong_shadowed},
                  {"wrong_share_of_facing", row.counts.wrong_share()},
                  {"differing_bits", row.differing},
                  {"rmse", row.rmse},
                  {"rays", row.rays}};
        if (!row.times.rounds.empty()) {
            json["milliseconds"] = {
                {"median", row.times.milliseconds}, {"least", row.times.least}, {"most", row.times.most}};
            json["over_" + result.yardstick] = {{"median", number_or_null(row.over_yardstick.median)},
                                                {"lower", number_or_null(row.over_yardstick.interval.lower)},
                                                {"upper", number_or_null(row.over_yardstick.interval.upper)}};
            json["dominated_by"] =
                row.dominated_by ? Json(result.rows[*row.dominated_by].technique) : Json(nullptr);
        }
        techniques.push_back(std::move(json));
    }
    const ViewSettings& settings = result.view.settings;
    return {{"scene", result.view.scene},
            {"triangles", result.triangles},
            {"size", {settings.width, settings.height}},
            {"shadow_map", settings.shadow_map},
            {"facing_light", result.rows.empty() ? 0 : result.rows.front().counts.facing},
            {"noise", result.noise},
            {"techniques", std::move(techniques)}};
}

} // namespace gnomon::measure
