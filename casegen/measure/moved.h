// What moved beyond noise between two benches.
#pragma once

#include "casegen/measure/baseline.h"

#include <string>
#include <vector>

namespace gnomon::measure {

enum class Change {
    worse,     ///< a larger error by more than the tolerance's unit, more wrong pixels
    slower,    ///< the ratios' interval lies above the noise
    uncertain, ///< another time, by a baseline of another machine
    changed,   ///< another error within the unit, another count of instructions
    better,
    faster,
    added, ///< measured now, not in the baseline
    removed,
};
const char* to_string(Change change); ///< "WORSE", …

/// Whether it makes the new one a worse one: worse, slower.
bool is_bad(Change change);

struct Move {
    Change change = Change::changed;
    std::string name;  ///< of the kernel; of a technique "demo: smsr"
    std::string what;  ///< "99 % error 1e-07 -> 3e-06"
    bool time = false; ///< it is told from times: a second look may not confirm it
};

struct Moved {
    std::vector<Move> moves; ///< the bad ones first, then as measured
    /// What is not compared, or only loosely, and why: another machine, driver, compiler.
    std::vector<std::string> notes;
    std::size_t kernels = 0, techniques = 0; ///< that both have
    std::size_t times = 0;                   ///< of them, with a time in both
};

/// Times that differ by less than this share never moved: what two runs on one machine differ by, whatever
/// they say of themselves.
constexpr double least_time_move = 0.10;
/// The same for a baseline of another machine.
constexpr double foreign_time_move = 0.50;

/// `whole`: `now` holds all there is, so that what the baseline alone has was removed; else it is not spoken
/// of. Errors of another driver, and instruction counts of another compiler, are not compared bit by bit:
/// errors that differ by less than same_error are then equal, counts are left out.
Moved moved(const Baseline& before, const Baseline& now, bool whole);

/// Only what both saw the same way: a time that moved in `first` and not in `again` was noise.
Moved confirmed(Moved first, const Moved& again);

/// A line per move; one line if nothing moved. `name` is the baseline's.
std::string to_text(const Moved& moved, const std::string& name);

} // namespace gnomon::measure
