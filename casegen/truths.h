// The truths that a kernel's results are judged by. They are slow, so they are computed once: by a process
// for all the kernels of a quantity, and by all processes through files in the cache folder.
#pragma once

#include "casegen/standalone.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon {

/// Truths on disk. A file holds one chunk of records of one quantity, named by the hash of what it is about
/// and holding all of it: what the hash does not tell apart, the comparison does. A file that is damaged, cut
/// short or about something else is as good as none, and a folder that cannot be written costs time only.
struct TruthFiles {
    std::filesystem::path folder; ///< empty: none are read or written
    /// Of everything that a truth's bits depend on besides its inputs: another one, other files.
    std::string fingerprint;
};
/// In the cache folder; by the sources of the references, the libraries they use and the compiler.
TruthFiles default_truth_files();

constexpr std::size_t records_per_truth_file = 512;

/// One per record, empty where the record is outside the case's domain; nothing at all if the case's
/// reference has no truth. The same bits whatever was cached and however many threads there are.
std::vector<Truth> truths(const Case& c, const Records& records,
                          const TruthFiles& files = default_truth_files());

/// Forgets what this process has computed, but not the files. For tests.
void forget_truths();

} // namespace gnomon
