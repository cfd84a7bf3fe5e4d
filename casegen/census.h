// How often each numbered case occurs: over masks, views, and what their shares have in common.
#pragma once

#include "casegen/catalogue.h"
#include "runtime/glsl/compiler.h"
#include "runtime/gpu/device.h"

#include <cstdint>
#include <span>
#include <vector>

namespace gnomon {

/// Texels or pixels by the number of their case; [0]: of no case.
using Counts = std::vector<std::uint64_t>;

/// Texels of the mask by the family's kernel `number`.
Counts mask_census(gpu::Device& device, const glsl::Sources& sources, const Family& family, const Mask& mask);

struct CaseShare {
    const Case* c = nullptr;
    std::uint64_t count = 0;
    double share = 0;     ///< of all that are of any case, all censuses together
    double mean = 0;      ///< over the censuses that met any case, of the share in each
    double deviation = 0; ///< of those shares, the sample's (n - 1); 0 for a single one
};

/// One entry per numbered case, ascending.
std::vector<CaseShare> case_shares(const Family& family, std::span<const Counts> censuses);

/// The cases that were met, most frequent first; of equals the smaller number. {0} if none was: see
/// Assembly::cases.
std::vector<unsigned> cases_by_frequency(const Family& family, const Counts& counts);

/// The i-th of directions that spread evenly over all from which light can fall: down (-y) and never flatter
/// than some 18 degrees. The same bits on every machine.
glm::vec3 spread_direction(unsigned i);

} // namespace gnomon
