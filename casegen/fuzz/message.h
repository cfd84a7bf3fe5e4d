// What a campaign and its workers say to each other, and what its journal keeps: JSON, bits as whole numbers.
#pragma once

#include "casegen/fuzz/unit.h"

#include <optional>
#include <set>
#include <string>

namespace gnomon::fuzz {

struct Request {
    std::size_t kernel = 0; ///< its number in the campaign
    std::uint64_t round = 0;
    std::size_t evaluations = 0;
    bool shrink = true;
    std::optional<std::size_t> batches; ///< of the unit, only the first ones
    std::set<std::string> known;
    std::optional<Part> part; ///< only this, only to see whether it survives
    bool tell_inputs = false; ///< only how `part` reads
};

/// What a worker says of a unit. One of them.
struct Reply {
    std::optional<UnitResult> result;
    std::string timeout;       ///< the kernel did not end: what the device said; the worker is of no more use
    std::string compile_error; ///< what glslang said
    std::vector<Input> inputs; ///< if they were asked for
};

/// Throws Error unless the kernel can be called with it.
void require_input_of(const Case& c, const Input& input);

/// Parsing throws Error of a text that format_… never writes.
std::string format_request(const Request& request);
Request parse_request(const std::string& text);
std::string format_reply(const Reply& reply);
Reply parse_reply(const std::string& text);

} // namespace gnomon::fuzz
