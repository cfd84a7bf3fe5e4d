#include "casegen/atlas/page_entry.h"

#include "casegen/atlas/html.h"
#include "casegen/atlas/listing.h"
#include "casegen/atlas/mathml.h"
#include "casegen/atlas/picture.h"
#include "casegen/mask_families.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace gnomon::atlas {
namespace {

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    return text;
}

/// Text with the minus sign that print has, in front of an axis.
std::string prose(const std::string& text) {
    std::string html;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '-' && i + 1 < text.size() && (text[i + 1] == 'x' || text[i + 1] == 'y'))
            html += "−";
        else
            html += escape_html(text.substr(i, 1));
    return html;
}

std::string percent(double share) { return fmt::format("{:.2f} %", 100 * share); }

/// Names the tested texel's sides on which something differs; the page marks these borders.
std::string side_classes(const Witness& witness) {
    const glm::uvec2 sides = reference::edge(witness.mask, witness.texel).sides;
    return fmt::format("{}{}{}{}", (sides.x & reference::minus) != 0 ? " left" : "",
                       (sides.x & reference::plus) != 0 ? " right" : "",
                       (sides.y & reference::minus) != 0 ? " up" : "",
                       (sides.y & reference::plus) != 0 ? " down" : "");
}

std::string figure(const std::string& what, const std::string& picture, const std::string& title,
                   const std::string& caption) {
    return fmt::format("<figure class=\"{}\">{}<figcaption><b>{}</b>{}</figcaption></figure>\n", what,
                       picture, title, caption);
}

std::string image_html(const Image& image, int scale, const std::string& alternative) {
    return fmt::format("<img src=\"{}\" width=\"{}\" height=\"{}\" alt=\"{}\">", data_uri(image),
                       image.width * scale, image.height * scale, escape_html(alternative));
}

std::string framed(const std::string& inside) { return "<div class=\"frame\">" + inside + "</div>"; }

std::string absent(const char* why) { return fmt::format("<div class=\"absent\">{}</div>", why); }

std::string difference_caption(const Case& c, const ValueMap& map) {
    const std::size_t all = map.got.size();
    std::string text = fmt::format(
        "largest {}; ", map.largest_difference == 0 ? "0" : fmt::format("{:.3g}", map.largest_difference));
    text += map.differ == 0 ? fmt::format("all {} points are equal", all)
                            : fmt::format("{} of {} points differ", map.differ, all);
    if (map.refused > 0) text += fmt::format(", {} beyond the tolerance", map.refused);
    return text + fmt::format("; full colour at {:.3g}", difference_scale(c));
}

std::string pictures(const Entry& entry) {
    const Case& c = *entry.kernel;
    if (!entry.witness)
        return "<p class=\"trouble\">No mask of up to 12 texels leads to this case, so it has no "
               "pictures.</p>\n";
    const Witness& witness = *entry.witness;
    const std::string words = witness_words(witness);
    std::string html = figure("witness", framed(witness_svg(witness, words)), "Witness", escape_html(words));
    if (entry.revectorized)
        html += figure(
            "after",
            framed(image_html(*entry.revectorized, 1, "the witness, revectorized") + grid_svg(witness)),
            "After the technique", "every texel by the assembled kernel");
    const std::string tile = "tile" + side_classes(witness);
    const ValueMap& map = *entry.values;
    constexpr int scale = 3;
    std::string points = fmt::format("{0} × {0} points of the outlined texel", map.side);
    if (const std::vector<std::string> set = untold(c, facts_of(witness)); !set.empty())
        points += fmt::format("; set, for the mask tells nothing: {}",
                              escape_html(fmt::format("{}", fmt::join(set, ", "))));
    if (map.got.empty()) {
        html += figure(tile, absent("the kernel did not run"), "Kernel", "");
    } else {
        html += figure(tile, framed(image_html(values_image(c, map, map.got), scale, "the kernel's values")),
                       "Kernel", points);
    }
    html += figure(tile, framed(image_html(values_image(c, map, map.want), scale, "the reference's values")),
                   "Reference", "C++ in double precision, same points");
    if (!map.got.empty())
        html += figure(
            tile,
            framed(image_html(difference_image(c, map), scale, "differences between kernel and reference")),
            "Difference", difference_caption(c, map));
    return "<div class=\"pictures\">\n" + html + "</div>\n";
}

std::string rules(const Case& c) {
    std::vector<std::string> items;
    for (const Condition& condition : c.condition) items.push_back(prose(in_words(condition)));
    std::string words = items.size() == 1
                            ? "<p>" + items.front() + "</p>"
                            : fmt::format("<ul><li>{}</li></ul>", fmt::join(items, ", or</li><li>"));
    std::string formula;
    try {
        formula = "<div class=\"scroll\">" + formula_to_mathml(c.formula) + "</div>";
    } catch (const Error& error) {
        formula = fmt::format("<p class=\"trouble\">{}</p>", escape_html(error.what()));
    }
    return fmt::format(
        "<div class=\"rules\">\n<div><h4>Applies to</h4>{}<div class=\"scroll condition\">{}</div></div>\n"
        "<div class=\"value\"><h4>Value</h4><p><code>{}</code></p>{}</div>\n</div>\n",
        words, condition_to_mathml(c.condition), escape_html(c.formula), formula);
}

/// "way", one small picture beside the other: for each way through the case its own witness.
std::string ways(const Entry& entry) {
    if (entry.ways.size() < 2) return {};
    std::string html = fmt::format(
        "<details><summary>{} ways through this case</summary>\n<div class=\"ways\">\n", entry.ways.size());
    for (const Way& way : entry.ways) {
        const std::string words = witness_words(way.witness);
        html += fmt::format("<figure><div class=\"pair\">{}", witness_svg(way.witness, words, way_pixels));
        if (way.revectorized) html += image_html(*way.revectorized, 1, "this witness, revectorized");
        html += fmt::format("</div><figcaption>{}</figcaption></figure>\n", escape_html(way.facts));
    }
    return html + "</div></details>\n";
}

std::string share_row(const std::string& where, double share, const PageContext& context,
                      const std::string& more) {
    return fmt::format("<div><dt>{}</dt><dd class=\"share\"><span class=\"meter\"><i "
                       "style=\"width:{:.1f}%\"></i></span>{} {}</dd></div>\n",
                       where, 100 * std::min(1.0, share / context.widest_share), percent(share), more);
}

std::string facts(const Entry& entry, const PageContext& context) {
    const Case& c = *entry.kernel;
    std::string html = share_row("Share of edge texels, masks", entry.share.overall, context,
                                 fmt::format("<span class=\"soft\">(mean over masks {} ± {})</span>",
                                             percent(entry.share.mean), percent(entry.share.deviation)));
    for (const Census& census : context.atlas.censuses) {
        const std::string family = c.name.substr(0, c.name.rfind('/'));
        const auto numbers = census.shares.find(family);
        if (numbers == census.shares.end()) continue;
        if (const auto share = numbers->second.find(c.number); share != numbers->second.end())
            html += share_row("Share, " + escape_html(census.where), share->second, context, "");
    }
    const auto fact = [&](const char* name, const std::string& value) {
        html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, value);
    };
    fact("Worst error", worst_error(entry.report));
    fact("Allowed", escape_html(to_string(c.tolerance)));
    fact("Samples", fmt::format("{}", entry.report.samples));
    fact("ns per evaluation", nanoseconds_html(entry.report));
    if (entry.coverage) fact("Reached", reached_in_words(*entry.coverage));
    return "<dl class=\"facts\">\n" + html + "</dl>\n";
}

std::string kernel_text(const Entry& entry, const PageContext& context) {
    const Case& c = *entry.kernel;
    const std::string path = "kernels/" + c.name + ".glsl";
    std::string html =
        fmt::format("<details class=\"kernel\"><summary>{}, signature and columns{}</summary>\n",
                    escape_html(path), entry.coverage ? ", and what was reached of it" : "");
    html += fmt::format("<p><code>{}</code></p>\n", escape_html(signature(c)));
    html += fmt::format("<p>CSV columns: <code>{}</code></p>\n", fmt::join(columns(c), ","));
    html +=
        "<div class=\"wide\"><table><thead><tr><th>Parameter</th><th>Range</th><th>Unit</th><th>Meaning</th>"
        "</tr></thead><tbody>\n";
    for (const Parameter& p : c.parameters)
        html += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                            escape_html(p.name), to_string(p.domain), escape_html(p.unit),
                            escape_html(p.meaning));
    html +=
        fmt::format("<tr><td>result</td><td>{:g} to {:g}</td><td>{}</td><td>{}</td></tr>\n", c.result.lower,
                    c.result.upper, escape_html(c.result.unit), escape_html(c.result.meaning));
    html += "</tbody></table></div>\n";
    if (!context.kernels.empty())
        html += fmt::format("<p><a href=\"{}/{}.glsl\">{}</a></p>\n", escape_html(context.kernels),
                            escape_html(c.name), escape_html(path));
    return html +
           (entry.coverage ? listing_html(*entry.coverage)
                           : fmt::format("<pre><code>{}</code></pre>", glsl_to_html(entry.text))) +
           "</details>\n";
}

std::string shares_by_family(const Entry& entry) {
    std::string rows;
    for (std::size_t i = 0; i < entry.share.by_family.size(); ++i)
        rows +=
            fmt::format("<tr><td>{}</td><td class=\"number\">{}</td><td>{}</td></tr>\n",
                        mask_families()[i].name, percent(entry.share.by_family[i]), mask_families()[i].what);
    return "<details><summary>share in each family of masks</summary>\n<div class=\"wide\"><table><tbody>\n" +
           rows + "</tbody></table></div></details>\n";
}

} // namespace

std::string element_id(const std::string& name) {
    std::string id = name;
    std::ranges::replace(id, '/', '-');
    return id;
}

std::string verdict_html(const CheckReport& report) {
    const bool pass = is_good(report.verdict);
    return fmt::format("<span class=\"verdict {}\">{}</span>", pass ? "pass" : "fail",
                       escape_html(to_string(report.verdict)));
}

std::string failure_html(const CheckReport& report, const std::string& replay) {
    if (is_good(report.verdict)) return {};
    return fmt::format("<p class=\"trouble call\">{}</p>\n",
                       escape_html(fmt::format("{}", fmt::join(explain_failure(report, replay), "\n"))));
}

std::string worst_error(const CheckReport& report) {
    return report.worst ? format_error(report.worst->error) : "–";
}

std::string nanoseconds_html(const CheckReport& report) {
    return fmt::format("<span class=\"time\">{}</span>",
                       report.worst ? fmt::format("{:.1f}", report.nanoseconds) : "–");
}

std::string kind_of(const Entry& entry) {
    if (!entry.values) return {};
    const std::vector<double>& want = entry.values->want;
    const Result& result = entry.kernel->result;
    const auto extreme = [&](double v) { return v == result.lower || v == result.upper || std::isnan(v); };
    const auto first = [&](double v) { return v == want.front(); };
    return std::ranges::all_of(want, first)     ? "constant"
           : std::ranges::all_of(want, extreme) ? "step"
                                                : "ramp";
}

std::string light_of(const Case& c) {
    const auto asks_for = [&](unsigned light) {
        return std::ranges::all_of(c.condition,
                                   [&](const Condition& condition) { return condition.light == light; });
    };
    return asks_for(sets::lit) ? "lit" : asks_for(sets::shadowed) ? "shadowed" : "both";
}

std::string entry_html(const Entry& entry, const PageContext& context) {
    const Case& c = *entry.kernel;
    const std::string family = c.name.substr(0, c.name.rfind('/'));
    const std::string text = lower_case(
        fmt::format("{} {} {} {} {}", c.name, c.source, in_words(c.condition), c.formula, entry.comment));
    std::string html =
        fmt::format("<article class=\"case\" id=\"{}\" data-family=\"{}\" data-light=\"{}\" data-kind=\"{}\" "
                    "data-verdict=\"{}\" data-text=\"{}\">\n",
                    element_id(c.name), escape_html(family), light_of(c), kind_of(entry),
                    is_good(entry.report.verdict) ? "pass" : "fail", escape_html(text));
    html += fmt::format(
        "<header><h3><a href=\"#{}\">{}</a></h3><span class=\"source\">{}</span>{}</header>\n",
        element_id(c.name), escape_html(c.name), escape_html(c.source), verdict_html(entry.report));
    if (!entry.comment.empty()) html += fmt::format("<p class=\"comment\">{}</p>\n", prose(entry.comment));
    html += failure_html(entry.report, context.replay);
    if (!entry.trouble.empty())
        html += fmt::format("<p class=\"trouble\">{}</p>\n", escape_html(entry.trouble));
    html += rules(c) + pictures(entry) + facts(entry, context) + ways(entry) + kernel_text(entry, context) +
            shares_by_family(entry);
    return html + "</article>\n";
}

} // namespace gnomon::atlas
