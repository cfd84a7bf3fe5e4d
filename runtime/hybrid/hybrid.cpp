#include "runtime/hybrid/hybrid.h"

#include <cstring>

namespace gnomon {

struct Hybrid::Impl {
    Resources& r;
    LazyTracer& tracer;
    std::unique_ptr<Classifier> classifier;
    gpu::Kernel count_kernel, scan_kernel, fill_kernel, fix_kernel;
    gpu::Buffer states, tile_counts, totals, rays, pixels, lit;
    std::uint32_t tiles;

    Impl(Resources& resources, LazyTracer& rays_by, const HybridTechnique& technique)
        : r(resources), tracer(rays_by), classifier(technique.make(resources)),
          count_kernel(r.kernel("hybrid/count.comp")), scan_kernel(r.kernel("hybrid/scan.comp")),
          fill_kernel(r.kernel("hybrid/fill.comp")), fix_kernel(r.kernel("hybrid/fix.comp")),
          states(r.device.allocate(r.pixels() * sizeof(std::uint32_t))),
          tiles(((r.frame.size.x + 15) / 16) * ((r.frame.size.y + 15) / 16)) {
        tile_counts = r.device.allocate(std::size_t{tiles} * sizeof(glm::uvec2));
        totals = r.device.allocate(sizeof(glm::uvec2));
    }

    /// Rays needed, pixels that face the light. Afterwards `tile_counts` says where each tile's rays begin.
    glm::uvec2 count() {
        r.device.run(count_kernel, {&r.frame_buffer, &r.receivers, &states, &tile_counts},
                     {.threads = {tiles, 1, 1}});
        r.device.run(scan_kernel, {&r.frame_buffer, &tile_counts, &totals}, {});
        return r.device.read<glm::uvec2>(totals).front();
    }

    void fill(std::uint32_t n) {
        if (pixels.size() < n * sizeof(std::uint32_t)) { // grows, never shrinks
            rays = r.device.allocate(n * sizeof(glm::vec4));
            pixels = r.device.allocate(n * sizeof(std::uint32_t));
            lit = r.device.allocate((n + 3) / 4 * sizeof(std::uint32_t));
        }
        r.device.run(fill_kernel, {&r.frame_buffer, &r.receivers, &states, &tile_counts, &rays, &pixels},
                     {.threads = {tiles, 1, 1}});
    }

    std::vector<std::uint8_t> trace(std::uint32_t n, const RayTracer& rays_by) {
        const gpu::HostView<glm::vec4> view = r.device.view<glm::vec4>(rays, n);
        const std::span<const glm::vec4> origins = view.values;
        const glm::vec3 light(r.frame.light_origin);
        return r.frame.light_origin.w == 1.0f ? rays_by.visible_from(origins, light, r.frame.eye.w)
                                              : rays_by.visible_along(origins, light, r.frame.eye.w);
    }
};

Hybrid::Hybrid(Resources& resources, LazyTracer& tracer, const HybridTechnique& technique)
    : impl_(std::make_unique<Impl>(resources, tracer, technique)) {}
Hybrid::~Hybrid() = default;
Hybrid::Hybrid(Hybrid&&) noexcept = default;
Hybrid& Hybrid::operator=(Hybrid&&) noexcept = default;

HybridFrame Hybrid::run(Stopwatch& watch) {
    Impl& h = *impl_;
    watch.time("create maps", [&] { h.classifier->create_maps(); });
    watch.time("detect", [&] { h.classifier->detect(h.states); });
    glm::uvec2 counts(0);
    watch.time("fill", [&] {
        counts = h.count();
        if (counts.x > 0) h.fill(counts.x);
    });
    if (counts.x > 0) {
        const RayTracer& tracer = h.tracer.get(watch);
        std::vector<std::uint8_t> lit;
        watch.time("trace", [&] { lit = h.trace(counts.x, tracer); });
        watch.time("fix", [&] {
            h.r.device.write(h.lit, std::as_bytes(std::span(lit)));
            gpu::Dispatch per_ray = Resources::linear(counts.x);
            per_ray.constants = gpu::bytes_of(counts.x);
            h.r.device.run(h.fix_kernel, {&h.pixels, &h.lit, &h.r.visibility}, per_ray);
        });
    }
    return {counts.y, counts.x, h.classifier->cost()};
}

std::vector<PixelState> Hybrid::states() { return impl_->r.device.read<PixelState>(impl_->states); }

} // namespace gnomon
