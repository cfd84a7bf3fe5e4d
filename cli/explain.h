// What leaving out the cases that a view does not need is worth, measured.
#pragma once

#include "casegen/census.h"
#include "runtime/pipeline/renderer.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gnomon::cli {

/// One quantity of the kernel with all cases, and of the one with the view's.
struct Pair {
    double all = 0, reduced = 0;
    double ratio() const { return all > 0 ? reduced / all : 0; }
};

struct Explanation {
    Counts counts;         ///< of the view's pixels
    Assembly assembly;     ///< what is held
    std::size_t left_out;  ///< pixels of one frame whose case it does not hold
    std::size_t differing; ///< pixels whose visibility or colour is not the same, bit for bit
    Pair instructions;     ///< of the visibility kernel, optimised SPIR-V
    Pair compiler;         ///< milliseconds from GLSL to SPIR-V without a cache
    Pair driver;           ///< milliseconds from SPIR-V to the end of the first dispatch, less a later one
    Pair visibility;       ///< milliseconds of the kernel on the device
};

/// Everything is measured in turns, in this one process; medians.
Explanation explain(Renderer& renderer, const glsl::Sources& sources, const Family& family,
                    const Counts& counts, const Assembly& assembly, int frames);

std::string explanation_text(const Family& family, const Explanation& explanation);
nlohmann::ordered_json explanation_json(const Family& family, const Explanation& explanation);

/// The table of a census: number, case, count, share; of several censuses mean and deviation too.
std::string census_table(const std::vector<CaseShare>& shares, bool several);

} // namespace gnomon::cli
