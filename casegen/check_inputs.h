// The inputs that a check runs on, for those who look at a kernel on the same ones.
#pragma once

#include "casegen/check.h"
#include "casegen/sampling.h"

#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace gnomon {

/// Of a check of `c`: with `regressions`, its worst inputs and its pins. Throws Error as Sampler does.
Sampler make_sampler(const Case& c, const CheckOptions& options, const std::shared_ptr<const EdgePool>& pool,
                     std::span<const CsvInput> regressions);

/// The regressions of every kernel in `cases`, be it none, by its name. Throws Error as
/// fuzz::load_regressions does.
std::map<std::string, std::vector<CsvInput>> load_inputs_of_regressions(std::span<const Case* const> cases,
                                                                        const CheckOptions& options);

} // namespace gnomon
