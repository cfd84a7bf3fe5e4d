// What a comparison finds out about one kernel. Plain values that cross from a child process (see message.h).
#pragma once

#include "casegen/measure/paired.h"
#include "casegen/measure/quantiles.h"
#include "casegen/versus/difference.h"

#include <cstddef>
#include <string>
#include <vector>

namespace gnomon::versus {

/// A kernel on its own, held to its reference.
struct SideReport {
    /// Why it is not right, in few words: "wrong", "never written", "compile error", "timeout", "crash" …;
    /// empty if it passes.
    std::string failure;
    std::string message; ///< more of it, in a line
    bool ran = false;    ///< it has results: there is more below
    std::uint64_t seed = 0;
    std::size_t samples = 0, wrong = 0; ///< wrong: those that do not pass
    measure::Quantiles error;           ///< over the samples in the domain
    std::string unit;                   ///< of the errors: "of the limit", "ulps", …
    std::string allowed;                ///< its tolerance
};

struct DifferenceReport {
    Difference counts;
    std::size_t lost = 0;             ///< samples that A passes, each by its own table, and B does not
    bool worst_defined = false;       ///< the call below is in the domain
    std::string call_a, call_b;       ///< "smsr_case_09(p = vec2(…), …)"; empty if nothing differs
    std::string got_a, got_b, want;   ///< want: the reference's value; empty outside the domain
    std::string command_a, command_b; ///< that run this call again
};

struct PictureReport {
    std::string png;
    std::string across, down, rest; ///< "p.x from 0 to 1", …; rest: the call whose other values are taken
    double scale = 0;
    std::size_t pixels = 0, differ = 0, finiteness = 0, both_nan = 0, outside = 0;
};

struct Comparison {
    std::string name; ///< the kernel's; of two: "integral/sinc/a0 / integral/gauss8/a0"
    SideReport a, b;
    bool compared = false; ///< both have results, which `difference` is about
    DifferenceReport difference;
    bool timed = false;
    measure::Pairing time;
    std::string not_timed; ///< why there are no times although they were asked for
    bool drawn = false;
    PictureReport picture;
    std::string not_drawn;
};

inline bool is_right(const SideReport& side) { return side.failure.empty(); }

/// Whether B is wrong on a sample on which A is right, be A wrong on others.
bool is_worse(const Comparison& comparison);

/// How B's error compares with A's, and whether it is right: "B is right: max error 0.7 → 0.9 of the limit",
/// "B is WRONG: 132 of 65536 samples fail; …".
std::string accuracy_verdict(const Comparison& comparison);

} // namespace gnomon::versus
