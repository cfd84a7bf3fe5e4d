// The clock that everything is timed and waited for with: it never goes back.
#pragma once

#include <chrono>

namespace gnomon {

/// Seconds since some moment that stays the same while the machine runs.
inline double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

} // namespace gnomon
