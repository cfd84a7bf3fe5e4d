#include "runtime/rays.h"

#include "runtime/error.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <embree3/rtcore.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace gnomon {
namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using EmbreeScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

constexpr std::size_t packet_size = 16;

const char* error_name(RTCError error) {
    switch (error) {
    case RTC_ERROR_NONE:
        return "no error";
    case RTC_ERROR_UNKNOWN:
        break;
    case RTC_ERROR_INVALID_ARGUMENT:
        return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION:
        return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY:
        return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU:
        return "this processor is not supported";
    case RTC_ERROR_CANCELLED:
        return "cancelled";
    }
    return "unknown error";
}

/// Takes the error that Embree keeps for this thread; a null device stands for the making of one.
void check(RTCDevice device, const char* doing) {
    const RTCError error = rtcGetDeviceError(device);
    if (error != RTC_ERROR_NONE) throw Error("Embree failed at {}: {}", doing, error_name(error));
}

/// Embree owns the buffer, and pads it as its vector loads need.
template <typename T>
void copy_to_buffer(RTCDevice device, RTCGeometry geometry, RTCBufferType type, RTCFormat format,
                    const std::vector<T>& from) {
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(T), from.size());
    check(device, "allocating a buffer");
    std::memcpy(buffer, from.data(), from.size() * sizeof(T));
}

bool is_finite(glm::vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

void require_tmin(float tmin) {
    if (!(tmin > 0.0f) || !std::isfinite(tmin))
        throw Error("tmin is {}: the nearest distance at which a ray hits must be above 0", tmin);
}

/// A ray of a packet. `end` <= `begin` is a ray of no length.
struct Segment {
    glm::vec3 direction{0.0f};
    float end = 0;
};

void set_ray(RTCRay16& rays, std::size_t lane, glm::vec3 origin, const Segment& segment, float begin) {
    rays.org_x[lane] = origin.x;
    rays.org_y[lane] = origin.y;
    rays.org_z[lane] = origin.z;
    rays.dir_x[lane] = segment.direction.x;
    rays.dir_y[lane] = segment.direction.y;
    rays.dir_z[lane] = segment.direction.z;
    rays.tnear[lane] = begin;
    rays.tfar[lane] = segment.end;
    rays.time[lane] = 0;
    rays.mask[lane] = ~0u;
    rays.id[lane] = 0;
    rays.flags[lane] = 0;
}

/// `segment_at(origin)` is the Segment from there towards the light. Without `active` all are.
template <typename Origin, typename SegmentAt>
std::vector<std::uint8_t> trace(RTCScene scene, std::span<const Origin> origins,
                                std::optional<std::span<const std::uint8_t>> active, float tmin,
                                const SegmentAt& segment_at) {
    if (active && origins.size() != active->size())
        throw std::invalid_argument("RayTracer: one active flag per origin is needed");
    std::vector<std::uint8_t> visible(origins.size(), 1);

    // Packets begin at multiples of 16 whatever the division of work, so it cannot change what is in one.
    const auto trace_packet = [&](std::size_t packet) {
        alignas(64) RTCRay16 rays{};
        alignas(64) int valid[packet_size]{}; // -1: trace
        const std::size_t first = packet * packet_size;
        const std::size_t count = std::min(packet_size, origins.size() - first);
        bool any = false;
        for (std::size_t lane = 0; lane < count; ++lane) {
            const std::size_t i = first + lane;
            if (active && (*active)[i] == 0) continue;
            const glm::vec3 origin(origins[i]);
            if (!is_finite(origin))
                throw Error("receiver {} is at ({}, {}, {}): visibility needs finite positions", i, origin.x,
                            origin.y, origin.z);
            const Segment segment = segment_at(origin);
            if (!(segment.end > tmin)) continue; // nothing can lie between
            set_ray(rays, lane, origin, segment, tmin);
            valid[lane] = -1;
            any = true;
        }
        if (!any) return;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        // Neighbouring receivers' rays start close together and point the same way.
        context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
        // Where the processor has no 16-wide vectors, Embree traces the packet's rays one by one.
        rtcOccluded16(valid, scene, &context, &rays);
        for (std::size_t lane = 0; lane < count; ++lane)
            if (valid[lane] != 0 && rays.tfar[lane] < 0.0f) visible[first + lane] = 0; // -inf: occluded
    };

    const std::size_t packets = (origins.size() + packet_size - 1) / packet_size;
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, packets, 64), [&](const auto& range) {
        for (std::size_t packet = range.begin(); packet != range.end(); ++packet) trace_packet(packet);
    });
    return visible;
}

} // namespace

struct RayTracer::Impl {
    Device device; // released after the scene
    EmbreeScene scene;
};

RayTracer::RayTracer(const Scene& scene, const std::string& embree_options)
    : impl_(std::make_unique<Impl>()) {
    impl_->device.reset(rtcNewDevice(embree_options.c_str()));
    RTCDevice device = impl_->device.get();
    if (device == nullptr) {
        check(nullptr, "making a device");
        throw Error("Embree failed at making a device");
    }
    impl_->scene.reset(rtcNewScene(device));
    check(device, "making a scene");
    rtcSetSceneFlags(impl_->scene.get(), RTC_SCENE_FLAG_ROBUST);

    if (!scene.triangles.empty()) {
        const Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
        check(device, "making a geometry");
        static_assert(sizeof(glm::vec3) == 3 * sizeof(float) && sizeof(glm::uvec3) == 3 * sizeof(unsigned));
        copy_to_buffer(device, geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, scene.positions);
        copy_to_buffer(device, geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, scene.triangles);
        rtcCommitGeometry(geometry.get());
        check(device, "reading the triangles");
        rtcAttachGeometry(impl_->scene.get(), geometry.get());
        check(device, "adding the triangles");
    }
    rtcCommitScene(impl_->scene.get());
    check(device, "building the hierarchy");
}

RayTracer::~RayTracer() = default;
RayTracer::RayTracer(RayTracer&&) noexcept = default;
RayTracer& RayTracer::operator=(RayTracer&&) noexcept = default;

namespace {

Segment segment_along(glm::vec3 direction_to_light) {
    const glm::dvec3 direction(direction_to_light);
    if (!is_finite(direction_to_light) || direction == glm::dvec3(0.0))
        throw Error("the direction to the light is ({}, {}, {}): it must be finite and not zero",
                    direction_to_light.x, direction_to_light.y, direction_to_light.z);
    return {glm::vec3(glm::normalize(direction)), std::numeric_limits<float>::infinity()};
}

Segment segment_to(glm::vec3 light, glm::vec3 origin) {
    const glm::dvec3 offset = glm::dvec3(light) - glm::dvec3(origin);
    const double distance = glm::length(offset);
    if (distance == 0.0) return {};
    return {glm::vec3(offset / distance), static_cast<float>(distance)};
}

void require_light(glm::vec3 position) {
    if (!is_finite(position))
        throw Error("the light is at ({}, {}, {}): its position must be finite", position.x, position.y,
                    position.z);
}

} // namespace

std::vector<std::uint8_t> RayTracer::visible_along(std::span<const glm::vec3> origins,
                                                   std::span<const std::uint8_t> active,
                                                   glm::vec3 direction_to_light, float tmin) const {
    require_tmin(tmin);
    const Segment segment = segment_along(direction_to_light);
    return trace(impl_->scene.get(), origins, active, tmin, [&](glm::vec3) { return segment; });
}

std::vector<std::uint8_t> RayTracer::visible_from(std::span<const glm::vec3> origins,
                                                  std::span<const std::uint8_t> active,
                                                  glm::vec3 light_position, float tmin) const {
    require_tmin(tmin);
    require_light(light_position);
    return trace(impl_->scene.get(), origins, active, tmin,
                 [&](glm::vec3 origin) { return segment_to(light_position, origin); });
}

std::vector<std::uint8_t> RayTracer::visible_along(std::span<const glm::vec4> origins,
                                                   glm::vec3 direction_to_light, float tmin) const {
    require_tmin(tmin);
    const Segment segment = segment_along(direction_to_light);
    return trace(impl_->scene.get(), origins, {}, tmin, [&](glm::vec3) { return segment; });
}

std::vector<std::uint8_t> RayTracer::visible_from(std::span<const glm::vec4> origins,
                                                  glm::vec3 light_position, float tmin) const {
    require_tmin(tmin);
    require_light(light_position);
    return trace(impl_->scene.get(), origins, {}, tmin,
                 [&](glm::vec3 origin) { return segment_to(light_position, origin); });
}

} // namespace gnomon
