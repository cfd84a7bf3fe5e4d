#include "casegen/catalogue.h"
#include "cli/commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace gnomon::cli {

void add_list(CLI::App& app, Common&) {
    CLI::App* verb = app.add_subcommand("list", "list kernels, with where each comes from");
    auto pattern = std::make_shared<std::string>();
    verb->add_option("PATTERN", *pattern, pattern_help);
    verb->callback([pattern] {
        const std::vector<const Case*> cases = find_cases(*pattern);
        std::size_t width = 0;
        for (const Case* c : cases) width = std::max(width, c->name.size());
        for (const Case* c : cases) fmt::print("{:<{}}  {}\n", c->name, width, c->source);
    });
}

} // namespace gnomon::cli
