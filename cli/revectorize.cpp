#include "cli/commands.h"
namespace gnomon::cli {
void add_revectorize(CLI::App&, Common&) {}
} // namespace gnomon::cli
