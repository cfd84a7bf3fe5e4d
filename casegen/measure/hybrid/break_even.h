// How dear a ray must be before a hybrid pays.
#pragma once

#include <cstddef>

namespace gnomon::measure {

/// What a frame took, apart from building the BVH.
struct FrameCost {
    double milliseconds = 0;       ///< the whole frame, from maps to fixed pixels
    double trace_milliseconds = 0; ///< of it, tracing
    std::size_t rays = 0;
    /// Everything but tracing: the technique's own overhead.
    double overhead() const { return milliseconds - trace_milliseconds; }
    /// Nanoseconds that one ray took; 0 without any.
    double per_ray() const { return rays == 0 ? 0 : 1e6 * trace_milliseconds / static_cast<double>(rays); }
};

/// The cost of one ray, in nanoseconds, above which the hybrid is faster than a ray for every pixel:
///     (overhead of the hybrid - overhead of tracing everything) / rays saved.
/// It takes every ray to cost the same. 0 if the hybrid has no more overhead and traces no more; infinity if
/// it saves no ray for what it costs.
double break_even_nanoseconds(const FrameCost& hybrid, const FrameCost& raytraced);

} // namespace gnomon::measure
