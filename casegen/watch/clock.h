// How long the session waits for what, in seconds.
#pragma once

#include "runtime/clock.h"

#include <limits>

namespace gnomon::watch {

constexpr double never = std::numeric_limits<double>::infinity();

constexpr double quiet = 0.002; ///< after a change, until what belongs to it has come too
constexpr double longest_settling = 0.05;
constexpr double absence = 0.1;         ///< a file that is gone for so long is gone: editors rename
constexpr double overdue = 0.5;         ///< a worker that is busy with an outdated state for so long is ended
constexpr double stealing = 0.25;       ///< so long a kernel waits for its own worker
constexpr double first_patience = 300;  ///< truths may have to be computed
constexpr double compile_patience = 20; ///< besides what dispatches may take

} // namespace gnomon::watch
