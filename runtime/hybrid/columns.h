// The lists of triangles over and under each texel that holds a receiver: one conservative pass over the
// scene, every triangle of either facing once.
#pragma once

#include "runtime/hybrid/column_space.h"
#include "runtime/pipeline/resources.h"
#include "runtime/pipeline/seen.h"

namespace gnomon {

class Columns {
public:
    /// Throws Error for a perspective light.
    explicit Columns(Resources& resources);

    /// For the frame and receivers of now.
    void build();

    std::size_t nodes() const { return node_count_; } ///< entries of all lists together
    std::size_t bytes() const;                        ///< of slots and lists

    // What detectors bind (kernels/hybrid/detect.glslh).
    gpu::Buffer space, places, slots, farthest, heads, nodes_buffer, rings;

private:
    Resources& r_;
    SeenBounds seen_;
    gpu::Kernel clear_, mark_, bin_, fill_;
    gpu::Buffer bin_farthest_, masks_, counters_, pairs_;
    std::size_t node_count_ = 0, node_capacity_ = 0, pair_capacity_ = 0;
    bool incomplete_ = false; ///< the driver left a loop: lists lack entries
    shared::ColumnSpace host_space_{};
    bool bin_all(); ///< false: there was too little room, now there is enough
};

} // namespace gnomon
