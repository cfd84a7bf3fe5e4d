// The parts of a GLSL file that mutations are made of: expressions, calls, statements. Found by brackets and
// keywords; nothing is known of types.
#pragma once

#include "runtime/glsl/tokens.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::mutate {

/// Tokens `begin` to `end` - 1.
struct Value {
    std::size_t begin = 0, end = 0;
    friend bool operator==(const Value&, const Value&) = default;
};

/// `condition ? then : otherwise`.
struct Ternary {
    Value condition, then, otherwise;
};

/// `name(arguments)`: a function's or a constructor's.
struct Call {
    std::size_t name = 0, end = 0; ///< the token of the name, and the one behind ")"
    std::vector<Value> arguments;
};

/// `return value;` of the function `function`, whose result is of type `type`.
struct Return {
    Value value;
    std::string_view type, function;
};

/// What is changed: a function's body, or the value of a declaration outside of functions.
struct Region {
    std::size_t begin = 0, end = 0;
    std::size_t first = 0; ///< where the whole function or declaration begins
    std::string text;      ///< of the whole, its tokens with a blank between them
};

class Parts {
public:
    /// The text must outlive it.
    explicit Parts(std::string_view text);

    const std::vector<glsl::Token>& tokens() const { return tokens_; }
    const std::vector<Region>& regions() const { return regions_; }
    const Region& region_of(std::size_t token) const;

    /// Whether the operator at this token has a left-hand side.
    bool is_binary(std::size_t token) const;

    const std::vector<Value>& values() const { return values_; } ///< that are assigned or returned, whole
    const std::vector<Value>& conditions() const { return conditions_; } ///< of ifs and loops
    bool is_of_loop(const Value& condition) const;
    /// Whether the token is of what a `for` does after each of its rounds.
    bool is_of_step(std::size_t token) const;
    const std::vector<Ternary>& ternaries() const { return ternaries_; }
    const std::vector<Call>& calls() const { return calls_; }
    /// Statements without which a function may still compile: all but declarations and its last return.
    const std::vector<Value>& droppable() const { return droppable_; }
    const std::vector<Return>& returns() const { return returns_; }

private:
    bool is_assignment(std::size_t token) const;
    std::size_t statement(std::size_t begin, std::size_t end, const glsl::Function& function);
    void simple_statement(std::size_t begin, std::size_t end);
    void expressions(std::size_t begin, std::size_t end);
    void find_declarations(const std::vector<glsl::Function>& functions);
    Region region(std::size_t first, std::size_t last, std::size_t begin, std::size_t end) const;

    std::vector<glsl::Token> tokens_;
    std::vector<Region> regions_;
    std::vector<Value> values_, conditions_, loops_, steps_, droppable_;
    std::vector<Ternary> ternaries_;
    std::vector<Call> calls_;
    std::vector<Return> returns_;
};

} // namespace gnomon::mutate
