// Renderings and what is said of them: shared by render and demo.
#pragma once

#include "runtime/pipeline/judge.h"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace gnomon::cli {

/// none, every family with a visibility kernel, raytraced, every hybrid, and auto, the fastest exact one.
std::vector<std::string> technique_names();
Technique technique_by_name(const std::string& name);

struct Judged {
    std::string technique;
    Rendering rendering;
    PixelCounts counts;
    double visibility_milliseconds()
        const; ///< of the steps that are the technique's own: map and visibility, or rays
};

/// Text: one row per technique, error beside time.
std::string judged_table(const std::vector<Judged>& all);

nlohmann::ordered_json judged_json(const Judged& judged);
nlohmann::ordered_json view_json(const Camera& camera, const Light& light, const ViewSettings& settings);

} // namespace gnomon::cli
