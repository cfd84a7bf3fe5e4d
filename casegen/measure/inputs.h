// The inputs that variants are compared on: ordinary ones, and so many near every locus of the generator at
// every distance, each with its truth.
#pragma once

#include "casegen/sampling.h"
#include "casegen/standalone.h"
#include "casegen/truths.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::measure {

struct InputOptions {
    std::size_t ordinary = 1024;
    std::size_t repeats = 16; ///< per locus and distance
    std::uint64_t seed = 0;
    unsigned jobs = 0; ///< threads for truths; 0: one per core
};

/// Only what lies in the case's domain.
struct Inputs {
    explicit Inputs(const Case& c) : records(c) {}
    Records records;
    std::vector<std::optional<Place>> places; ///< per record; nothing for an ordinary one
    std::vector<Truth> truths;                ///< per record; none at all if the reference has no truth
    std::vector<std::string> classes;         ///< "ordinary", then the groups of the loci, each once
    std::vector<std::size_t> class_of;        ///< per record, a number of `classes`
    std::size_t left_out = 0;                 ///< drawn, but outside the domain
    std::shared_ptr<const EdgePool> pool;     ///< whose masks the records name
};

/// The same bits for the same seed, on any number of jobs. An input outside the domain is drawn again a few
/// times before it is left out. Throws Error if none at all is in the domain.
Inputs draw_inputs(const Case& c, const InputOptions& options);

/// truths() on so many threads; 0: one per core.
std::vector<Truth> truths_on(const Case& c, const Records& records, unsigned jobs, const TruthFiles& files);

} // namespace gnomon::measure
