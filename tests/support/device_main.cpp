// Tests on the device: a test fails if the validation layer said anything while it ran.
#include "runtime/gpu/instance.h"
#include "runtime/gpu/validation.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

namespace {

class ValidationListener : public ::testing::EmptyTestEventListener {
    void OnTestEnd(const ::testing::TestInfo&) override {
        for (const std::string& message : gnomon::gpu::take_validation_messages())
            ADD_FAILURE() << "Vulkan's validation layer: " << message;
    }
};

} // namespace

int main(int argc, char** argv) {
    gnomon::testing::use_test_cache();
    // It sets variables of the environment, which no thread must be reading then.
    gnomon::gpu::prepare_process(false);
    ::testing::InitGoogleTest(&argc, argv);
    // Behind the printers: listeners are told of ends in reverse, so what fails here is still printed.
    ::testing::UnitTest::GetInstance()->listeners().Append(new ValidationListener);
    const int result = RUN_ALL_TESTS();
    gnomon::testing::close_shared_device();
    return result;
}
