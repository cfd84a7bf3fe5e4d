#include "casegen/measure/extras.h"

#include "casegen/measure/json_reading.h"
#include "casegen/measure/tables.h"

#include "runtime/error.h"

#include <fmt/format.h>

#include <array>

namespace gnomon::measure {
namespace {

using Json = nlohmann::ordered_json;

std::string percent(std::uint64_t part, std::uint64_t whole) {
    return whole == 0 ? "-"
                      : fmt::format("{:.1f}", 100 * static_cast<double>(part) / static_cast<double>(whole));
}

struct Survivors {
    Table table;
    void add(const std::string& kernel, const Json& mutant, const std::string& at) {
        std::string id;
        const Json& value = member(mutant, "id", at);
        id = value.is_string() ? value.get<std::string>() : value.dump();
        table.rows.push_back(
            {kernel, id,
             fmt::format("{}:{}:{}", text_member(mutant, "file", at), count_member(mutant, "line", at),
                         count_member(mutant, "column", at)),
             text_member(mutant, "before", at), text_member(mutant, "after", at)});
    }
};

} // namespace

std::string mutation_section(const std::string& text, const std::string& name) {
    const Json json = parse_json(text, name);
    Table scores{
        "Mutation scores",
        {},
        {"kernel", "mutants", "killed", "equivalent", "same code", "stillborn", "survived", "score %"},
        {}};
    Survivors survivors{{"Surviving mutants", {}, {"kernel", "mutant", "where", "before", "after"}, {}}};
    std::uint64_t all_killed = 0, all_survived = 0;
    const Json& kernels = list_member(json, "kernels", name);
    if (kernels.empty()) throw Error("{}: holds no kernels; gnomon mutate --json writes what is shown", name);
    for (const Json& kernel : kernels) {
        const std::string kernel_name = text_member(kernel, "name", name);
        const std::string at = fmt::format("{}, kernel {}", name, kernel_name);
        const Json& survived = list_member(kernel, "survived", at);
        const std::uint64_t killed = count_member(kernel, "killed", at);
        all_killed += killed;
        all_survived += survived.size();
        std::vector<std::string> row{kernel_name};
        for (const char* count : {"mutants", "killed", "equivalent", "same_code", "stillborn"})
            row.push_back(std::to_string(count_member(kernel, count, at)));
        row.push_back(std::to_string(survived.size()));
        row.push_back(percent(killed, killed + survived.size()));
        scores.rows.push_back(std::move(row));
        for (const Json& mutant : survived) survivors.add(kernel_name, mutant, at);
    }
    scores.notes.push_back(fmt::format("{} of {} mutants that can be told from the original are killed, {} "
                                       "%. The score is killed over killed "
                                       "and survived: equivalent ones, those of the same code and those that "
                                       "do not compile count for nothing.",
                                       all_killed, all_killed + all_survived,
                                       percent(all_killed, all_killed + all_survived)));
    return to_sortable_html(scores) + (survivors.table.rows.empty() ? "" : to_sortable_html(survivors.table));
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
