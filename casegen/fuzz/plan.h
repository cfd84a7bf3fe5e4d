// Which units a campaign consists of: a round is one unit of every kernel, in the kernels' order.
#pragma once

#include "casegen/fuzz/unit.h"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace gnomon::fuzz {

struct Plan {
    std::vector<const Case*> cases;
    std::vector<std::size_t> sizes;      ///< evaluations of each one's units
    std::optional<std::uint64_t> rounds; ///< without end if there are none

    std::optional<std::uint64_t> units() const {
        return rounds ? std::optional(*rounds * cases.size()) : std::nullopt;
    }
    std::size_t kernel_of(std::uint64_t unit) const { return static_cast<std::size_t>(unit % cases.size()); }
    std::uint64_t round_of(std::uint64_t unit) const { return unit / cases.size(); }
};

/// Of at least so many evaluations, and less than a round more; the fixed samples of the first round come on
/// top.
Plan make_plan(std::span<const Case* const> cases, std::optional<std::uint64_t> samples);

} // namespace gnomon::fuzz
