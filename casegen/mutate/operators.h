// Small changes of a kernel's text, each of which a check should notice.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::mutate {

/// What is changed into what: docs/mutation.md lists all of them.
enum class Operator {
    constant,   ///< a number becomes another, true becomes false
    comparison, ///< < becomes <=, or >
    arithmetic, ///< + becomes -, * becomes /, ++ becomes --, or += 2 in a for
    bits,       ///< & becomes |, << becomes >>
    sign,       ///< a minus is dropped, or put before a whole value
    logic,      ///< && becomes ||, a ! or ~ is dropped
    condition,  ///< of an if, a loop or a ?: is negated (its arms change places), always true, never true
    component,  ///< .x becomes .y, .xy becomes .yx
    call,       ///< clamp, min, max, abs … give an argument back, min becomes max
    arguments,  ///< two neighbouring ones change places
    statement,  ///< an assignment, a call, a jump, an early return is dropped
    result,     ///< a return gives 0 or 1 instead
    stale,      ///< one kernel sees another version of what it includes (see stale_version)
};
const char* to_string(Operator by);
/// In the order above.
const std::vector<Operator>& all_operators();
/// Throws Error that lists them for a name that none has.
Operator parse_operator(std::string_view name);

/// One of them: a text with the characters `begin` to `end` replaced by `after`.
struct Mutation {
    Operator by = Operator::constant;
    std::size_t begin = 0, end = 0;
    std::string after;
    int line = 1, column = 1; ///< of `begin`, counted from 1
    /// What it is wherever its function stands: the function's text without comments and blanks, where in it,
    /// and what becomes of it. Of a declaration outside of functions the declaration's text.
    std::string identity;
};

/// All mutations of a file's text, in the order of its characters, then of the operators; never two that give
/// the same text. Outside of functions only the values of declarations are changed; includes, prototypes,
/// parameters and structures never are. Types are not known: some do not compile.
std::vector<Mutation> mutations(std::string_view text);

/// The whole text, changed.
std::string mutated(std::string_view text, const Mutation& mutation);

/// Another version of a kernel's file, as one would compile on from an old copy: whatever the function `name`
/// returned, it returns something else (1 - value, or the complement). Empty if the text has no
/// such function, or one whose result cannot be changed so.
std::string stale_version(std::string_view text, std::string_view name);

} // namespace gnomon::mutate
