// The first two of a hybrid technique's five steps: shadow maps, and what they are certain of.
#pragma once

#include "runtime/hybrid/left_out.h"
#include "runtime/pipeline/resources.h"
#include "runtime/pipeline/stopwatch.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace gnomon {

/// What is known of a pixel that faces the light, as kernels/hybrid/state.glslh has it. Pixels that do not
/// face it are `shadowed`.
enum class PixelState : std::uint32_t { shadowed = 0, lit = 1, uncertain = 2 };

/// What a classifier's maps took, for the frame just made.
struct MapCost {
    std::size_t triangles_emitted = 0; ///< by all passes together
    double bytes_per_texel = 0;        ///< all maps and lists over all texels
};

/// Maps and their reading. The steps are called once per frame, in this order; a frame without a pixel that
/// faces the light skips both.
class Classifier {
public:
    Classifier() = default;
    Classifier(const Classifier&) = delete;
    Classifier& operator=(const Classifier&) = delete;
    virtual ~Classifier() = default;

    /// From the resources' frame and receivers.
    virtual void create_maps() = 0;

    /// Per pixel: its PixelState into `states`, and for every pixel that is not uncertain its visibility into
    /// the resources'.
    virtual void detect(gpu::Buffer& states) = 0;

    virtual MapCost cost() const { return {}; }

    /// Whether create_maps makes anything: else there is nothing to leave out.
    virtual bool has_maps() const { return true; }

    /// What the maps of the frame just made did without, besides what every hybrid leaves out.
    virtual std::vector<LeftOut> left_out() const { return {}; }
};

/// A technique that traces rays only where its maps are uncertain.
struct HybridTechnique {
    std::string name; ///< what --technique takes: "crsm"
    std::string what; ///< one line
    /// Certain pixels are right by construction, whatever scene and light: the image is the ray tracer's.
    bool sound = false;
    std::unique_ptr<Classifier> (*make)(Resources&);
};

/// Every hybrid technique; `traced` first, which is certain of nothing: a ray for every pixel that faces the
/// light. Nothing else lists them.
const std::vector<HybridTechnique>& hybrid_techniques();

/// Null if there is none of this name.
const HybridTechnique* find_hybrid(const std::string& name);

} // namespace gnomon
