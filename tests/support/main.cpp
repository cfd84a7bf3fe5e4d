#include "tests/support/environment.h"

#include <gtest/gtest.h>

int main(int argc, char** argv) {
    gnomon::testing::use_test_cache();
    ::testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
