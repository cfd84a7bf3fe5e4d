#include "casegen/measure/extras.h"

#include "casegen/measure/json_reading.h"
#include "casegen/measure/tables.h"

#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <map>

namespace gnomon::measure {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "-"
                      : fmt::format("{:.1f}", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::vector<std::string> score_row(const std::string& kernel, const Json& counts, const std::string& at) {
    std::vector<std::string> row{kernel};
    for (const char* count : {"mutants", "killed", "equivalent", "tolerated", "same_code", "stillborn"})
        row.push_back(std::to_string(count_member(counts, count, at)));
    const std::uint64_t killed = count_member(counts, "killed", at);
    const std::uint64_t survived = list_member(counts, "survived", at).size();
    row.push_back(std::to_string(survived));
    row.push_back(percent(killed, killed + survived));
    return row;
}

} // namespace

std::string mutation_section(const std::string& text, const std::string& name) {
    const Json json = parse_json(text, name);
    Table scores{"Mutation scores",
                 {},
                 {"kernel", "mutants", "killed", "equivalent", "tolerated", "same code", "stillborn",
                  "survived", "score %"},
                 {}};
    const Json& kernels = list_member(json, "kernels", name);
    if (kernels.empty()) throw Error("{}: holds no kernels; gnomon mutate --json writes what is shown", name);
    std::map<std::string, std::vector<std::string>> survived_in; // by mutant, the kernels
    for (const Json& kernel : kernels) {
        const std::string kernel_name = text_member(kernel, "name", name);
        const std::string at = fmt::format("{}, kernel {}", name, kernel_name);
        scores.rows.push_back(score_row(kernel_name, kernel, at));
        for (const Json& mutant : list_member(kernel, "survived", at))
            survived_in[text_member(mutant, "id", at)].push_back(kernel_name);
    }
    const Json& all = member(json, "all", name);
    const std::string at = name + ", all";
    scores.rows.insert(scores.rows.begin(), score_row("every mutant", all, at));
    scores.notes.emplace_back(
        "The score is killed over killed and survived: equivalent mutants (of which tolerated: their answers "
        "differ within the tolerance), those of the same code and those that do not compile count for "
        "nothing. A mutant of a file that kernels share counts in the row of each, and once among all.");
    Table survivors{
        "Surviving mutants", {}, {"mutant", "where", "operator", "before", "after", "survives in"}, {}};
    for (const Json& mutant : list_member(all, "survived", at)) {
        const std::string id = text_member(mutant, "id", at);
        survivors.rows.push_back(
            {id,
             fmt::format("{}:{}:{}", text_member(mutant, "file", at), count_member(mutant, "line", at),
                         count_member(mutant, "column", at)),
             text_member(mutant, "operator", at), text_member(mutant, "before", at),
             text_member(mutant, "after", at), fmt::format("{}", fmt::join(survived_in[id], ", "))});
    }
    return to_sortable_html(scores) + (survivors.rows.empty() ? "" : to_sortable_html(survivors));
}

std::string coverage_section(const std::string& text, const std::string& name) {
    constexpr std::array kinds{"lines", "branches", "functions"};
    const Json json = parse_json(text, name);
    Table table{"Coverage", {}, {"file"}, {}};
    for (const char* kind : kinds)
        for (const char* what : {"", " %", " with samples"})
            table.header.push_back(fmt::format("{}{}", kind, what));
    const auto row_of = [&](const std::string& file, const Json& totals, const std::string& at) {
        std::vector<std::string> row{file};
        for (const char* kind : kinds) {
            const Json& share = member(totals, kind, at);
            const std::string here = fmt::format("{}, \"{}\"", at, kind);
            const std::uint64_t fixtures = count_member(share, "fixtures", here);
            const std::uint64_t all = count_member(share, "all", here), of = count_member(share, "of", here);
            row.push_back(fmt::format("{}/{}", fixtures, of));
            row.push_back(percent(fixtures, of));
            row.push_back(fmt::format("{}/{}", all, of));
        }
        return row;
    };
    table.rows.push_back(row_of("all files", member(json, "totals", name), name));
    for (const Json& file : list_member(json, "files", name)) {
        const std::string file_name = text_member(file, "file", name);
        const std::string at = fmt::format("{}, file {}", name, file_name);
        table.rows.push_back(row_of(file_name, member(file, "totals", at), at));
    }
    table.notes.emplace_back(
        "What the fixtures reached of each GLSL file, and what fixtures and random samples "
        "did together; a branch is one outcome.");
    return to_sortable_html(table);
}

} // namespace gnomon::measure
