#include "casegen/catalogue.h"
#include "cli/commands.h"

#include <fmt/format.h>

#include <memory>

namespace gnomon::cli {

void add_list(CLI::App& app, Common&) {
    CLI::App* verb = app.add_subcommand("list", "list kernels, with where each comes from");
    auto pattern = std::make_shared<std::string>();
    verb->add_option("PATTERN", *pattern, "part of a name, or a pattern with * and ?");
    verb->callback([pattern] {
        for (const Case* c : find_cases(*pattern)) fmt::print("{:<28}{}\n", c->name, c->source);
    });
}

} // namespace gnomon::cli
