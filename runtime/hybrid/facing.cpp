#include "runtime/hybrid/facing.h"

namespace gnomon {
namespace {

/// Pixels of one thread's run at most. Some drivers leave a loop after 65,000 turns.
constexpr std::size_t longest_run = 1024;
constexpr std::size_t group_size = 64; // of kernels/hybrid/facing.comp

} // namespace

FacingTest::FacingTest(Resources& resources)
    : r_(resources), kernel_(r_.kernel("hybrid/facing.comp")),
      found_(r_.device.allocate(sizeof(std::uint32_t))) {}

bool FacingTest::any() {
    constexpr std::uint32_t none = 0;
    r_.device.write(found_, gpu::bytes_of(none));
    constexpr std::size_t per_group = group_size * longest_run;
    const auto groups = static_cast<std::uint32_t>((r_.pixels() + per_group - 1) / per_group);
    r_.device.run(kernel_, {&r_.frame_buffer, &r_.receivers, &found_},
                  {.threads = {groups * static_cast<std::uint32_t>(group_size), 1, 1}});
    return r_.device.read<std::uint32_t>(found_).front() != 0;
}

} // namespace gnomon
