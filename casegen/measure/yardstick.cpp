#include "casegen/measure/yardstick.h"

#include "runtime/files.h"
#include "runtime/glsl/compiler.h"

namespace gnomon::measure {
namespace {

constexpr std::uint32_t threads = 1 << 14, evaluations = 64;

// The sum of all results is written, so that none can be left out; every result depends on the one before.
constexpr const char* text = R"(layout(local_size_x = 64) in;
layout(std430, binding = 0) writeonly buffer Results { float results[]; };
layout(push_constant) uniform Constants { uint count, evaluations; };
void main() {
    uint thread = gl_GlobalInvocationID.x;
    if (thread >= count) return;
    float x = float(thread & 1023u) * 0.0009765625;
    float sum = 0.0;
    for (uint i = 0u; i < evaluations; ++i) {
        for (int k = 0; k < 8; ++k) {
            x = sqrt(x * 0.75 + 0.125);
            x = x > 0.5 ? x * 1.5 - 0.25 : x + 0.375;
        }
        x *= 0.5;
        sum += x;
    }
    results[thread] = sum;
}
)";

} // namespace

Yardstick::Yardstick(gpu::Device& device)
    : device_(device),
      kernel_(device.kernel(glsl::compile({}, text, "<yardstick>", glsl::Stage::compute), "yardstick")),
      results_(device.allocate(threads * sizeof(float))) {
    run(); // the driver's compiler
}

double Yardstick::run() {
    struct {
        std::uint32_t count = threads, times = evaluations;
    } constants;
    const double nanoseconds = device_.run(
        kernel_, {&results_}, {.threads = {threads, 1, 1}, .constants = gpu::bytes_of(constants)});
    return nanoseconds / (double{threads} * evaluations);
}

std::uint64_t Yardstick::fingerprint() { return hash(text); }

} // namespace gnomon::measure
