#include "casegen/kernel_case.h"

#include "casegen/catalogue.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

namespace gnomon {
namespace {

using ::testing::ElementsAre;

TEST(kernel_case, signature_comes_from_the_reference) {
    const Reference r = [](glm::dvec3 v, int n, bool b, unsigned u, glm::bvec2 w) {
        return glm::dvec2(v.x * n + (b ? 1 : 0), u + (w.y ? 0.5 : 0.0));
    };
    EXPECT_EQ(glsl_name(r.result), "vec2");
    std::vector<std::string> names;
    for (const Type& type : r.parameters) names.push_back(glsl_name(type));
    EXPECT_THAT(names, ElementsAre("vec3", "int", "bool", "uint", "bvec2"));
    EXPECT_FALSE(r.takes_mask);
    Arguments arguments;
    arguments.numbers = {2, 0, 0, -3, 1, 7, 0, 1};
    const Numbers result = r.call(arguments);
    EXPECT_EQ(result[0], -5);
    EXPECT_EQ(result[1], 7.5);
}

TEST(kernel_case, a_mask_is_no_parameter) {
    const Reference r = [](const Mask& mask, glm::ivec2 texel) { return mask.lit(texel.x, texel.y); };
    EXPECT_TRUE(r.takes_mask);
    ASSERT_EQ(r.parameters.size(), 1u);
    EXPECT_EQ(glsl_name(r.parameters[0]), "ivec2");
    Arguments arguments;
    const Mask mask = parse_mask(".#", '/', "m");
    arguments.mask = &mask;
    arguments.numbers = {1, 0};
    EXPECT_EQ(r.call(arguments)[0], 0);
}

TEST(kernel_case, columns_are_named_after_components) {
    EXPECT_THAT(columns(find_case("smsr/case_09")), ElementsAre("p_x", "p_y", "along_x"));
    EXPECT_THAT(columns(find_case("smsr/visibility")),
                ElementsAre("mask", "outside", "texel_x", "texel_y", "p_x", "p_y"));
    EXPECT_EQ(word_count(find_case("smsr/visibility")), 4u);
    EXPECT_EQ(function_name(find_case("smsr/case_09")), "smsr_case_09");
}

TEST(kernel_case, domain_borders_are_inside_and_nan_is_not) {
    const Case& c = find_case("smsr/case_09");
    const auto inside = [&](double x, double y, double along) {
        Arguments arguments;
        arguments.numbers = {x, y, along};
        return in_domain(c, arguments);
    };
    EXPECT_TRUE(inside(0, 1, 0));
    EXPECT_TRUE(inside(-0.0, 1, 1));
    EXPECT_FALSE(inside(0, 1, std::nextafter(1.0, 2.0)));
    EXPECT_FALSE(inside(-std::numeric_limits<double>::denorm_min(), 1, 0));
    EXPECT_FALSE(inside(std::nan(""), 0.5, 0.5));
    EXPECT_FALSE(inside(0.5, 0.5, HUGE_VAL));
}

TEST(kernel_case, choices_are_whole_values) {
    const Case& walk = find_case("revectorize/walk");
    const auto inside = [&](double heading_x, double heading_y) {
        Arguments arguments;
        arguments.numbers = {0, 0, 1, 2, heading_x, heading_y};
        return in_domain(walk, arguments);
    };
    EXPECT_TRUE(inside(-1, 0));
    EXPECT_TRUE(inside(0, 1));
    EXPECT_FALSE(inside(1, 1)); // each component is one of the choices', the pair is not
    EXPECT_FALSE(inside(0, 0));
}

TEST(kernel_case, words_come_back) {
    EXPECT_EQ(narrow(Scalar::float32, widen(Scalar::float32, 0x80000000u)), 0x80000000u);
    EXPECT_EQ(narrow(Scalar::int32, widen(Scalar::int32, 0xfffffffeu)), 0xfffffffeu);
    EXPECT_EQ(widen(Scalar::int32, 0xffffffffu), -1);
    EXPECT_EQ(narrow(Scalar::uint32, widen(Scalar::uint32, 0xffffffffu)), 0xffffffffu);
    EXPECT_EQ(narrow(Scalar::boolean, 3.0), 1u);
    EXPECT_EQ(narrow(Scalar::float32, 0.1), std::bit_cast<std::uint32_t>(0.1f));
}

TEST(kernel_case, tolerances_are_told) {
    EXPECT_EQ(to_string(exact()), "exact");
    EXPECT_EQ(to_string(ulps(2)), "2 ulp");
    EXPECT_EQ(to_string(absolute(0.5)), "0.5 absolute");
    EXPECT_EQ(to_string(input_within(0.25)), "input within 0.25");
}

} // namespace
} // namespace gnomon
