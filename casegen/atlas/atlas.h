// What a page about the catalogue says of each kernel, computed once: pictures, values, counts, verdicts.
#pragma once

#include "casegen/atlas/frequency.h"
#include "casegen/atlas/values.h"
#include "casegen/check.h"
#include "casegen/coverage/measure.h"
#include "casegen/witness.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::atlas {

struct Options {
    CheckOptions check;
    std::vector<Census> censuses;               ///< shown beside what the corpus says
    std::optional<coverage::Coverage> coverage; ///< what is shown of it: each case's own file
};

/// One way through a case: what its kernel reads of the surroundings, and the smallest mask for it.
struct Way {
    std::string facts; ///< "side_y=1 neighbour=2"
    Witness witness;
    std::optional<Image> revectorized;
};

/// A case that its family's decision list numbers.
struct Entry {
    const Case* kernel = nullptr;
    CheckReport report;
    std::string text;                               ///< of the kernel's file; empty if it cannot be read
    std::string comment;                            ///< the one that it begins with
    std::optional<coverage::FileCoverage> coverage; ///< of its file, if that was measured
    std::optional<Witness>
        witness; ///< the smallest at which the reference varies over the texel, if any does
    std::optional<ValueMap> values;    ///< over the witness texel
    std::optional<Image> revectorized; ///< the whole witness, by the family's assembled kernel
    std::vector<Way> ways;
    CorpusShare share;
    std::string trouble; ///< why something of this is missing, if the report does not say
};

struct FamilyEntries {
    const Family* family = nullptr;
    std::vector<Entry> cases;         ///< those with a number, by it
    std::vector<CheckReport> kernels; ///< the others
    std::string trouble;              ///< why its assembled kernel has no pictures
};

struct Atlas {
    std::string device;
    std::optional<std::size_t> samples; ///< per kernel, if that was asked for
    std::uint64_t masks_seed = 0;
    bool own_seeds = true; ///< each kernel's seed is its name's hash
    std::size_t masks = 0, edge_texels = 0;
    std::vector<Census> censuses;
    std::optional<coverage::Totals> coverage; ///< of all files, if they were measured
    std::vector<FamilyEntries> families;

    bool passes() const; ///< every kernel does
};

/// Checks every kernel of `families`, then runs those of the numbered cases over their witnesses. A kernel
/// that fails is an entry that says so. `done` is told of the samples checked so far. Throws Error as check()
/// does.
Atlas make_atlas(const std::vector<Family>& families, const Options& options,
                 const std::function<void(std::size_t)>& done = {});

} // namespace gnomon::atlas
