#include "casegen/measure/loop.h"

#include "casegen/standalone.h"

#include <algorithm>

namespace gnomon::measure {
namespace {

constexpr std::uint32_t least_threads = 1024, most_threads = 1 << 16;

struct Constants {
    std::uint32_t count, last, evaluations;
};

} // namespace

LoopBuffers upload_for_loops(gpu::Device& device, const Case& c, const Records& records,
                             std::span<const std::size_t> chosen, std::uint64_t seed) {
    Records timed(c);
    timed.reserve(timed_records);
    Random random(seed);
    for (std::uint32_t i = 0; i < timed_records; ++i) {
        const std::size_t n = chosen[random.below(static_cast<std::uint32_t>(chosen.size()))];
        timed.add(records.input(n), records.mask(n));
    }
    return {device.upload(timed.words()), device.upload(timed.masks()),
            device.allocate(most_threads * sizeof(std::uint32_t))};
}

double run_once(gpu::Device& device, Loop& loop, const LoopBuffers& buffers) {
    const Constants constants{loop.threads, timed_records - 1, evaluations_per_thread};
    const gpu::Dispatch dispatch{.threads = {loop.threads, 1, 1}, .constants = gpu::bytes_of(constants)};
    const double nanoseconds =
        loop.reads_masks
            ? device.run(loop.kernel, {&buffers.records, &buffers.results, &buffers.masks}, dispatch)
            : device.run(loop.kernel, {&buffers.records, &buffers.results}, dispatch);
    return nanoseconds / (static_cast<double>(loop.threads) * evaluations_per_thread);
}

Loop make_loop(gpu::Device& device, const Case& c, const glsl::Sources& sources, Repeated what,
               const LoopBuffers& buffers, double nanoseconds) {
    return make_loop(device, c,
                     glsl::compile(sources, repeated_source(c, what), standalone_name, glsl::Stage::compute),
                     what, buffers, nanoseconds);
}

Loop make_loop(gpu::Device& device, const Case& c, const glsl::Spirv& words, Repeated what,
               const LoopBuffers& buffers, double nanoseconds) {
    Loop loop{device.kernel(words, c.name), what == Repeated::calls && c.reference.takes_mask, least_threads};
    run_once(device, loop, buffers);
    const double one = run_once(device, loop, buffers) * evaluations_per_thread;
    const double threads = one > 0 ? nanoseconds / one : most_threads;
    loop.threads = static_cast<std::uint32_t>(std::clamp<double>(threads, least_threads, most_threads)) /
                   least_threads * least_threads;
    return loop;
}

} // namespace gnomon::measure
