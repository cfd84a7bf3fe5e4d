// Counters in a kernel's text: how many inputs reached each of its functions, statements and branches. Line
// numbers stay, and so do results: a condition `c` becomes `gnomon_was(7u, c)`, which notes and returns it,
// and a run of statements begins with `gnomon_hit(9u);`.
#pragma once

#include "casegen/added_buffer.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::coverage {

/// A function with a body.
struct Function {
    std::string name;       ///< "walls_of"; of several by one name "bounded(vec2)"
    int line = 1, last = 1; ///< where its type and where its closing brace stands
    std::size_t counter = 0;
};

/// Lines that hold a statement, or what stands before a block. What follows a statement that can leave
/// (return, break, …) has a counter of its own.
struct Lines {
    int first = 1, last = 1;
    std::size_t counter = 0;
};

/// A place where a kernel goes one of several ways.
struct Branch {
    /// The whole condition of an if, a ?: or a loop, or an operand of && and || (how these came out says
    /// whether what stands behind them was evaluated): two outcomes, true and false. A condition that is made
    /// up of && and || has no counters of its own: its operands have them all. Or a switch: an outcome for
    /// each label, reached by a jump or from the case above it, and one for "none of them" if it has no
    /// default.
    enum class Kind { condition, labels };
    struct Outcome {
        std::string what; ///< "true", "case 12u"
        int line = 1;
        std::size_t counter = 0;
    };
    Kind kind = Kind::condition;
    int line = 1;
    std::string text; ///< in the author's words: "a < b", "number" of a switch
    std::vector<Outcome> outcomes;
};

/// What bears no counters, and why.
struct Omission {
    int line = 1;
    std::string why;
};

struct Instrumented {
    std::string text;
    std::size_t counters = 0; ///< how many it uses, numbered from 0
    std::vector<Function> functions;
    std::vector<Lines> lines;     ///< in the order of the text
    std::vector<Branch> branches; ///< the same
    std::vector<Omission> omissions;
};

/// The text with counters `first`, an even number, `first` + 1, … in it. What GLSL asks to be constant
/// (global and const initialisers, array sizes, labels) is left alone, macros cannot be looked into, and a
/// text with #if in it is left alone altogether: `omissions` names those that hold branches. A text whose
/// brackets do not close is returned as it is: compiling it says why.
Instrumented instrument(std::string_view text, std::size_t first = 0);

/// Counters `begin` to `end`, both even.
struct Range {
    std::size_t begin = 0, end = 0;
};

/// What must stand around instrumented texts that use this many counters: every invocation notes in bits
/// which of those in `active` it reached, and writes them to a buffer of uints when it ends: counter n of
/// record i as bit n % 32 of word i * words_of(counters) + n / 32. Bits and no atomic additions: a driver
/// compiles these for minutes. Even so it may unroll a loop no longer and round otherwise; then fewer at a
/// time help.
Addition counters_around(std::size_t counters, Range active);
inline std::size_t words_of(std::size_t counters) { return counters / 32 + 1; }

} // namespace gnomon::coverage
