// Four kernels of one quantity, small enough to know all about: the integral of cos(k x) over a … b by three
// formulas, and one that is wrong on purpose.
#pragma once

#include "casegen/kernel_case.h"
#include "tests/support/temporary_folder.h"

#include <filesystem>
#include <vector>

namespace gnomon::testing {

/// "wave/printed": (sin kb - sin ka) / k, NaN at k = 0; "wave/sinc": by S(x) = sin x / x; "wave/series": sinc
/// with more work, no more accurate; "wave/spiked": sinc, but 1 % off where k lies in [4, 4 + 2^-10].
class SineFamily {
public:
    SineFamily();
    std::filesystem::path kernels() const { return folder_.path() / "kernels"; }
    const TemporaryFolder& folder() const { return folder_; } ///< for files beside them
    const std::vector<Case>& cases() const { return cases_; }
    std::vector<const Case*> pointers() const;
    const Case& named(const std::string& name) const;

private:
    TemporaryFolder folder_;
    std::vector<Case> cases_;
};

} // namespace gnomon::testing
