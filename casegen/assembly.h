// How a family's numbered cases become one function, as data: in which order their conditions are asked, in
// what shape of code, and which cases there are at all. Every assembly that holds all cases gives the same
// bits; one that leaves some out says so at the texels that would have needed them.
#pragma once

#include <string>
#include <vector>

namespace gnomon {

struct Case;
struct Family;

enum class Variant {
    switch_by_number, ///< the family's decision list says the number; nothing else looks at the edge
    document_order,   ///< if (condition) return case, in the order of the numbers
    frequency_order,  ///< the same in the order of Assembly::cases
    branch_tree,      ///< lit or shadowed first, then whether an axis has BOTH, then as frequency_order
    branchless,       ///< every case is evaluated, the one whose condition holds is kept
    table,            ///< light, sides, types and dominance index a constant array of numbers; then a switch
};

/// "switch", "document", "frequency", "tree", "branchless", "table"; and all variants.
const char* to_string(Variant variant);
const std::vector<Variant>& all_variants();

struct Assembly {
    Variant variant = Variant::switch_by_number;
    /// The numbers that it holds, in the order in which they are asked; empty: all, ascending. 0 stands for
    /// "no case", which needs no code: {0} holds nothing.
    std::vector<unsigned> cases{};
    /// The function adds to a global `uint conditions_tested` how many conditions it asked.
    bool count_tests = false;
};

/// Cases with a number, ascending; those that the assembly holds, in its order; and the others, ascending.
/// The latter two throw Error if it names a number that the family does not have.
std::vector<const Case*> numbered_cases(const Family& family);
std::vector<const Case*> held_cases(const Family& family, const Assembly& assembly);
std::vector<const Case*> left_out_cases(const Family& family, const Assembly& assembly);

/// Parameters of any of the family's cases: the name and the GLSL type, alphabetical, so that a new case
/// moves nothing.
struct CaseParameter {
    std::string name, type;
    bool needed = false; ///< a case that the assembly holds takes it
};
std::vector<CaseParameter> case_parameters(const Family& family, const Assembly& assembly);

/// The text of <smsr/cases>: includes the cases that the assembly holds and defines
///     const bool smsr_needs_along_x = true;
///     float smsr_case(uint number, Edge edge, float along_x, …)
/// with a constant per parameter: whether a held case takes it. A texel of no case (number 0) gives its
/// shadow test. So does one whose case is left out, and it sets `case_left_out`
/// (kernels/revectorize/left_out.glslh).
std::string assembled(const Family& family, const Assembly& assembly);

} // namespace gnomon
