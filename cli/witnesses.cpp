#include "casegen/catalogue.h"
#include "casegen/witness.h"
#include "cli/commands.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {
namespace {

const Family& family_with_cases(const std::string& name) {
    std::vector<std::string> names;
    for (const Family& family : catalogue()) {
        const bool numbered = std::ranges::any_of(family.cases, [](const Case& c) { return c.number != 0; });
        if (numbered && family.name == name) return family;
        if (numbered) names.push_back(family.name);
    }
    throw Error("no family \"{}\" with numbered cases; there are {}", name, fmt::join(names, ", "));
}

} // namespace

void add_witnesses(CLI::App& app, Common&) {
    CLI::App* verb = app.add_subcommand(
        "witnesses", "find the smallest shadow mask for every way through a family's cases");
    auto name = std::make_shared<std::string>();
    verb->add_option("FAMILY", *name, "smsr, rsmss, …: a family whose cases are numbered")->required();
    verb->footer(
        "Each line: kernel and what it reads of the texel's surroundings: what lies outside the mask, the\n"
        "texel, the mask's rows ('/' parts them, # shadow, . lit, the first is y = 0).");
    verb->callback([name] {
        const Family& family = family_with_cases(*name);
        fmt::print("// gnomon witnesses {}\n", *name);
        for (const BranchWitness& found : branch_witnesses(family)) fmt::print("{}\n", to_string(found));
    });
}

} // namespace gnomon::cli
