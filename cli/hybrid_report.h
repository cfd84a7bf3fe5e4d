// What is said of one hybrid rendering: rays, maps, what was left out and why, what an automatic one chose.
#pragma once

#include "runtime/pipeline/renderer.h"

#include <nlohmann/json.hpp>

#include <string>

namespace gnomon::cli {

/// Of a rendering that has `hybrid`.
std::string hybrid_text(const Rendering& rendering, bool prune);
nlohmann::ordered_json hybrid_json(const Rendering& rendering, bool prune);

} // namespace gnomon::cli
