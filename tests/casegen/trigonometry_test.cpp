// Where the kernels' sin, cos and exp may come from.
#include "casegen/trigonometry.h"

#include "casegen/standalone.h"
#include "runtime/glsl/compiler.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using ::testing::AllOf;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Not;

TEST(trigonometry, names_are_read_as_they_are_written) {
    for (const Trigonometry mode : {Trigonometry::portable, Trigonometry::built_in, Trigonometry::coarse})
        EXPECT_EQ(parse_trigonometry(to_string(mode)), mode);
    EXPECT_EQ(trigonometry_names().size(), 3u);
    EXPECT_EQ(trigonometry_names().front(), to_string(Trigonometry::portable)) << "the default first";
}

TEST(trigonometry, an_unknown_name_is_told_with_those_that_there_are) {
    for (const char* name : {"", "fine", "Portable", "built_in"})
        EXPECT_THAT(error_of([&] { parse_trigonometry(name); }),
                    AllOf(HasSubstr(fmt::format("\"{}\"", name)), HasSubstr("portable"),
                          HasSubstr("built-in"), HasSubstr("coarse")));
}

TEST(trigonometry, every_mode_defines_all_functions_and_only_the_portable_one_includes_ours) {
    for (const Trigonometry mode : {Trigonometry::portable, Trigonometry::built_in, Trigonometry::coarse}) {
        const std::string source = trigonometry_source(mode);
        const char* user = R"(
#include "integral/trigonometry.glslh"
layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Data { float x, s, c, e; vec2 t; };
void main() { s = sine(x), c = cosine(x), e = exponential(x), t = turn(x); }
)";
        EXPECT_NO_THROW(glsl::compile_anew(kernel_sources(testing::kernels_folder(), {}, mode), user, "user",
                                           glsl::Stage::compute))
            << to_string(mode);
        if (mode == Trigonometry::portable)
            EXPECT_THAT(source, AllOf(HasSubstr("#include"), Not(HasSubstr(" sin("))));
        else
            EXPECT_THAT(source, AllOf(Not(HasSubstr("#include")), HasSubstr("sin("))) << to_string(mode);
    }
}

} // namespace
} // namespace gnomon
