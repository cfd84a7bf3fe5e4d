#include "tests/support/device.h"

#include "casegen/catalogue.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace gnomon::testing {
namespace {

std::optional<gpu::Device> device;

} // namespace

gpu::Device& shared_device() {
    if (!device) device.emplace(validated());
    return *device;
}

void close_shared_device() { device.reset(); }

std::vector<std::uint32_t> run_kernel(const std::string& name, const Records& records) {
    const Outputs outputs =
        evaluate(shared_device(), kernel_sources(kernels_folder()), find_case(name), records);
    EXPECT_EQ(std::ranges::count(outputs.unwritten, 0), std::ssize(outputs.unwritten)) << name;
    EXPECT_FALSE(outputs.stray_write) << name;
    EXPECT_FALSE(outputs.unstable) << name;
    return outputs.words;
}

} // namespace gnomon::testing
