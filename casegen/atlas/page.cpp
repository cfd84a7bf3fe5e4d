#include "casegen/atlas/page.h"

#include "casegen/atlas/html.h"
#include "casegen/atlas/mathml.h"
#include "casegen/atlas/page_assets.h"
#include "casegen/atlas/page_entry.h"
#include "casegen/mask_families.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace gnomon::atlas {
namespace {

// The hatch over what surrounds a mask. Defined once; every picture uses it.
constexpr const char* hatch =
    R"svg(<svg width="0" height="0" style="position:absolute" aria-hidden="true"><defs>
<pattern id="hatch" width="8" height="8" patternUnits="userSpaceOnUse" patternTransform="rotate(45)">
<rect width="8" height="8" fill="#fff" fill-opacity=".34"/><path d="M0 0V8" stroke="#8a8f99" stroke-width="2.4" stroke-opacity=".7"/>
</pattern></defs></svg>
)svg";

std::string head() {
    std::string html =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>gnomon: atlas of cases</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n";
    return html + page_style + "</style>\n</head>\n<body>\n" + hatch;
}

std::string introduction(const Atlas& atlas) {
    std::size_t cases = 0, failed = 0;
    for (const FamilyEntries& family : atlas.families)
        for (const Entry& entry : family.cases) {
            ++cases;
            if (!is_good(entry.report.verdict)) ++failed;
        }
    std::string html = fmt::format(
        "<h1>Atlas of cases</h1>\n<p class=\"lead\">Every case of every decision list in gnomon’s catalogue: "
        "the "
        "smallest shadow mask that leads to it and shows something, what it computes there as run on the "
        "device, and how that "
        "differs "
        "from the C++ reference. {} cases, {}.</p>\n",
        cases, failed == 0 ? "all of which pass" : fmt::format("<b>{} of which fail</b>", failed));
    html += "<dl class=\"run\">\n";
    const auto row = [&](const char* name, const std::string& value) {
        html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, escape_html(value));
    };
    row("gnomon", GNOMON_VERSION);
    row("Device", atlas.device);
    row("Samples per kernel", atlas.samples ? fmt::format("{}", *atlas.samples)
                                            : "65536; 8192 where the reference is multiprecision");
    row("Seed", atlas.own_seeds ? "of each kernel, its name’s hash" : fmt::format("{:#x}", atlas.masks_seed));
    row("Masks",
        fmt::format("{}, with {} edge texels; seed {:#x}", atlas.masks, atlas.edge_texels, atlas.masks_seed));
    if (atlas.coverage)
        row("Reached, of all kernels’ texts",
            fmt::format("{} of {} lines, {} of {} branches", atlas.coverage->lines.all,
                        atlas.coverage->lines.of, atlas.coverage->branches.all, atlas.coverage->branches.of));
    return html + "</dl>\n";
}

std::string contents(const Atlas& atlas) {
    std::string html = "<nav aria-label=\"Cases by family\">\n";
    for (const FamilyEntries& family : atlas.families) {
        html += fmt::format("<section><a href=\"#{}\">{}</a><ol>", element_id(family.family->name),
                            escape_html(family.family->name));
        for (const Entry& entry : family.cases)
            html += fmt::format("<li><a href=\"#{}\" title=\"{}\"{}>{}</a></li>",
                                element_id(entry.kernel->name), escape_html(entry.kernel->name),
                                is_good(entry.report.verdict) ? "" : " class=\"fail\"", entry.kernel->number);
        if (family.cases.empty())
            html += fmt::format("<li class=\"soft\">{} kernels without numbers</li>", family.kernels.size());
        html += "</ol></section>\n";
    }
    return html + "</nav>\n";
}

std::string select(const char* name, const char* all,
                   const std::vector<std::pair<std::string, std::string>>& values) {
    std::string html =
        fmt::format("<select name=\"{0}\" aria-label=\"{0}\"><option value=\"\">{1}</option>", name, all);
    for (const auto& [value, words] : values)
        html += fmt::format("<option value=\"{}\">{}</option>", escape_html(value), escape_html(words));
    return html + "</select>\n";
}

/// Hidden until the script that serves it runs.
std::string filters(const Atlas& atlas) {
    std::vector<std::pair<std::string, std::string>> families;
    for (const FamilyEntries& family : atlas.families)
        if (!family.cases.empty()) families.emplace_back(family.family->name, family.family->name);
    std::string html = "<form id=\"filters\" role=\"search\" hidden>\n<input type=\"search\" name=\"search\" "
                       "placeholder=\"Search names, sources, words, formulas\" aria-label=\"Search\" "
                       "autocomplete=\"off\">\n";
    html += select("family", "all families", families);
    html += select(
        "light", "all texels",
        {{"lit", "lit (entering shadow)"}, {"shadowed", "shadowed (exiting shadow)"}, {"both", "either"}});
    html += select("kind", "all kinds", {{"constant", "constant"}, {"step", "step"}, {"ramp", "ramp"}});
    html += select("verdict", "all verdicts", {{"pass", "pass"}, {"fail", "fail"}});
    return html + "<output></output>\n</form>\n";
}

/// What the formulas' names mean; those that occur.
std::string names_of_formulas(const Atlas& atlas) {
    struct Meaning {
        std::vector<const char*> names; ///< any of them calls for the line
        const char* words;
    };
    static const std::vector<Meaning> meanings{
        {{"p.x", "p.y"}, "position within the texel, growing with x and y: 0 to 1"},
        {{"q_x", "q_y"}, "distance from the side that differs along x, along y, in texels"},
        {{"along_x", "along_y"}, "position along the run in x, in y: 1 at its end, 0 at its beginning"},
        {{"d_c.b"}, "0 where the discontinuity enters shadow (the texel is lit), 1 where it exits"},
        {{"entering"}, "the texel is lit"},
        {{"n"}, "sides across the slot or bar of the next texel, away from its closed end"},
        {{"n_-x", "n_+x", "n_-y", "n_+y"}, "the same of the next texel that way"},
        {{"d_cb"}, "sides left where the slot or bar first loses a wall"},
        {{"w", "w_-x", "w_+x", "w_-y", "w_+y"}, "distance from the wall that this next texel still has"},
        {{"w_cb"}, "distance from the wall that is left there"},
        {{"NEITHER", "MINUS", "PLUS", "BOTH"}, "sides: none, −, +, both"},
        {{"UNBROKEN"}, "no wall is lost within 16 texels"},
        {{"E_x", "E_y"}, "light beside the x side, beside the y side, each as if alone, entering"},
        {{"X_x", "X_y"}, "the same, exiting"},
    };
    std::set<std::string> used;
    for (const FamilyEntries& family : atlas.families)
        for (const Entry& entry : family.cases) try {
                used.merge(names_in(entry.kernel->formula));
            } catch (const Error&) {
                continue; // its entry says so
            }
    std::string html;
    for (const Meaning& meaning : meanings) {
        std::vector<std::string> symbols;
        for (const char* name : meaning.names)
            if (used.contains(name)) symbols.push_back(fmt::format("<math>{}</math>", name_to_mathml(name)));
        if (!symbols.empty())
            html += fmt::format("<dt>{}</dt><dd>{}</dd>\n", fmt::join(symbols, ", "), meaning.words);
    }
    return html;
}

std::string legend(const Atlas& atlas, double widest_share) {
    const auto swatch = [](const Rgb& c) {
        return fmt::format("<span class=\"swatch\" style=\"background:rgb({},{},{})\"></span>", c.r, c.g,
                           c.b);
    };
    std::string html =
        "<section aria-label=\"How to read\">\n<h2>How to read it</h2>\n<div class=\"legend\">\n";
    html += "<svg class=\"axes\" width=\"120\" height=\"120\" viewBox=\"0 0 120 120\" role=\"img\"><title>x "
            "grows to "
            "the right, y downwards</title><path class=\"axis\" d=\"M14 14H100M94 9L102 14L94 19M14 14V100M9 "
            "94L14 "
            "102L19 94\"/><text x=\"108\" y=\"18\">x</text><text x=\"10\" y=\"117\">y</text></svg>\n<dl>\n";
    html += "<dt>Axes</dt><dd>x grows to the right, y <b>downwards</b>: row 0 is on top, towards −y.</dd>\n";
    html += fmt::format(
        "<dt>Witness</dt><dd>{} lit, {} shadow. Hatched: one ring of what surrounds the mask (lit, "
        "shadow, or the nearest texel: clamp). Outlined: the tested texel; an arrow leads over each "
        "side on which its neighbour’s shadow test differs (the discontinuity d<sub>c</sub>).</dd>\n",
        swatch(light_colour), swatch(shadow_colour));
    html +=
        "<dt>Kernel, reference</dt><dd>the outlined texel alone, at 64 × 64 points, from shadow’s colour "
        "(least) to light’s (greatest); coloured borders are the sides that differ. Values are clamped to "
        "their range; formulas do not repeat that.</dd>\n";
    html +=
        "<dt>Difference</dt><dd>pale: equal. Amber: within the tolerance, the stronger the larger. Red: "
        "beyond it. Full colour is at the tolerance, or at 1 where the tolerance is one of the input.</dd>\n";
    html += fmt::format(
        "<dt>Share</dt><dd>of the edge texels, lit and shadowed, of a corpus of masks ({} families of "
        "shapes); a full bar is {:.0f} %. Beside it mean and standard deviation over the masks.</dd>\n",
        mask_families().size(), 100 * widest_share);
    html += "<dt><math><msub><mi>s</mi><mi>c</mi></msub></math></dt><dd>the texel’s shadow test: 1 lit, 0 "
            "shadowed</dd>\n";
    html += fmt::format(
        "<dt><math>{}</math></dt><dd>sides that differ along x: 0 none, 0.25 +x, 0.5 −x, 0.75 both"
        "</dd>\n<dt><math>{}</math></dt><dd>along y: 0 none, 0.25 −y, 0.5 +y, 0.75 both</dd>\n",
        name_to_mathml("side_x"), name_to_mathml("side_y"));
    html += "<dt><math><msub><mi>t</mi><mi>h</mi></msub></math>, "
            "<math><msub><mi>t</mi><mi>v</mi></msub></math></dt>"
            "<dd>the run along x, along y: −1 open, 0 ends once, 1 ends both ways</dd>\n"
            "<dt><math><msub><mi>D</mi><mi>r</mi></msub></math>, "
            "<math><msub><mi>D</mi><mi>g</mi></msub></math></dt>"
            "<dd>1 if the x side’s, the y side’s edge goes on beyond the corner</dd>\n";
    if (atlas.coverage)
        html +=
            "<dt>Reached</dt><dd>how often a line of the kernel’s file was run, and how often each condition "
            "on it was true and false, over the inputs of all kernels that include the file: fixtures "
            "(regressions, worst inputs, pins, hostile and stiff values) and random samples.</dd>\n";
    html += names_of_formulas(atlas);
    return html + "</dl>\n</div>\n</section>\n";
}

std::string others(const FamilyEntries& family, const std::string& replay) {
    if (family.kernels.empty()) return {};
    std::string html =
        "<div "
        "class=\"wide\"><table><thead><tr><th>Kernel</th><th>Source</th><th>Signature</th><th>Verdict</th>"
        "<th class=\"number\">Worst error</th><th class=\"number\">ns</th></tr></thead><tbody>\n";
    std::string failures;
    for (const CheckReport& report : family.kernels) {
        const Case& c = *report.kernel;
        html += fmt::format(
            "<tr id=\"{}\"><td><code>{}</code></td><td>{}</td><td><code>{}</code></td><td>{}</td>"
            "<td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
            element_id(c.name), escape_html(c.name), escape_html(c.source), escape_html(signature(c)),
            verdict_html(report), worst_error(report), nanoseconds_html(report));
        failures += failure_html(report, replay);
    }
    return html + "</tbody></table></div>\n" + failures;
}

/// What fills a bar: the largest share of all, rounded up to whole steps of 5 %.
double widest_share(const Atlas& atlas) {
    double widest = 0;
    for (const FamilyEntries& family : atlas.families)
        for (const Entry& entry : family.cases) widest = std::max(widest, entry.share.overall);
    for (const Census& census : atlas.censuses)
        for (const auto& [family, numbers] : census.shares)
            for (const auto& [number, share] : numbers) widest = std::max(widest, share);
    return std::max(1.0, std::ceil(20 * widest)) / 20;
}

} // namespace

std::string page(const Atlas& atlas, const std::string& kernels, const std::string& replay) {
    const PageContext context{atlas, kernels, replay, widest_share(atlas)};
    std::string html = head() + "<header>\n" + introduction(atlas) + contents(atlas) + "</header>\n" +
                       legend(atlas, context.widest_share) + filters(atlas) + "<main>\n";
    for (const FamilyEntries& family : atlas.families) {
        html += fmt::format("<section class=\"family\" id=\"{}\">\n<h2>{}</h2>\n<p class=\"soft\">{}</p>\n",
                            element_id(family.family->name), escape_html(family.family->name),
                            escape_html(family.family->what));
        if (!family.trouble.empty())
            html += fmt::format("<p class=\"trouble\">The assembled kernel draws nothing: {}</p>\n",
                                escape_html(family.trouble));
        for (const Entry& entry : family.cases) html += entry_html(entry, context);
        html += others(family, replay) + "</section>\n";
    }
    return html + "</main>\n<script>\n" + page_script + "</script>\n</body>\n</html>\n";
}

std::string link_to_kernels(const std::filesystem::path& folder, const std::filesystem::path& kernels) {
    const std::filesystem::path from = std::filesystem::canonical(folder),
                                to = std::filesystem::canonical(kernels);
    const std::filesystem::path below = from.lexically_relative(to.parent_path());
    const bool inside = !below.empty() && *below.begin() != "..";
    return inside ? to.lexically_relative(from).generic_string() : std::string();
}

} // namespace gnomon::atlas
