// A Vulkan 1.3 device that runs kernels over buffers and draws triangles off screen; nothing else.
//
//     gpu::Device device;                                          // lavapipe; every failure throws Error
//     gpu::Kernel kernel = device.kernel(glsl::compile(sources, text, "saxpy", glsl::Stage::compute),
//     "saxpy"); gpu::Buffer in = device.upload<float>(values), out = device.allocate(values.size() *
//     sizeof(float)); device.run(kernel, {&in, &out}, {.threads = {n, 1, 1}});     // thread counts, never
//     group counts std::vector<float> result = device.read<float>(out);
//
// A call returns when the device is done. One thread uses a device at a time; several threads make one each.
#pragma once

#include "runtime/glsl/compiler.h"
#include "runtime/glsl/reflection.h"
#include "runtime/gpu/instance.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace gnomon::gpu {

struct Context;

struct DeviceOptions {
    std::string name;        ///< index or part of the name; empty: lavapipe
    bool validation = false; ///< Vulkan's validation layer; see take_validation_messages
    /// With an instance of its own: the devices of one share lavapipe's threads, so that a kernel that hangs
    /// on one of them blocks the others.
    bool isolated = false;
    double time_limit = 20.0; ///< seconds that one dispatch or draw may take
};

/// Bytes on the device. Moves, does not copy.
class Buffer {
public:
    Buffer();
    Buffer(Buffer&&) noexcept;
    Buffer& operator=(Buffer&&) noexcept;
    ~Buffer();
    std::size_t size() const;

private:
    friend class Device;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A compute pipeline; what it binds comes from reflection.
class Kernel {
public:
    Kernel();
    Kernel(Kernel&&) noexcept;
    Kernel& operator=(Kernel&&) noexcept;
    ~Kernel();
    const glsl::Reflection& reflection() const;

private:
    friend class Device;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

enum class Format { rgba32_float, depth32_float };

/// A render target.
class Target {
public:
    Target();
    Target(Target&&) noexcept;
    Target& operator=(Target&&) noexcept;
    ~Target();
    std::uint32_t width() const;
    std::uint32_t height() const;

private:
    friend class Device;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// A raster pipeline: triangles whose vertex shader pulls from storage buffers by gl_VertexIndex. A geometry
/// shader may stand between it and the rasteriser.
class Raster {
public:
    Raster();
    Raster(Raster&&) noexcept;
    Raster& operator=(Raster&&) noexcept;
    ~Raster();

private:
    friend class Device;
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

/// Which triangles are not drawn. The front is seen where corners go counter-clockwise in the picture, whose
/// rows grow downwards.
enum class Cull { none = 0, front = 1, back = 2 };

/// What the vertex shader's invocations make up: three corners, or three with the far corners of the
/// triangles beyond each edge in between (six; a geometry shader is needed).
enum class Topology { triangles, triangles_with_adjacency };

struct RasterState {
    std::vector<Format> colours; ///< one per fragment output
    bool clamp_depth = false;    ///< triangles beyond near and far keep their coverage at the clamped depth
    Cull cull = Cull::none;      ///< winding is not to be relied upon
    Topology topology = Topology::triangles;
};

struct Dispatch {
    std::array<std::uint32_t, 3> threads{1, 1, 1}; ///< kernels must ignore threads beyond: groups are whole
    std::span<const std::byte> constants{};        ///< push constants
};

/// What a buffer holds, for the host to read. Moves, does not copy.
template <typename T>
struct HostView {
    std::vector<T> copy; ///< empty where the host sees the buffer itself
    std::span<const T> values;

    HostView(std::vector<T> held, std::span<const T> seen) : copy(std::move(held)), values(seen) {}
    HostView(HostView&&) noexcept = default; // a moved vector keeps its elements where they are
    HostView& operator=(HostView&&) noexcept = default;
};

/// A plain value as push constants.
template <typename T>
std::span<const std::byte> bytes_of(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    return std::as_bytes(std::span(&value, 1));
}

class Device {
public:
    /// Throws Error (no driver, no such device, too old, out of memory) with the remedy.
    explicit Device(const DeviceOptions& options = {});

    const DeviceInfo& info() const;
    std::uint32_t max_image_side() const;
    std::uint32_t max_groups() const; ///< workgroups along x in one dispatch
    std::size_t max_buffer() const;   ///< bytes

    // Memory. Contents of a fresh buffer are undefined. All throw Error when memory is exhausted.
    Buffer allocate(std::size_t bytes);
    void write(Buffer& buffer, std::span<const std::byte> bytes, std::size_t offset = 0);
    void read(const Buffer& buffer, std::span<std::byte> bytes, std::size_t offset = 0);

    /// The bytes where the host sees them; empty if it does not see this buffer's memory.
    std::span<const std::byte> mapped(const Buffer& buffer) const;

    template <typename T>
    Buffer upload(std::span<const T> values) {
        static_assert(std::is_trivially_copyable_v<T>);
        Buffer buffer = allocate(values.size_bytes());
        write(buffer, std::as_bytes(values));
        return buffer;
    }
    template <typename T>
    Buffer upload(const std::vector<T>& values) {
        return upload(std::span<const T>(values));
    }
    template <typename T>
    std::vector<T> read(const Buffer& buffer) {
        static_assert(std::is_trivially_copyable_v<T>);
        std::vector<T> values(buffer.size() / sizeof(T));
        read(buffer, std::as_writable_bytes(std::span(values)));
        return values;
    }
    /// The first `count` values, without a copy where the host sees the buffer. Valid until it is written to.
    template <typename T>
    HostView<T> view(const Buffer& buffer, std::size_t count) {
        const std::span<const std::byte> bytes = mapped(buffer);
        if (count * sizeof(T) <= bytes.size()) return {{}, {reinterpret_cast<const T*>(bytes.data()), count}};
        HostView<T> result{std::vector<T>(count), {}};
        read(buffer, std::as_writable_bytes(std::span(result.copy)));
        result.values = result.copy;
        return result;
    }

    // Compute.
    Kernel kernel(const glsl::Spirv& words, std::string_view name);
    /// `buffers` in ascending order of their bindings. Returns device nanoseconds.
    /// Throws KernelTimeout; Error if the number of buffers or the bytes of constants are not what the kernel
    /// declares.
    double run(Kernel& kernel, std::initializer_list<const Buffer*> buffers, const Dispatch& dispatch);

    // Raster.
    Target target(std::uint32_t width, std::uint32_t height, Format format);
    /// An empty `fragment` draws depth only; an empty `geometry` is no such stage. Throws Error if there is
    /// one and the device cannot run it (see has_geometry_shaders), or if `state` asks for adjacency without
    /// one.
    Raster raster(const glsl::Spirv& vertex, const glsl::Spirv& fragment, const RasterState& state,
                  std::string_view name, const glsl::Spirv& geometry = {});
    bool has_geometry_shaders() const;
    /// Clears colours to 0 and depth to 1, then draws the triangles that `vertices` invocations of the vertex
    /// shader make up; of equal depths and of nearer ones the last wins.
    double draw(Raster& raster, std::initializer_list<const Target*> colours, const Target& depth,
                std::initializer_list<const Buffer*> buffers, std::uint32_t vertices,
                std::span<const std::byte> constants = {});
    /// Texels in row order: 16 bytes each for colours, 4 for depth.
    Buffer texels(const Target& target);

    /// A buffer for what a changed text writes beside what its stage does: whatever binds one buffer more
    /// than it is given, the last at `binding`, gets this one there. Null: none. The buffer must outlive it.
    void bind_always(std::uint32_t binding, const Buffer* buffer);

    /// How often the device was given work by now (dispatches, draws, copies between memories): what was
    /// spared can be counted.
    std::uint64_t submissions() const;

private:
    std::shared_ptr<Context> context_;
};

/// True once a kernel has exceeded its time limit in this process: leave by std::_Exit, for the driver's
/// threads do not end.
bool any_device_lost();

} // namespace gnomon::gpu
