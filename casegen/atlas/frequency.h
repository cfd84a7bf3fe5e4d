// How often each case is met: in the corpus of masks, or wherever somebody has counted.
#pragma once

#include "casegen/catalogue.h"
#include "casegen/sampling.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace gnomon::atlas {

/// One case among the edge texels of a corpus, shadowed ones included. A mask's share is the part of its edge
/// texels that the case applies to; masks without an edge have none.
struct CorpusShare {
    double overall = 0;             ///< of all edge texels together
    double mean = 0, deviation = 0; ///< of the masks' shares; standard deviation
    std::vector<double> by_family;  ///< the mean of each of mask_families()'s masks, in that order
};

CorpusShare corpus_share(const Case& c, const EdgePool& pool);

/// What was counted elsewhere: family, then the case's number, then its share in [0,1].
struct Census {
    std::string where; ///< "demo scene", as the page says it
    std::map<std::string, std::map<unsigned, double>> shares;
};

/// { "smsr": { "9": 0.121, … }, … }, by itself or as the member "shares" (as gnomon census writes it).
/// `where` is the file's name without extension. Families and numbers that the catalogue lacks are an Error,
/// as is a share outside [0,1].
Census read_census(const std::filesystem::path& path);

} // namespace gnomon::atlas
