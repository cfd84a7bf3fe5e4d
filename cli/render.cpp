#include "cli/commands.h"
namespace gnomon::cli {
void add_render(CLI::App&, Common&) {}
} // namespace gnomon::cli
