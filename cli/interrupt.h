// Ctrl-C, for verbs that end in good order when they are told to.
#pragma once

#include <atomic>

namespace gnomon::cli {

/// True from SIGINT or SIGTERM on, which no longer end the process.
const std::atomic<bool>& interrupted_by_signals();

} // namespace gnomon::cli
