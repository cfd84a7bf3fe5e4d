// One case's part of the page.
#pragma once

#include "casegen/atlas/atlas.h"

#include <string>

namespace gnomon::atlas {

/// What the entries of a page have in common.
struct PageContext {
    const Atlas& atlas;
    std::string kernels, replay; ///< see page()
    double widest_share = 1;     ///< the share that fills a bar
};

std::string entry_html(const Entry& entry, const PageContext& context);

/// "smsr-case_09": names an element.
std::string element_id(const std::string& name);

std::string verdict_html(const CheckReport& report);

/// Why a kernel fails: message, call, got and wanted, replay; empty if it passes.
std::string failure_html(const CheckReport& report, const std::string& replay);

/// "0", "5.96e-08", "none finite", or a dash if the kernel never ran.
std::string worst_error(const CheckReport& report);
/// "12.3" in an element that marks what differs from run to run.
std::string nanoseconds_html(const CheckReport& report);

/// "constant", "step" or "ramp": what the reference does over the witness texel; "" without a witness.
std::string kind_of(const Entry& entry);
/// "lit", "shadowed" or "both": the texels that the condition asks for.
std::string light_of(const Case& c);

} // namespace gnomon::atlas
