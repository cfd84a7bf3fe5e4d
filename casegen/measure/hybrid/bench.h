// Hybrid techniques against a ray for every pixel: time, rays, memory, and whether the image is right.
#pragma once

#include "casegen/measure/hybrid/break_even.h"
#include "runtime/pipeline/renderer.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace gnomon::measure {

/// What the first hybrid technique is called here: a ray for every pixel that faces the light, in packets of
/// 16.
constexpr const char* raytraced_name = "raytraced";
/// The technique that chooses among the exact ones.
constexpr const char* auto_name = "auto";

struct HybridBenchOptions {
    std::vector<std::pair<int, int>> sizes; ///< viewports, in pixels
    std::vector<int> shadow_maps;           ///< texels on a side
    /// Names from hybrid_techniques(), and auto_name; empty: all of them. raytraced is always measured,
    /// first.
    std::vector<std::string> techniques;
    int rounds = 5; ///< one more is discarded
};

/// One technique in one combination of viewport and shadow map.
struct HybridRow {
    std::string technique;
    bool exact = false; ///< it promises the ray tracer's image
    TechniqueTimes times;
    std::size_t wrong = 0; ///< pixels whose visibility is not the ray tracer's
    double break_even = 0; ///< nanoseconds per ray; of raytraced itself 0
    FrameCost cost() const;
    double uncertain_share() const; ///< rays over pixels that face the light; 0 without any
    double wrong_share() const;     ///< of pixels that face the light
};

struct HybridCombination {
    int width = 0, height = 0, shadow_map = 0;
    std::size_t facing = 0;      ///< pixels that face the light
    double bvh = 0;              ///< milliseconds to build it, once for all techniques
    std::vector<HybridRow> rows; ///< raytraced first
    std::optional<Choice> choice;
    /// The row of an exact technique other than auto that took least.
    const HybridRow& best_exact() const;
    const HybridRow* automatic() const; ///< null if it was not asked for
};

struct HybridBench {
    std::string machine, scene;
    std::size_t triangles = 0;
    int rounds = 0;
    std::vector<HybridCombination> combinations;
};

/// A technique as tables call it.
std::string shown_name(const std::string& technique);

/// Throws Error if a name is not a technique.
void require_hybrids(const std::vector<std::string>& names);

/// Times one combination: the choice of auto first, then all techniques in turns over one G-buffer.
HybridCombination measure_combination(Renderer& renderer, const HybridBenchOptions& options);

/// Every exact row whose image is not the ray tracer's, one line each: empty if all keep their promise.
std::vector<std::string> broken_promises(const HybridBench& bench);

} // namespace gnomon::measure
