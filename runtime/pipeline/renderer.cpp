#include "runtime/pipeline/renderer.h"

#include "runtime/error.h"
#include "runtime/hybrid/hybrid.h"
#include "runtime/pipeline/resources.h"
#include "runtime/pipeline/seen.h"

#include <algorithm>
#include <chrono>
#include <cstring>
#include <map>
#include <set>

namespace gnomon {
namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

} // namespace

struct Renderer::Impl : Resources {
    gpu::Target world, shading_normal, depth, shadow_depth;
    gpu::Raster gbuffer, shadow_map;
    gpu::Kernel receivers_kernel, shade_kernel;
    std::optional<SeenBounds> seen_bounds;
    ViewSettings settings;
    shared::Frame wide; // the frame before its map is fitted to the visible points
    std::map<std::string, gpu::Kernel> visibility_kernels; // by technique and its texts
    LazyTracer tracer;
    std::map<std::string, Hybrid> hybrids;
    std::set<std::string> classified; // hybrids whose states are of this camera and light

    gpu::Buffer depth_texels, left_out, colours;
    HybridFrame hybrid_frame;     // of the last frame
    std::optional<Choice> choice; // of automatic techniques, once one was asked for
    std::vector<shared::Receiver> host_receivers;
    Surfaces host_surfaces;

    Impl(gpu::Device& on, glsl::Sources from, const Scene& of, const Camera& camera, const Light& light,
         const ViewSettings& with)
        : Resources{on, std::move(from), of, make_frame(camera, light, with, of.bounds()),
                    static_cast<std::uint32_t>(3 * of.triangles.size())},
          settings(with), wide(frame), tracer(of) {
        constexpr std::size_t most = (std::size_t{1} << 24) - 1;
        if (scene.triangles.size() > most)
            throw Error("{}: {} triangles; the G-buffer counts to {}", scene.name, scene.triangles.size(),
                        most);
        frame_buffer = device.upload(std::span<const shared::Frame>(&frame, 1));
        positions = device.upload(scene.positions);
        normals = device.upload(scene.normals);
        triangles = device.upload(scene.triangles);

        const auto width = frame.size.x, height = frame.size.y, side = frame.size.z;
        world = device.target(width, height, gpu::Format::rgba32_float);
        shading_normal = device.target(width, height, gpu::Format::rgba32_float);
        depth = device.target(width, height, gpu::Format::depth32_float);
        shadow_depth = device.target(side, side, gpu::Format::depth32_float);
        gbuffer = device.raster(stage("gbuffer.vert"), stage("gbuffer.frag"),
                                {.colours = {gpu::Format::rgba32_float, gpu::Format::rgba32_float},
                                 .cull = settings.cull_primary},
                                "pipeline/gbuffer");
        // A directional light's depth is linear by itself. Clamping mends rounding, and keeps what casts from
        // before the near plane of a map that is fitted to the camera's frustum alone.
        const bool perspective = frame.light_origin.w == 1.0f;
        shadow_map = device.raster(
            stage("shadow_map.vert"), perspective ? stage("shadow_map.frag") : glsl::Spirv{},
            {.clamp_depth = !perspective, .cull = settings.cull_shadow_map}, "pipeline/shadow_map");
        receivers_kernel = device.kernel(stage("receivers.comp"), "pipeline/receivers");
        shade_kernel = device.kernel(stage("shade.comp"), "pipeline/shade");
        if (settings.light_fit == LightFit::visible_points && !perspective) seen_bounds.emplace(*this);
        const std::size_t pixels = std::size_t{width} * height;
        receivers = device.allocate(pixels * sizeof(shared::Receiver));
        visibility = device.allocate(pixels * sizeof(float));
        left_out = device.upload(std::vector<std::uint32_t>{0});
        colours = device.allocate(pixels * sizeof(glm::vec4));
    }

    gpu::Kernel& visibility_kernel(const Technique& technique) {
        std::string key = technique.name;
        for (const auto& [name, text] : technique.generated) key += '\n' + name + '\n' + text;
        const auto found = visibility_kernels.find(key);
        if (found != visibility_kernels.end()) return found->second;
        const glsl::Spirv words = stage("visibility.comp", visibility_sources(sources, technique));
        return visibility_kernels.emplace(key, device.kernel(words, technique.name)).first->second;
    }

    double run_visibility(const Technique& technique) {
        return 1e-6 * device.run(visibility_kernel(technique),
                                 {&frame_buffer, &receivers, &depth_texels, &visibility, &left_out},
                                 per_pixel());
    }

    /// Returns the pixels whose case was left out.
    std::size_t run_visibility(const Technique& technique, Stopwatch& watch) {
        watch.add("visibility", run_visibility(technique));
        if (technique.generated.empty()) return 0; // all cases: never counted, so the count stays 0
        const std::uint32_t count = device.read<std::uint32_t>(left_out).front();
        if (count == 0) return 0;
        constexpr std::uint32_t none = 0;
        device.write(left_out, gpu::bytes_of(none));
        if (!technique.falls_back) return count;
        Technique whole = technique;
        const std::string& family = technique.family.empty() ? technique.name : technique.family;
        whole.generated.erase(family + "/cases"); // and nothing else: readings stay what they are
        watch.add("all cases", run_visibility(whole));
        return count;
    }

    void draw_gbuffer(Stopwatch& watch) {
        const double drawn = device.draw(gbuffer, {&world, &shading_normal}, depth,
                                         {&frame_buffer, &positions, &normals, &triangles}, vertices);
        watch.add("g-buffer", drawn * 1e-6);
        world_texels = device.texels(world);
        normal_texels = device.texels(shading_normal);
        if (seen_bounds) {
            frame = wide;
            device.write(frame_buffer, gpu::bytes_of(frame));
        }
        seen.reset();
        watch.add("receivers", find_receivers());
        if (seen_bounds) watch.time("fit light", [&] { fit_light(); });
    }

    double find_receivers() {
        return 1e-6 *
               device.run(receivers_kernel,
                          {&frame_buffer, &positions, &triangles, &world_texels, &normal_texels, &receivers},
                          per_pixel());
    }

    /// The map over what the receivers need of it.
    void fit_light() {
        const std::optional<Seen> found = seen_bounds->find();
        if (!found) return; // nothing faces the light
        seen = found->world;
        frame = refitted(wide, found->lower, found->upper);
        device.write(frame_buffer, gpu::bytes_of(frame));
        find_receivers();
    }

    void draw_shadow_map(Stopwatch& watch) {
        const double drawn =
            device.draw(shadow_map, {}, shadow_depth, {&frame_buffer, &positions, &triangles}, vertices);
        watch.add("shadow map", drawn * 1e-6);
        depth_texels = device.texels(shadow_depth);
    }

    void read_receivers() {
        if (!host_receivers.empty()) return;
        Stopwatch ignored;
        draw_gbuffer(ignored);
        host_receivers = device.read<shared::Receiver>(receivers);
        for (const shared::Receiver& receiver : host_receivers) {
            host_surfaces.covered.push_back(receiver.map.w >= 0 ? 1 : 0);
            host_surfaces.facing.push_back(receiver.map.w == 1 ? 1 : 0);
        }
    }

    std::vector<float> trace(Stopwatch& watch) {
        read_receivers();
        const RayTracer& rays = tracer.get(watch);
        std::vector<glm::vec3> origins;
        origins.reserve(host_receivers.size());
        for (const shared::Receiver& receiver : host_receivers) origins.emplace_back(receiver.origin);
        const auto start = Clock::now();
        const glm::vec3 light(frame.light_origin);
        const std::vector<std::uint8_t> visible =
            frame.light_origin.w == 1.0f
                ? rays.visible_from(origins, host_surfaces.facing, light, frame.eye.w)
                : rays.visible_along(origins, host_surfaces.facing, light, frame.eye.w);
        watch.add("trace", milliseconds_since(start));
        std::vector<float> result(visible.size());
        for (std::size_t i = 0; i < visible.size(); ++i)
            result[i] = visible[i] != 0 && host_surfaces.facing[i] != 0 ? 1.0f : 0.0f;
        return result;
    }

    static std::string key_of(const Technique& technique) {
        return technique.prune ? technique.name : technique.name + ", whole";
    }

    Hybrid& hybrid(const Technique& technique) {
        const auto found = hybrids.find(key_of(technique));
        if (found != hybrids.end()) return found->second;
        return hybrids.emplace(key_of(technique), new_hybrid(technique)).first->second;
    }

    Hybrid new_hybrid(const Technique& technique) {
        const HybridTechnique* known = find_hybrid(technique.name);
        if (known == nullptr) throw Error("no hybrid technique \"{}\"", technique.name);
        return Hybrid(*this, tracer, *known, technique.prune);
    }

    /// What `make` makes, its stages compiled with the recording's texts.
    template <typename Make>
    auto recorded_by(Recording& by, Make make) {
        struct Until {
            Recording*& recording;
            ~Until() { recording = nullptr; }
        } const until{recording};
        recording = &by;
        return make();
    }

    /// From maps to fixed pixels, over the G-buffer that is there.
    double frame_milliseconds(const Technique& technique, Stopwatch& watch) {
        const auto start = Clock::now();
        find_visibility(technique, watch);
        return milliseconds_since(start);
    }

    const Choice& calibrated(bool prune) {
        if (choice) return *choice;
        const auto start = Clock::now();
        Stopwatch ignored;
        draw_gbuffer(ignored);
        std::vector<Technique> exact;
        std::vector<std::string> names;
        for (const HybridTechnique& technique : hybrid_techniques())
            if (technique.sound) {
                exact.push_back({.kind = Technique::Kind::hybrid, .name = technique.name, .prune = prune});
                names.push_back(technique.name);
            }
        choice = calibrate(names, [&](std::size_t i) { return frame_milliseconds(exact[i], ignored); });
        for (const Technique& technique : exact)
            if (technique.name != choice->name()) hybrids.erase(key_of(technique));
        choice->milliseconds = milliseconds_since(start);
        return *choice;
    }

    /// What an automatic technique stands for; any other as it is.
    Technique chosen(const Technique& technique) {
        if (technique.kind != Technique::Kind::automatic) return technique;
        Technique result = technique;
        result.kind = Technique::Kind::hybrid;
        result.name = calibrated(technique.prune).name();
        return result;
    }

    /// Returns the pixels whose case was left out.
    std::size_t find_visibility(const Technique& technique, Stopwatch& watch) {
        switch (technique.kind) {
        case Technique::Kind::kernel: {
            draw_shadow_map(watch);
            return run_visibility(technique, watch);
        }
        case Technique::Kind::raytraced: {
            const std::vector<float> traced = trace(watch);
            device.write(visibility, std::as_bytes(std::span(traced)));
            return 0;
        }
        case Technique::Kind::hybrid: {
            hybrid_frame = hybrid(technique).run(watch);
            classified.insert(key_of(technique));
            return 0;
        }
        case Technique::Kind::automatic:
            return find_visibility(chosen(technique), watch);
        case Technique::Kind::none:
            break;
        }
        read_receivers();
        const std::vector<float> facing(host_surfaces.facing.begin(), host_surfaces.facing.end());
        device.write(visibility, std::as_bytes(std::span(facing)));
        return 0;
    }

    Image read_image() {
        const std::vector<glm::vec4> linear = device.read<glm::vec4>(colours);
        Image image(static_cast<int>(frame.size.x), static_cast<int>(frame.size.y));
        std::ranges::transform(linear, image.pixels.begin(), [](glm::vec4 c) {
            return Rgb{srgb(c.r), srgb(c.g), srgb(c.b)};
        });
        return image;
    }
};

Renderer::Renderer(gpu::Device& device, glsl::Sources sources, const Scene& scene, const Camera& camera,
                   const Light& light, const ViewSettings& settings)
    : impl_(std::make_unique<Impl>(device, std::move(sources), scene, camera, light, settings)) {}
Renderer::~Renderer() = default;

const ViewSettings& Renderer::settings() const { return impl_->settings; }

void Renderer::look(const Camera& camera, const Light& light) {
    Impl& r = *impl_;
    const shared::Frame frame = make_frame(camera, light, r.settings, r.scene.bounds());
    if (frame.light_origin.w != r.frame.light_origin.w)
        throw std::invalid_argument("Renderer::look: the light is of another kind");
    r.frame = r.wide = frame;
    r.device.write(r.frame_buffer, gpu::bytes_of(r.frame));
    r.host_receivers.clear();
    r.host_surfaces = {};
    r.choice.reset();
    r.classified.clear();
}

Rendering Renderer::render(const Technique& asked, int frames) {
    Impl& r = *impl_;
    const Technique technique = r.chosen(asked);
    Stopwatch watch;
    std::size_t left_out = 0;
    for (int i = 0; i < std::max(frames, 1) + 1; ++i) {
        r.draw_gbuffer(watch);
        left_out = r.find_visibility(technique, watch);
        const double shaded = r.device.run(
            r.shade_kernel,
            {&r.frame_buffer, &r.receivers, &r.world_texels, &r.normal_texels, &r.visibility, &r.colours},
            r.per_pixel());
        watch.add("shade", shaded * 1e-6);
    }
    return {r.device.read<float>(r.visibility),
            r.read_image(),
            watch.medians(),
            left_out,
            technique.kind == Technique::Kind::hybrid ? std::optional(r.hybrid_frame) : std::nullopt,
            asked.kind == Technique::Kind::automatic ? r.choice : std::nullopt};
}

std::vector<float> Renderer::visibility(const Technique& technique) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.read_receivers(); // draws the G-buffer if nothing did yet
    r.find_visibility(technique, ignored);
    return r.device.read<float>(r.visibility);
}

std::vector<std::uint64_t> Renderer::census(const Technique& technique) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    r.draw_shadow_map(ignored);
    gpu::Kernel kernel = r.device.kernel(r.stage("census.comp", number_sources(r.sources, technique)),
                                         technique.name + " census");
    const gpu::Buffer counts = r.device.upload(std::vector<std::uint32_t>(census_size));
    r.device.run(kernel, {&r.frame_buffer, &r.receivers, &r.depth_texels, &counts}, r.per_pixel());
    const std::vector<std::uint32_t> words = r.device.read<std::uint32_t>(counts);
    return {words.begin(), words.end()};
}

std::vector<double> Renderer::time_visibility(const std::vector<Technique>& techniques, int rounds) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    r.draw_shadow_map(ignored);
    std::vector<std::vector<double>> milliseconds(techniques.size());
    for (int round = 0; round < rounds + 1; ++round)
        for (std::size_t i = 0; i < techniques.size(); ++i)
            milliseconds[i].push_back(r.run_visibility(techniques[i]));
    constexpr std::uint32_t none = 0;
    r.device.write(r.left_out, gpu::bytes_of(none));
    std::vector<double> medians;
    for (const std::vector<double>& times : milliseconds) medians.push_back(median_of_later(times));
    return medians;
}

double Renderer::time_first_visibility(const Technique& technique) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    r.draw_shadow_map(ignored);
    const glsl::Spirv words = r.stage("visibility.comp", visibility_sources(r.sources, technique));
    const auto run = [&](gpu::Kernel& kernel) {
        r.device.run(kernel, {&r.frame_buffer, &r.receivers, &r.depth_texels, &r.visibility, &r.left_out},
                     r.per_pixel());
    };
    const auto start = Clock::now();
    gpu::Kernel kernel = r.device.kernel(words, technique.name);
    run(kernel);
    const double first = milliseconds_since(start);
    const auto again = Clock::now();
    run(kernel);
    const double second = milliseconds_since(again);
    constexpr std::uint32_t none = 0;
    r.device.write(r.left_out, gpu::bytes_of(none));
    return first - second;
}

std::vector<PixelState> Renderer::states(const Technique& technique) {
    Impl& r = *impl_;
    const Technique hybrid = r.chosen(technique);
    if (!r.classified.contains(Impl::key_of(hybrid))) visibility(hybrid);
    return r.hybrids.at(Impl::key_of(hybrid)).states();
}

std::vector<TechniqueTimes> Renderer::time_techniques(const std::vector<Technique>& techniques, int rounds) {
    Impl& r = *impl_;
    std::vector<Technique> timed; // calibrated before the clock runs
    for (const Technique& technique : techniques) timed.push_back(r.chosen(technique));
    std::vector<TechniqueTimes> result(timed.size());
    std::vector<Stopwatch> watches(timed.size());
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    for (std::size_t i = 0; i < timed.size(); ++i) {
        r.frame_milliseconds(timed[i], ignored);
        result[i].visibility = r.device.read<float>(r.visibility);
    }
    std::vector<std::vector<double>> whole(timed.size());
    // There and back: who comes after a technique with large maps finds the caches empty.
    for (int round = 0; round < std::max(rounds, 1); ++round)
        for (std::size_t n = 0; n < timed.size(); ++n) {
            const std::size_t i = round % 2 == 0 ? n : timed.size() - 1 - n;
            whole[i].push_back(r.frame_milliseconds(timed[i], watches[i]));
            if (timed[i].kind == Technique::Kind::hybrid) result[i].frame = r.hybrid_frame;
        }
    for (std::size_t i = 0; i < timed.size(); ++i) {
        result[i].steps = watches[i].medians_of_all();
        result[i].milliseconds = median(whole[i]);
        result[i].least = std::ranges::min(whole[i]);
        result[i].most = std::ranges::max(whole[i]);
        result[i].rounds = std::move(whole[i]);
    }
    return result;
}

const Choice& Renderer::choice(bool prune) { return impl_->calibrated(prune); }

const Surfaces& Renderer::surfaces() {
    impl_->read_receivers();
    return impl_->host_surfaces;
}

std::vector<float> Renderer::shadow_map() {
    Stopwatch ignored;
    impl_->draw_shadow_map(ignored);
    return impl_->device.read<float>(impl_->depth_texels);
}

const std::vector<shared::Receiver>& Renderer::receivers() {
    impl_->read_receivers();
    return impl_->host_receivers;
}

std::vector<Capture> Renderer::capture(const std::vector<std::uint32_t>& pixels) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    r.draw_shadow_map(ignored);
    gpu::Kernel kernel = r.device.kernel(r.stage("capture.comp"), "pipeline/capture");
    constexpr std::size_t side = 2 * Capture::radius + 1;
    constexpr std::size_t words = (side * side + 31) / 32;
    const gpu::Buffer wanted = r.device.upload(pixels);
    gpu::Buffer captured = r.device.allocate(pixels.size() * (4 + words) * sizeof(std::uint32_t));
    const auto count = static_cast<std::uint32_t>(pixels.size());
    r.device.run(kernel, {&r.frame_buffer, &r.receivers, &r.depth_texels, &wanted, &captured},
                 {.threads = {count, 1, 1}, .constants = gpu::bytes_of(count)});
    const std::vector<std::uint32_t> bits = r.device.read<std::uint32_t>(captured);
    std::vector<Capture> result;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint32_t* record = bits.data() + i * (4 + words);
        Capture capture;
        std::memcpy(&capture.texel, record, sizeof capture.texel);
        std::memcpy(&capture.p, record + 2, sizeof capture.p);
        for (std::size_t n = 0; n < side * side; ++n)
            capture.lit.push_back((record[4 + n / 32] >> (n % 32)) & 1u);
        result.push_back(std::move(capture));
    }
    return result;
}

Recorded Renderer::record(const Technique& technique, Question question,
                          const std::vector<std::uint32_t>& pixels,
                          const std::map<std::string, std::string>& overlaid) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    r.draw_shadow_map(ignored);
    Recording recording{overlaid};
    gpu::Kernel kernel = r.device.kernel(
        r.recorded_by(recording,
                      [&] { return r.stage("record.comp", answer_sources(r.sources, technique, question)); }),
        technique.name + " record");
    Recorded recorded;
    constexpr std::size_t at_once = 16384; // pixels: what they record has room in a buffer
    for (std::size_t first = 0; first < pixels.size(); first += at_once) {
        const std::span some =
            std::span(pixels).subspan(first).first(std::min(at_once, pixels.size() - first));
        const gpu::Buffer wanted = r.device.upload(some);
        const gpu::Buffer answers = r.device.allocate(some.size_bytes());
        const auto count = static_cast<std::uint32_t>(some.size());
        for (RecordedCall& call : record_calls(r.device, 0, 0, {}, [&] {
                 r.device.run(kernel, {&r.frame_buffer, &r.receivers, &r.depth_texels, &wanted, &answers},
                              {.threads = {count, 1, 1}, .constants = gpu::bytes_of(count)});
             })) {
            call.x += static_cast<std::uint32_t>(first);
            recorded.calls.push_back(std::move(call));
        }
        const std::vector<std::uint32_t> given = r.device.read<std::uint32_t>(answers);
        recorded.answers.insert(recorded.answers.end(), given.begin(), given.end());
    }
    recorded.stages = std::move(recording.stages);
    return recorded;
}

Recorded Renderer::record_frame(const Technique& technique, const std::vector<std::uint32_t>& pixels,
                                const std::map<std::string, std::string>& overlaid) {
    Impl& r = *impl_;
    Stopwatch ignored;
    r.draw_gbuffer(ignored);
    Recording recording{overlaid};
    Recorded recorded;
    const auto frame = [&] { // some stages run when they are made
        recording.stages.clear();
        Hybrid hybrid = r.new_hybrid(r.chosen(technique));
        return hybrid.run(ignored);
    };
    recorded.calls = record_calls(r.device, r.frame.size.x, r.frame.size.y, pixels,
                                  [&] { r.recorded_by(recording, frame); });
    recorded.answers = r.device.read<std::uint32_t>(r.visibility);
    recorded.stages = std::move(recording.stages);
    return recorded;
}

std::vector<StageText> Renderer::stages(const Technique& technique) {
    Impl& r = *impl_;
    Recording recording;
    r.recorded_by(recording, [&] { return r.new_hybrid(r.chosen(technique)); });
    return std::move(recording.stages);
}

} // namespace gnomon
