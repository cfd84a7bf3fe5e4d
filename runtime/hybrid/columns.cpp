#include "runtime/hybrid/columns.h"

#include "runtime/adjacency.h"
#include "runtime/error.h"

#include <algorithm>
#include <cmath>

namespace gnomon {
namespace {

/// Texels on a side of a bin: small enough to tell where receivers are, and no more than 64 bins across, all
/// of which one thread may have to walk.
std::uint32_t bin_side(std::uint32_t map) { return std::max(8u, (map + 63) / 64); }

constexpr std::size_t node_bytes = 12; // kernels/hybrid/node.glslh

/// Entries that a pixel reads of a list, and all pixels together.
constexpr std::uint32_t longest_list = 2048;
constexpr double most_turns = 1 << 24;

struct Counters {
    std::uint32_t nodes = 0, pairs = 0, incomplete = 0;
};

} // namespace

Columns::Columns(Resources& resources)
    : r_(resources), seen_(resources), clear_(resources.kernel("hybrid/clear.comp")),
      mark_(resources.kernel("hybrid/mark.comp")), bin_(resources.kernel("hybrid/bin.comp")),
      fill_(resources.kernel("hybrid/fill_lists.comp")) {
    if (r_.frame.light_origin.w == 1.0f)
        throw Error(
            "columns need a directional light; leave --light-position out, or take another technique");
    const std::size_t side = r_.frame.size.z,
                      bins = (side + bin_side(r_.frame.size.z) - 1) / bin_side(r_.frame.size.z);
    space = r_.device.allocate(sizeof(shared::ColumnSpace));
    places = r_.device.allocate(r_.scene.positions.size() * sizeof(glm::vec4));
    slots = r_.device.allocate(side * side * sizeof(std::uint32_t));
    farthest = r_.device.allocate(r_.pixels() * sizeof(std::uint32_t));
    heads = r_.device.allocate(r_.pixels() * sizeof(std::uint32_t));
    rings = r_.device.upload(make_adjacency(r_.scene).next);
    bin_farthest_ = r_.device.allocate(bins * bins * sizeof(std::uint32_t));
    masks_ = r_.device.allocate((side + 7) / 8 * ((side + 3) / 4) * sizeof(std::uint32_t));
    counters_ = r_.device.allocate(sizeof(Counters));
    node_capacity_ = std::max<std::size_t>(1 << 16, 4 * r_.scene.triangles.size());
    pair_capacity_ = std::max<std::size_t>(1 << 14, 2 * bins * bins);
    nodes_buffer = r_.device.allocate(node_capacity_ * node_bytes);
    pairs_ = r_.device.allocate(pair_capacity_ * sizeof(glm::uvec2));
}

bool Columns::bin_all() {
    host_space_.size = {r_.frame.size.z, static_cast<std::uint32_t>(r_.scene.triangles.size()),
                        static_cast<std::uint32_t>(node_capacity_),
                        static_cast<std::uint32_t>(pair_capacity_)};
    const std::uint32_t bin = bin_side(r_.frame.size.z);
    host_space_.bins = {bin, (r_.frame.size.z + bin - 1) / bin, longest_list, 0};
    r_.device.write(space, gpu::bytes_of(host_space_));
    const std::size_t texels = std::size_t{r_.frame.size.z} * r_.frame.size.z;
    const auto pixels = static_cast<std::uint32_t>(r_.pixels());
    gpu::Dispatch clear = Resources::linear(std::max<std::size_t>(texels, pixels));
    clear.constants = gpu::bytes_of(pixels);
    r_.device.run(clear_, {&space, &slots, &bin_farthest_, &masks_, &farthest, &heads}, clear);
    r_.device.run(mark_,
                  {&space, &r_.frame_buffer, &r_.receivers, &slots, &farthest, &bin_farthest_, &masks_},
                  r_.per_pixel());
    const Counters none;
    r_.device.write(counters_, gpu::bytes_of(none));
    r_.device.run(bin_,
                  {&space, &places, &r_.triangles, &slots, &farthest, &bin_farthest_, &heads, &nodes_buffer,
                   &counters_, &masks_, &pairs_},
                  Resources::linear(host_space_.size.y));
    Counters counted = r_.device.read<Counters>(counters_).front();
    if (counted.pairs > 0 && counted.pairs <= pair_capacity_)
        r_.device.run(fill_,
                      {&space, &places, &r_.triangles, &slots, &farthest, &bin_farthest_, &heads,
                       &nodes_buffer, &counters_, &masks_, &pairs_},
                      Resources::linear(counted.pairs));
    counted = r_.device.read<Counters>(counters_).front();
    node_count_ = counted.nodes;
    incomplete_ = counted.incomplete != 0;
    if (counted.nodes <= node_capacity_ && counted.pairs <= pair_capacity_) return true;
    // Room for what was asked, and a little for the next frame. The counts are exact where the pairs fitted.
    if (counted.pairs > pair_capacity_) {
        pair_capacity_ = counted.pairs + counted.pairs / 4;
        pairs_ = r_.device.allocate(pair_capacity_ * sizeof(glm::uvec2));
    }
    if (counted.nodes > node_capacity_) {
        node_capacity_ = counted.nodes + counted.nodes / 4;
        nodes_buffer = r_.device.allocate(node_capacity_ * node_bytes);
    }
    return false;
}

void Columns::build() {
    if (!r_.seen)
        if (const std::optional<Seen> found = seen_.find()) r_.seen = found->world;
    node_count_ = 0;
    if (!r_.seen) { // no pixel asks: no slot is a texel's, and whatever goes through slots finds none
        const std::vector<std::uint32_t> none(r_.pixels());
        r_.device.write(farthest, std::as_bytes(std::span(none)));
        return;
    }
    host_space_ = column_space(r_.frame, *r_.seen);
    r_.device.write(places, std::as_bytes(std::span<const glm::vec4>(column_places(host_space_, r_.scene))));
    while (!bin_all()) {}
    // Few texels under many pixels, or very many triangles: reading lists would take longer than any ray.
    const double pixels = static_cast<double>(r_.pixels()), texels = std::pow(r_.frame.size.z, 2);
    if (static_cast<double>(node_count_) * std::max(1.0, pixels / texels) > most_turns) {
        host_space_.bins.z = static_cast<std::uint32_t>(std::max(16.0, most_turns / pixels));
    }
    host_space_.bins.w = incomplete_ ? 1 : 0; // then no column says anything
    r_.device.write(space, gpu::bytes_of(host_space_));
}

std::size_t Columns::bytes() const {
    return slots.size() + farthest.size() + heads.size() + node_count_ * node_bytes;
}

} // namespace gnomon
