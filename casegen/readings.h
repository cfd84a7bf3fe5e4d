// What the documents leave open and RSMSS can be read as: named, so that a report can show what each reading
// costs. docs/decisions.md says why the first value of each is the default.
#pragma once

#include <map>
#include <string>
#include <vector>

namespace gnomon {

/// The readings that kernels are assembled for.
struct Readings {
    unsigned rsmss = 0;         ///< bits of kernels/rsmss/options.glslh
    bool flip_isolated = false; ///< of the map, for every technique: see without_isolated
    friend bool operator==(const Readings&, const Readings&) = default;
};

struct Reading {
    const char* decision;            ///< "A6"
    const char* name;                ///< "bar"
    std::vector<const char*> values; ///< "dark", "ramp": the first is the default
    std::vector<Readings> bits;      ///< what each value sets
    const char* what;                ///< one line
};

const std::vector<Reading>& readings();

/// From "bar=ramp", "breach-tie=first", …; later ones replace earlier ones of the same name. Throws Error
/// with the names or values that there are.
Readings parse_readings(const std::vector<std::string>& settings);

/// The same for one technique. Throws Error if a reading that is RSMSS's alone is asked of another.
Readings readings_for(const std::string& technique, const std::vector<std::string>& settings);

/// What kernels include by <> for them: <rsmss/options> and <pipeline/options>.
std::map<std::string, std::string> reading_sources(const Readings& chosen);

/// "bar=ramp breach-tie=first": those that are not the default; empty if all are.
std::string to_string(const Readings& chosen);

} // namespace gnomon
