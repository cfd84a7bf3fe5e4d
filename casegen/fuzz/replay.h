// What chains once got wrong, again: the part of a check that no kernel's own samples are.
#pragma once

#include "casegen/check.h"
#include "casegen/worker_device.h"

#include <span>
#include <vector>

namespace gnomon::fuzz {

/// Those of the chains (see find_chains) that have regressions on file.
std::vector<const Case*> with_regressions(std::span<const Case* const> chains,
                                          const std::filesystem::path& regressions);

/// A report for each chain over all of its regressions, one after the other on `device`, which has been
/// restarted if one of them hung it. Throws Error as check does.
std::vector<CheckReport> replay(std::span<const Case* const> chains, const CheckOptions& options,
                                WorkerDevice& device);

} // namespace gnomon::fuzz
