// Every kernel there is, by family. Nothing else lists kernels: a case is a file in kernels/ and an entry in
// its family's table.
#pragma once

#include "casegen/assembly.h"
#include "casegen/kernel_case.h"

#include <map>
#include <string>
#include <vector>

namespace gnomon {

struct Family {
    std::string name; ///< the folder below kernels/: "smsr", "rbsm/filter"
    std::string what; ///< one line
    std::vector<Case> cases;
};

Family revectorize_family();     // casegen/revectorize.cpp
Family nsm_family();             // casegen/nsm.cpp
Family smsr_family();            // casegen/smsr.cpp
Family rsmss_family();           // casegen/rsmss.cpp
Family rbsm_silhouette_family(); // casegen/rbsm.cpp
Family rbsm_filter_family();
Family conservative_family();            // casegen/conservative.cpp
Family adjacency_family();               // casegen/adjacency.cpp
Family certainty_family();               // casegen/certainty.cpp
Family column_family();                  // casegen/column.cpp
std::vector<Family> integral_families(); // casegen/integral/

const std::vector<Family>& catalogue();

/// Cases that `patterns` name (see pattern.h), each once, in the catalogue's order. Throws Error as
/// split_patterns, and one that suggests near names if a pattern names nothing.
std::vector<const Case*> find_cases(const std::string& patterns);

/// The number of the family's case whose condition holds for the edge; 0 if none does, 99 if several do: no
/// decision list says that, so that whoever compares sees it.
unsigned number_by_conditions(const Family& family, const reference::Edge& edge);

/// The case of exactly this name. Throws Error that suggests near names.
const Case& find_case(const std::string& name);

/// "rbsm_filter": how the names of the family's functions begin.
std::string identifier(const Family& family);

/// "rbsm-filter": what --technique calls it.
std::string technique_name(const Family& family);

/// What --technique takes: families with a kernel `<family>/visibility`, float (ivec2 texel, vec2 p) over a
/// map.
std::vector<std::string> visibility_techniques();

/// Those of them that have a kernel `<family>/number` too, uint (ivec2 texel): the case at a texel.
std::vector<std::string> numbered_techniques();

/// The family of a technique. Throws Error if there is none of this name.
const Family& technique_family(const std::string& technique);

/// The family's kernel of this name behind the /; null if it has none.
const Case* find_kernel(const Family& family, const std::string& name);

/// What kernels include by <>: for each family with numbered cases `<smsr/cases>`, which chooses among them
/// (see assembled()). `assemblies` by the family's name; families that are not named hold all their cases in
/// a switch. Throws Error if one names a family without numbered cases.
std::map<std::string, std::string> generated_sources(const std::map<std::string, Assembly>& assemblies = {});

} // namespace gnomon
