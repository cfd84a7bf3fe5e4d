// The five steps of a hybrid technique: create maps, detect uncertain, fill rays, trace, fix pixels.
// [Hertel, Hormann and Westermann 2009; the thesis' test pipeline, chapter 6]
#pragma once

#include "runtime/hybrid/classifier.h"
#include "runtime/rays.h"

#include <memory>

namespace gnomon {

/// A ray tracer that is built when a ray first needs it.
class LazyTracer {
public:
    explicit LazyTracer(const Scene& scene) : scene_(scene) {}
    /// Adds the step "build BVH" if it had to.
    const RayTracer& get(Stopwatch& watch) {
        if (!tracer_) watch.time("build BVH", [&] { tracer_ = std::make_unique<RayTracer>(scene_); });
        return *tracer_;
    }
    bool built() const { return tracer_ != nullptr; }

private:
    const Scene& scene_;
    std::unique_ptr<RayTracer> tracer_;
};

/// What one frame did.
struct HybridFrame {
    std::size_t facing = 0; ///< pixels that face the light
    std::size_t rays = 0;   ///< pixels that were uncertain, and traced
    MapCost maps;
    std::vector<LeftOut> left_out; ///< what this frame did without, in the order of the steps
};

class Hybrid {
public:
    /// `resources` and `tracer` must outlive it. Without `prune` every step is taken whether the frame needs
    /// it or not; the image is the same.
    Hybrid(Resources& resources, LazyTracer& tracer, const HybridTechnique& technique, bool prune = true);
    ~Hybrid();
    Hybrid(Hybrid&&) noexcept;
    Hybrid& operator=(Hybrid&&) noexcept;

    /// From the frame's receivers to its visibility. Steps are timed on the wall: "create maps", "detect",
    /// "fill", "trace", "fix".
    HybridFrame run(Stopwatch& watch);

    /// PixelState per pixel, row-major, of the last frame.
    std::vector<PixelState> states();

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace gnomon
