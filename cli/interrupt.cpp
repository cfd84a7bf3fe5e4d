#include "cli/interrupt.h"

#include <csignal>

namespace gnomon::cli {
namespace {

std::atomic<bool> interrupted = false;
extern "C" void interrupt(int) { interrupted = true; }

} // namespace

const std::atomic<bool>& interrupted_by_signals() {
    std::signal(SIGINT, interrupt);
    std::signal(SIGTERM, interrupt);
    return interrupted;
}

} // namespace gnomon::cli
