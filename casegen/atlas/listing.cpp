#include "casegen/atlas/listing.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace gnomon::atlas {
namespace {

using coverage::Branch;
using coverage::Hits;

std::string count_html(const Hits& hits) {
    if (hits.all() == 0) return "<b class=\"never\">never</b>";
    return fmt::format("{}{}", hits.all(),
                       hits.fixtures == 0 ? " <span class=\"soft\">random samples only</span>" : "");
}

std::string branch_html(const Branch& branch, const std::vector<Hits>& hits) {
    std::string outcomes;
    for (const Branch::Outcome& outcome : branch.outcomes)
        outcomes += fmt::format("{}{} {}", outcomes.empty() ? "" : ", ", escape_html(outcome.what),
                                count_html(hits[outcome.counter]));
    return fmt::format("<div>↳ <code>{}</code> {}</div>", escape_html(branch.text), outcomes);
}

} // namespace

std::string listing_html(const coverage::FileCoverage& file) {
    const std::map<int, Hits> lines = coverage::line_hits(file);
    std::string html =
        "<div class=\"wide\"><table class=\"listing\"><thead><tr><th class=\"number\">Reached</th>"
        "<th class=\"number\">Line</th><th>Text, and branches</th></tr></thead><tbody>\n";
    std::string_view rest = file.text;
    for (int line = 1; !rest.empty(); ++line) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view text = rest.substr(0, end);
        rest.remove_prefix(std::min(end + 1, rest.size()));
        const auto found = lines.find(line);
        std::string branches;
        for (const Branch& branch : file.points.branches)
            if (branch.line == line) branches += branch_html(branch, file.hits);
        const bool missed = (found != lines.end() && found->second.all() == 0) ||
                            branches.find("class=\"never\"") != branches.npos;
        html += fmt::format("<tr{}><td class=\"number\">{}</td><td class=\"number soft\">{}</td>"
                            "<td><code>{}</code>{}</td></tr>\n",
                            missed ? " class=\"missed\"" : "",
                            found == lines.end() ? "" : count_html(found->second), line, glsl_to_html(text),
                            branches);
    }
    return html + "</tbody></table></div>";
}

std::string reached_in_words(const coverage::FileCoverage& file) {
    const auto [lines, branches, functions] = coverage::totals(file);
    std::string words =
        fmt::format("{} of {} lines, {} of {} branches", lines.all, lines.of, branches.all, branches.of);
    if (lines.fixtures < lines.all || branches.fixtures < branches.all)
        words += fmt::format(" (by the fixtures alone {} and {})", lines.fixtures, branches.fixtures);
    return words;
}

} // namespace gnomon::atlas
