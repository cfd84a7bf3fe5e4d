#include "runtime/hybrid/hybrid.h"

#include "runtime/hybrid/facing.h"

#include <algorithm>
#include <cstring>

namespace gnomon {
namespace {

std::vector<LeftOut> nothing_faces_the_light() {
    const std::string why = "no pixel faces the light: none reads a map";
    return {{"create maps", "all of them", why},
            {"detect", "all but clearing", why},
            {"fill", "the ray buffer", why},
            {"trace", "rays, and the BVH if no other frame needed it", why},
            {"fix", "all of it", why}};
}

} // namespace

struct Hybrid::Impl {
    Resources& r;
    LazyTracer& tracer;
    std::unique_ptr<Classifier> classifier;
    bool prune;
    FacingTest facing;
    gpu::Kernel count_kernel, scan_kernel, fill_kernel, fix_kernel;
    gpu::Buffer states, tile_counts, totals, rays, pixels, lit;
    std::uint32_t tiles;

    Impl(Resources& resources, LazyTracer& rays_by, const HybridTechnique& technique, bool leave_out)
        : r(resources), tracer(rays_by), classifier(technique.make(resources)), prune(leave_out),
          facing(resources), count_kernel(r.kernel("hybrid/count.comp")),
          scan_kernel(r.kernel("hybrid/scan.comp")), fill_kernel(r.kernel("hybrid/fill.comp")),
          fix_kernel(r.kernel("hybrid/fix.comp")),
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

    /// For `rays_needed`; buffers of no size are none, so there is always room for one.
    void fill(std::uint32_t rays_needed) {
        const std::uint32_t n = std::max(rays_needed, 1u);
        if (pixels.size() < n * sizeof(std::uint32_t)) { // grows, never shrinks
            rays = r.device.allocate(n * sizeof(glm::vec4));
            pixels = r.device.allocate(n * sizeof(std::uint32_t));
            lit = r.device.allocate((n + 3) / 4 * sizeof(std::uint32_t));
        }
        r.device.run(fill_kernel, {&r.frame_buffer, &r.receivers, &states, &tile_counts, &rays, &pixels},
                     {.threads = {tiles, 1, 1}});
    }

    void fix(std::span<const std::uint8_t> found) {
        if (!found.empty()) r.device.write(lit, std::as_bytes(found));
        const auto n = static_cast<std::uint32_t>(found.size());
        gpu::Dispatch per_ray = Resources::linear(std::max(n, 1u));
        per_ray.constants = gpu::bytes_of(n);
        r.device.run(fix_kernel, {&pixels, &lit, &r.visibility}, per_ray);
    }

    /// What detection would find where no pixel faces the light, without asking a map.
    void all_shadowed() {
        static_assert(static_cast<std::uint32_t>(PixelState::shadowed) == 0);
        const std::vector<std::uint32_t> zeros(r.pixels());
        r.device.write(states, std::as_bytes(std::span(zeros)));
        r.device.write(r.visibility, std::as_bytes(std::span(zeros))); // 0.0f as well
    }

    std::vector<std::uint8_t> trace(std::uint32_t n, const RayTracer& rays_by) {
        const gpu::HostView<glm::vec4> view = r.device.view<glm::vec4>(rays, n);
        const std::span<const glm::vec4> origins = view.values;
        const glm::vec3 light(r.frame.light_origin);
        return r.frame.light_origin.w == 1.0f ? rays_by.visible_from(origins, light, r.frame.eye.w)
                                              : rays_by.visible_along(origins, light, r.frame.eye.w);
    }
};

Hybrid::Hybrid(Resources& resources, LazyTracer& tracer, const HybridTechnique& technique, bool prune)
    : impl_(std::make_unique<Impl>(resources, tracer, technique, prune)) {}
Hybrid::~Hybrid() = default;
Hybrid::Hybrid(Hybrid&&) noexcept = default;
Hybrid& Hybrid::operator=(Hybrid&&) noexcept = default;

HybridFrame Hybrid::run(Stopwatch& watch) {
    Impl& h = *impl_;
    HybridFrame frame;
    // Asked only where the answer can spare more than a dispatch.
    bool any_facing = true;
    watch.time("create maps", [&] {
        if (h.prune && h.classifier->has_maps()) any_facing = h.facing.any();
        if (any_facing) h.classifier->create_maps();
    });
    if (!any_facing) {
        watch.time("detect", [&] { h.all_shadowed(); });
        frame.left_out = nothing_faces_the_light();
        return frame;
    }
    frame.left_out = h.classifier->left_out();
    watch.time("detect", [&] { h.classifier->detect(h.states); });
    glm::uvec2 counts(0);
    watch.time("fill", [&] {
        counts = h.count();
        if (counts.x > 0 || !h.prune) h.fill(counts.x);
    });
    frame.rays = counts.x;
    frame.facing = counts.y;
    frame.maps = h.classifier->cost();
    if (counts.x == 0 && h.prune) {
        const std::string why =
            counts.y == 0 ? "no pixel faces the light" : "no pixel that faces the light is uncertain";
        frame.left_out.push_back({"fill", "the ray buffer", why});
        frame.left_out.push_back({"trace", "rays, and the BVH if no other frame needed it", why});
        frame.left_out.push_back({"fix", "all of it", why});
        return frame;
    }
    const RayTracer& tracer = h.tracer.get(watch);
    std::vector<std::uint8_t> lit;
    watch.time("trace", [&] { lit = h.trace(counts.x, tracer); });
    watch.time("fix", [&] { h.fix(lit); });
    return frame;
}

std::vector<PixelState> Hybrid::states() { return impl_->r.device.read<PixelState>(impl_->states); }

} // namespace gnomon
