#include "casegen/measure/tables.h"

#include "casegen/atlas/html.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace gnomon::measure {
namespace {

std::string share(const Quantiles& q) {
    if (q.non_finite == 0) return "0";
    const double percent = 100 * q.non_finite_share();
    return percent < 0.1 ? "<0.1 %" : fmt::format("{:.1f} %", percent);
}
void add_error_header(std::vector<std::string>& header, bool has_limit) {
    for (const char* name : {"median", "90 %", "99 %", "max"}) header.emplace_back(name);
    if (has_limit)
        for (const char* name : {"median/κu", "99 %/κu", "max/κu"}) header.emplace_back(name);
    header.emplace_back("not finite");
}

void add_errors(std::vector<std::string>& row, const Summary& s, bool has_limit) {
    for (const double value : {s.of_scale.median, s.of_scale.p90, s.of_scale.p99, s.of_scale.most})
        row.push_back(error_cell(value));
    if (has_limit)
        for (const double value : {s.of_limit.median, s.of_limit.p99, s.of_limit.most})
            row.push_back(ratio_cell(value));
    row.push_back(share(s.of_scale));
}

void add_time_header(std::vector<std::string>& header, const std::vector<Timings>& timings) {
    for (const Timings& t : timings)
        header.push_back(timings.size() > 1 ? fmt::format("ns, {}", t.inputs) : "ns");
    if (!timings.empty()) header.emplace_back("rounds");
}

void add_times(std::vector<std::string>& row, const std::vector<Timings>& timings, std::size_t variant) {
    for (const Timings& t : timings) row.push_back(time_cell(t.variants[variant].median, t));
    if (timings.empty()) return;
    const Timing& last = timings.back().variants[variant];
    row.push_back(
        fmt::format("{} to {}", time_cell(last.least, timings.back()), time_cell(last.most, timings.back())));
}

/// Columns on a terminal: characters, not bytes.
std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

bool looks_like_a_number(const std::string& cell) {
    return cell == "-" || cell == "inf" || cell.starts_with('<') ||
           (!cell.empty() && cell[0] >= '0' && cell[0] <= '9');
}

/// Every row must have a cell for each column of the header.
void require_square(const Table& table) {
    for (const auto& row : table.rows)
        if (row.size() != table.header.size())
            throw std::logic_error(fmt::format("table \"{}\": a row of {} cells under {} columns",
                                               table.title, row.size(), table.header.size()));
}

/// A column is of numbers if all its cells look like some.
std::vector<bool> columns_of_numbers(const Table& table) {
    std::vector<bool> numbers(table.header.size(), true);
    numbers[0] = false;
    for (std::size_t k = 1; k < numbers.size(); ++k)
        numbers[k] =
            std::ranges::all_of(table.rows, [&](const auto& row) { return looks_like_a_number(row[k]); });
    return numbers;
}

template <typename Of>
void add_variants(Table& table, const GroupResult& result, const std::string& name, Of&& of) {
    for (std::size_t i = 0; i < result.group.variants.size(); ++i) {
        const Summary& summary = of(result.accuracy[i]);
        std::vector<std::string> row{i == 0 ? name : "", result.group.variants[i].label,
                                     std::to_string(summary.of_scale.count)};
        add_errors(row, summary, result.has_limit);
        table.rows.push_back(std::move(row));
    }
}

} // namespace

std::string error_cell(double value) {
    return std::isinf(value) ? "inf" : value == 0 ? "0" : fmt::format("{:.1e}", value);
}

std::string ratio_cell(double value) {
    return std::isinf(value) ? "inf"
           : value == 0      ? "0"
           : value < 1000    ? fmt::format("{:.2g}", value)
                             : fmt::format("{:.0e}", value);
}

std::string time_cell(double nanoseconds, const Timings& timings) {
    const double least = timings.least_time();
    return nanoseconds < least ? fmt::format("<{:.1f}", least) : fmt::format("{:.1f}", nanoseconds);
}

Table overall_table(const GroupResult& result) {
    Table table;
    table.title = result.group.name;
    std::vector<std::string> mix;
    for (std::size_t i = 0; i < result.classes.size(); ++i)
        mix.push_back(fmt::format("{} {}", result.class_counts[i], result.classes[i]));
    table.notes.push_back(fmt::format("{} inputs: {}; {} more drawn outside the domain; seed {:#018x}",
                                      result.inputs, fmt::join(mix, ", "), result.left_out, result.seed));
    for (const Timings& t : result.timings)
        table.notes.push_back(fmt::format(
            "ns per evaluation on inputs \"{}\": {:.1f} ns of reading taken off; {} against itself {:.3f}, "
            "differences below {:.0f} % are none",
            t.inputs, t.floor, result.group.variants.front().label, t.again, 100 * t.noise()));
    table.header = {"variant"};
    add_error_header(table.header, result.has_limit);
    add_time_header(table.header, result.timings);
    const auto& dominated = result.dominated[1]; // by the 99 %
    const bool several = !dominated.empty() && result.group.variants.size() > 1;
    if (several) table.header.emplace_back("dominated by");
    for (std::size_t i = 0; i < result.group.variants.size(); ++i) {
        std::vector<std::string> row{result.group.variants[i].label};
        add_errors(row, result.accuracy[i].all, result.has_limit);
        add_times(row, result.timings, i);
        if (several) row.push_back(dominated[i] ? result.group.variants[*dominated[i]].label : "");
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table lone_table(const std::vector<const GroupResult*>& results) {
    Table table;
    table.title = "kernels without variants";
    const bool has_limit = std::ranges::any_of(results, [](const auto* r) { return r->has_limit; });
    table.header = {"kernel", "inputs", "error is"};
    add_error_header(table.header, has_limit);
    std::vector<Timings> headings = results.front()->timings;
    if (!headings.empty()) headings.resize(1);
    add_time_header(table.header, headings);
    for (const GroupResult* result : results) {
        std::vector<std::string> row{result->group.name, std::to_string(result->inputs), result->unit};
        const Summary& all = result->accuracy.front().all;
        add_errors(row, all, result->has_limit);
        if (has_limit && !result->has_limit) row.insert(row.end() - 1, 3, "-");
        std::vector<Timings> timings = result->timings;
        if (timings.size() > 1) timings.erase(timings.begin(), timings.end() - 1);
        add_times(row, timings, 0);
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table class_table(const GroupResult& result) {
    Table table{result.group.name + ", by class", {}, {"class", "variant", "inputs"}, {}};
    add_error_header(table.header, result.has_limit);
    for (std::size_t n = 0; n < result.classes.size(); ++n)
        add_variants(table, result, result.classes[n],
                     [&](const Accuracy& a) -> const Summary& { return a.classes[n]; });
    return table;
}

Table locus_table(const GroupResult& result) {
    Table table{result.group.name + ", by locus", {}, {"locus", "variant", "inputs"}, {}};
    add_error_header(table.header, result.has_limit);
    for (std::size_t n = 0; n < result.accuracy.front().loci.size(); ++n)
        add_variants(table, result, result.accuracy.front().loci[n].name,
                     [&](const Accuracy& a) -> const Summary& { return a.loci[n].all; });
    return table;
}

std::string to_text(const Table& table) {
    require_square(table);
    std::vector<std::size_t> widths(table.header.size());
    for (std::size_t k = 0; k < widths.size(); ++k) {
        widths[k] = width_of(table.header[k]);
        for (const auto& row : table.rows) widths[k] = std::max(widths[k], width_of(row[k]));
    }
    const std::vector<bool> numbers = columns_of_numbers(table);
    std::string text = table.title + "\n";
    for (const std::string& note : table.notes) text += "  " + note + "\n";
    const auto add = [&](const std::vector<std::string>& cells) {
        std::string line = " ";
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const std::string padding(widths[k] - width_of(cells[k]), ' ');
            line += (k > 0 ? "  " : " ") + (numbers[k] ? padding + cells[k] : cells[k] + padding);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    };
    add(table.header);
    for (const auto& row : table.rows) add(row);
    return text;
}

std::string to_html(const Table& table) {
    require_square(table);
    const std::vector<bool> numbers = columns_of_numbers(table);
    const auto row_of = [&](std::string_view tag, const std::vector<std::string>& cells) {
        std::string row = "<tr>";
        for (std::size_t k = 0; k < cells.size(); ++k)
            row += fmt::format("<{0}{1}>{2}</{3}>", tag, numbers[k] ? " class=\"number\"" : "",
                               atlas::escape_html(cells[k]), tag.substr(0, 2));
        return row + "</tr>\n";
    };
    std::string html;
    for (const std::string& note : table.notes)
        html += fmt::format("<p class=\"soft\">{}</p>\n", atlas::escape_html(note));
    html += fmt::format(
        "<div class=\"wide\" tabindex=\"0\"><table>\n<caption>{}</caption>\n<thead>{}</thead>\n<tbody>\n",
        atlas::escape_html(table.title), row_of("th scope=\"col\"", table.header));
    for (const auto& row : table.rows) html += row_of("td", row);
    return html + "</tbody></table></div>\n";
}

std::string to_sortable_html(const Table& table) {
    return fmt::format("<div class=\"sortable\">\n<form role=\"search\" hidden><label>Search {} <input "
                       "type=\"search\" name=\"search\"></label> <output></output></form>\n{}</div>\n",
                       atlas::escape_html(table.title), to_html(table));
}

std::string to_text(const Bench& bench, bool by_class) {
    std::string text;
    std::vector<const GroupResult*> lone;
    for (const GroupResult& result : bench.groups) {
        if (result.group.variants.size() == 1 && bench.groups.size() > 1) {
            lone.push_back(&result);
            continue;
        }
        text += to_text(overall_table(result)) + "\n";
        if (by_class && result.classes.size() > 1) text += to_text(class_table(result)) + "\n";
    }
    if (!lone.empty()) text += to_text(lone_table(lone)) + "\n";
    for (const std::string& remark : remarks(bench)) text += remark + "\n";
    return text;
}

std::vector<std::string> remarks(const Bench& bench) {
    std::vector<std::string> lines;
    const auto any = [&](auto&& of) { return std::ranges::any_of(bench.groups, of); };
    if (any([](const GroupResult& r) { return r.has_limit; }))
        lines.emplace_back(
            "Errors are fractions of the scale, the integral of |f|; κu is what rounding the inputs to "
            "float32 alone can do, no less than 2^-24 of the scale.");
    if (any([](const GroupResult& r) { return !r.has_limit; }))
        lines.emplace_back("Errors of kernels without a truth are in their tolerance's own unit.");
    lines.emplace_back("Results that are not finite count as larger than every error.");
    if (any([](const GroupResult& r) { return !r.dominated[1].empty() && r.group.variants.size() > 1; }))
        lines.emplace_back("Dominated: another variant is faster beyond the noise and no less accurate (99 "
                           "%), or no slower and more accurate.");
    if (bench.options.rounds > 0)
        lines.push_back(
            fmt::format("Times are medians of {} rounds in which all variants took turns, wall time of the "
                        "whole device: {}.",
                        bench.options.rounds, bench.machine));
    return lines;
}

} // namespace gnomon::measure
