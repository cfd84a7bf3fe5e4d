// Every kernel there is, by family. Nothing else lists kernels: a case is a file in kernels/ and an entry in
// its family's table.
#pragma once

#include "casegen/kernel_case.h"

#include <map>
#include <string>
#include <vector>

namespace gnomon {

struct Family {
    std::string name; ///< the folder below kernels/
    std::string what; ///< one line
    std::vector<Case> cases;
};

Family revectorize_family();     // casegen/revectorize.cpp
Family nsm_family();             // casegen/nsm.cpp
Family smsr_family();            // casegen/smsr.cpp
Family rsmss_family();           // casegen/rsmss.cpp
Family rbsm_silhouette_family(); // casegen/rbsm.cpp
Family rbsm_filter_family();

const std::vector<Family>& catalogue();

/// Cases whose name contains `pattern`, or matches it if it has *, ? or [; all for an empty one. In the
/// catalogue's order. Throws Error that suggests near names if there are none.
std::vector<const Case*> find_cases(const std::string& pattern);

/// The case of exactly this name. Throws Error that suggests near names.
const Case& find_case(const std::string& name);

/// Families with a kernel `<family>/visibility`, float (ivec2 texel, vec2 p) over a map: what --technique
/// takes.
std::vector<std::string> visibility_techniques();

/// What kernels include by <>: for each family with numbered cases `<smsr/cases>`, which includes them all
/// and defines
///     float smsr_case(uint number, …)
/// with every parameter that any of them takes, in alphabetical order; a number that is none of them gives
/// the default, lit.
std::map<std::string, std::string> generated_sources();

} // namespace gnomon
