#include "casegen/mutate/mutant.h"

#include "casegen/catalogue.h"
#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace gnomon::mutate {
namespace {

std::string id_of(const std::string& file, const std::string& identity) {
    return fmt::format("{:010x}", hash(identity, hash(file)) >> 24);
}

bool is_shared(const std::string& file) { return file.ends_with(".glslh"); }

/// What a kernel compiles from.
struct Compiled {
    const Case* kernel = nullptr;
    std::vector<std::string> files;
    std::size_t size = 0; ///< of the whole text
};

std::vector<Compiled> compiled(std::span<const Case* const> cases, const glsl::Sources& sources) {
    std::vector<Compiled> all;
    for (const Case* c : cases) {
        if (!c->fails.empty()) continue;
        Compiled& each = all.emplace_back();
        each.kernel = c;
        each.files = files_of(*c, sources);
        each.size = glsl::expand(sources, standalone_source(*c), standalone_name).size();
    }
    return all;
}

std::string one_line(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t\n");
    return first == text.npos ? std::string() : std::string(text.substr(first));
}

} // namespace

std::vector<std::string> files_of(const Case& c, const glsl::Sources& sources) {
    return glsl::included_files(sources, standalone_source(c));
}

std::vector<Mutant> mutants_of(std::span<const Case* const> cases, const glsl::Sources& sources,
                               std::span<const Operator> operators) {
    std::vector<const Case*> all_cases(cases.begin(), cases.end());
    std::map<std::string, const Case*> kernel_of; // by file
    for (const Family& family : catalogue())
        for (const Case& c : family.cases) {
            if (std::ranges::find(all_cases, &c) == all_cases.end()) all_cases.push_back(&c);
            kernel_of[c.name + ".glsl"] = &c;
        }

    std::map<std::string, std::vector<const Case*>> users;  // by file that is changed
    std::vector<std::pair<const Case*, std::string>> stale; // who includes which other kernel
    for (const Compiled& each : compiled(cases, sources))
        for (const std::string& file : each.files) {
            if (file == each.kernel->name + ".glsl") users[file] = {each.kernel};
            if (is_shared(file)) users[file];
            if (file != each.kernel->name + ".glsl" && kernel_of.contains(file))
                stale.emplace_back(each.kernel, file);
        }
    std::vector<Compiled> everyone;
    if (std::ranges::any_of(users, [](const auto& entry) { return is_shared(entry.first); }))
        everyone = compiled(all_cases, sources);
    std::ranges::stable_sort(everyone, {}, &Compiled::size);
    for (auto& [file, of_file] : users)
        if (is_shared(file))
            for (const Compiled& each : everyone)
                if (std::ranges::find(each.files, file) != each.files.end()) of_file.push_back(each.kernel);

    const auto wanted = [&](Operator by) { return std::ranges::find(operators, by) != operators.end(); };
    std::vector<Mutant> mutants;
    for (const auto& [file, of_file] : users) {
        const std::string text = glsl::text_of(sources, file);
        for (Mutation& mutation : mutations(text)) {
            if (!wanted(mutation.by)) continue;
            Mutant& mutant = mutants.emplace_back();
            mutant.id = id_of(file, mutation.identity);
            mutant.file = file;
            mutant.before = text.substr(mutation.begin, mutation.end - mutation.begin);
            mutant.text = mutated(text, mutation);
            mutant.users = of_file;
            mutant.mutation = std::move(mutation);
        }
    }
    for (const auto& [kernel, file] : stale) {
        if (!wanted(Operator::stale)) continue;
        std::string text = stale_version(glsl::text_of(sources, file), function_name(*kernel_of[file]));
        if (text.empty()) continue;
        Mutant& mutant = mutants.emplace_back();
        mutant.id = id_of(file, fmt::format("stale in {}", kernel->name));
        mutant.file = file;
        mutant.mutation.by = Operator::stale;
        mutant.before = kernel->name;
        mutant.mutation.after = "another version of " + file;
        mutant.text = std::move(text);
        mutant.users = {kernel};
    }
    std::set<std::string> ids;
    for (const Mutant& mutant : mutants)
        if (!ids.insert(mutant.id).second)
            throw Error("two mutants have the id {}; the second is in {}:{}", mutant.id, mutant.file,
                        mutant.mutation.line);
    return mutants;
}

bool counts_for(const Mutant& mutant, const Case& c, std::span<const std::string> files) {
    if (!c.fails.empty()) return false;
    if (!is_shared(mutant.file)) return std::ranges::find(mutant.users, &c) != mutant.users.end();
    return std::ranges::find(files, mutant.file) != files.end();
}

glsl::Sources with(const glsl::Sources& sources, const Mutant& mutant) {
    glsl::Sources changed = sources;
    changed.overlaid[mutant.file] = mutant.text;
    return changed;
}

std::string difference(const Mutant& mutant, const glsl::Sources& sources) {
    if (mutant.mutation.by == Operator::stale)
        return fmt::format("- {}\n+ {}\n", "what " + mutant.before + " includes", mutant.mutation.after);
    const std::string text = glsl::text_of(sources, mutant.file);
    const Mutation& m = mutant.mutation;
    const std::size_t line_begin = m.begin == 0 ? 0 : text.rfind('\n', m.begin - 1) + 1;
    const std::size_t line_end = std::min(text.find('\n', m.end), text.size());
    const std::string before = text.substr(line_begin, line_end - line_begin);
    const std::string after =
        text.substr(line_begin, m.begin - line_begin) + m.after + text.substr(m.end, line_end - m.end);
    return fmt::format("- {}\n+ {}\n", one_line(before), one_line(after));
}

} // namespace gnomon::mutate
