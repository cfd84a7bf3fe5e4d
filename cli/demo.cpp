#include "cli/commands.h"
namespace gnomon::cli {
void add_demo(CLI::App&, Common&, int&) {}
} // namespace gnomon::cli
