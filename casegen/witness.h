// The smallest mask that leads to a case, or to one way through it: its picture, its proof that it can
// happen, and a test's input.
#pragma once

#include "casegen/catalogue.h"

#include <optional>
#include <string>
#include <vector>

namespace gnomon {

struct Witness {
    Mask mask;
    glm::ivec2 texel{0};
};

/// Searches all masks in order of their texel count (then width), all surrounds (lit, shadow, clamp), all
/// texels; the first at which the case applies. Nothing if none of at most `most_texels` does. The case must
/// have a condition.
std::optional<Witness> smallest_witness(const Case& c, int most_texels = 12);

/// One way through a numbered case: the values of those of its parameters that are not numbers within a texel
/// or along a run (sides, ends, neighbours, the breach).
struct Branch {
    const Case* kernel = nullptr;
    std::vector<std::pair<std::string, int>> facts; ///< by parameter and component
    friend bool operator==(const Branch&, const Branch&) = default;
    friend auto operator<=>(const Branch& a, const Branch& b) {
        return a.kernel->number != b.kernel->number ? a.kernel->number <=> b.kernel->number
                                                    : a.facts <=> b.facts;
    }
};

/// "rsmss/case_12 side_y=1 type_y=0 neighbour=3 breach=1".
std::string to_string(const Branch& branch);

/// The way that the texel takes through its family's cases; nothing if none applies.
std::optional<Branch> branch_of(const Family& family, const Mask& mask, glm::ivec2 texel);

struct BranchWitness {
    Branch branch;
    Witness witness;
};

/// "rsmss/case_12 side_y=1 …: lit 0,1 #./..": the branch, what lies outside, the texel, the mask's rows.
std::string to_string(const BranchWitness& found);

/// The first witness, in smallest_witness's order, of every branch that masks of so many texels, and so many
/// on a side, reach; in order of branches.
std::vector<BranchWitness> branch_witnesses(const Family& family, int most_texels = 12, int most_side = 4);

} // namespace gnomon
