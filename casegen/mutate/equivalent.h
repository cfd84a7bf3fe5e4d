// Mutants that no check can or should notice, each with the reason: fixtures/mutants/equivalent.json.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gnomon::mutate {

struct Equivalent {
    std::string id, file;
    std::string mutation; ///< for people: "smsr_case_09: < becomes <="
    /// Not the same function on the domain: other roundings, or another answer where the tolerance's own
    /// derivation leaves either. Else it is the same function there.
    bool tolerated = false;
    std::string reason;
};

/// A list of groups, each {"file", "reason", "tolerated" (optional), "mutants": {id: mutation, …}}. `name`
/// stands for the text in messages. Throws Error naming it and the place: no JSON, a field missing, unknown
/// or of another type, an empty reason, an id twice.
std::vector<Equivalent> parse_equivalents(std::string_view text, const std::string& name);

/// Of a file; none if there is no such file. Throws Error.
std::vector<Equivalent> load_equivalents(const std::filesystem::path& file);

} // namespace gnomon::mutate
