// Which results differ, by how much, and where in the domain: on results that are made up.
#include "casegen/versus/difference.h"

#include "casegen/catalogue.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

namespace gnomon::versus {
namespace {

using testing::bits;

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr std::uint32_t nan = 0x7fc00000u, other_nan = 0xffc00001u;

ResultDifference of_floats(std::uint32_t a, std::uint32_t b) {
    return difference_of({Scalar::float32, 1}, std::array{a}, std::array{b});
}

TEST(difference, the_same_bits_do_not_differ) {
    for (const std::uint32_t word : {bits(0.f), bits(-0.f), bits(1.5f), bits(infinity), nan, 1u}) {
        EXPECT_FALSE(of_floats(word, word).differs);
        EXPECT_FALSE(of_floats(word, word).other_nan);
    }
}

TEST(difference, any_other_bits_do) {
    const ResultDifference next = of_floats(bits(1.f), bits(1.f) + 1);
    EXPECT_TRUE(next.differs);
    EXPECT_EQ(next.absolute, 0x1p-23);
    EXPECT_EQ(next.change, 0x1p-23);
    EXPECT_EQ(next.ulps, 1);
    EXPECT_EQ(of_floats(bits(1.f) + 1, bits(1.f)).change, -0x1p-23);
    EXPECT_EQ(of_floats(1u, 0x80000001u).ulps, 2) << "denormals on either side of 0";
    const ResultDifference zero = of_floats(bits(0.f), bits(-0.f));
    EXPECT_TRUE(zero.differs);
    EXPECT_EQ(zero.absolute, 0);
    EXPECT_EQ(zero.ulps, 0);
    EXPECT_FALSE(zero.finiteness);
}

TEST(difference, nan_is_any_other_nan_and_nothing_else) {
    EXPECT_FALSE(of_floats(nan, other_nan).differs);
    EXPECT_TRUE(of_floats(nan, other_nan).other_nan);
    for (const float value : {0.f, 1.f, infinity, -infinity})
        for (const bool swapped : {false, true}) {
            const ResultDifference one = swapped ? of_floats(bits(value), nan) : of_floats(nan, bits(value));
            EXPECT_TRUE(one.differs) << value;
            EXPECT_TRUE(one.finiteness) << value;
            EXPECT_TRUE(std::isinf(one.absolute)) << value;
            EXPECT_TRUE(std::isinf(one.ulps)) << value;
        }
}

TEST(difference, infinities_differ_from_finite_and_from_each_other) {
    for (const float value : {-infinity, 3e38f, 0.f}) {
        EXPECT_TRUE(of_floats(bits(infinity), bits(value)).finiteness) << value;
        EXPECT_TRUE(std::isinf(of_floats(bits(infinity), bits(value)).absolute)) << value;
    }
}

TEST(difference, of_vectors_is_that_of_the_farthest_component) {
    const std::array a{bits(1.f), bits(2.f), nan}, b{bits(1.5f), bits(0.f), other_nan};
    const ResultDifference one = difference_of({Scalar::float32, 3}, a, b);
    EXPECT_TRUE(one.differs);
    EXPECT_FALSE(one.other_nan) << "the other components differ";
    EXPECT_EQ(one.absolute, 2);
    EXPECT_EQ(one.change, -2);
}

TEST(difference, of_whole_numbers_has_no_ulps) {
    const ResultDifference one = difference_of({Scalar::int32, 1}, std::array{0xffffffffu}, std::array{2u});
    EXPECT_EQ(one.absolute, 3);
    EXPECT_EQ(one.ulps, 0);
    EXPECT_EQ(difference_of({Scalar::uint32, 1}, std::array{0xffffffffu}, std::array{0u}).absolute,
              4294967295);
}

/// smsr/case_09 takes p and along_x: three floats.
class differences : public ::testing::Test {
protected:
    void add(float x, float y, float along, std::uint32_t a, std::uint32_t b, bool in_domain = true) {
        records_.add(std::array{bits(x), bits(y), bits(along)}, nullptr);
        defined_.push_back(in_domain ? 1 : 0);
        a_.push_back(a);
        b_.push_back(b);
    }
    Difference made() const { return versus::difference(case_, records_, defined_, a_, b_); }

    const Case& case_ = find_case("smsr/case_09");
    Records records_{case_};
    std::vector<std::uint8_t> defined_;
    std::vector<std::uint32_t> a_, b_;
};

TEST_F(differences, are_counted_by_kind_and_place) {
    add(0.f, 0.f, 0.5f, bits(1.f), bits(1.f));
    add(0.2f, 0.1f, 0.5f, bits(1.f), bits(0.f));
    add(0.3f, 0.9f, 0.5f, bits(0.f), bits(-0.f));
    add(0.25f, 0.5f, 0.5f, bits(1.f), bits(1.f));
    add(1.f, 1.f, 0.5f, nan, other_nan);
    add(9.f, 9.f, 9.f, nan, bits(1.f), false);
    const Difference d = made();
    EXPECT_EQ(d.samples, 6u);
    EXPECT_EQ(d.defined, 5u);
    EXPECT_EQ(d.differ, 3u);
    EXPECT_EQ(d.differ_defined, 2u);
    EXPECT_EQ(d.finiteness, 1u);
    EXPECT_EQ(d.zeros, 1u);
    EXPECT_EQ(d.other_nan, 1u);
    EXPECT_EQ(d.worst, 1u) << "in the domain before what is worse outside";
    EXPECT_EQ(d.absolute, 1);
    ASSERT_EQ(d.where.size(), 3u);
    EXPECT_EQ(d.where[0].name, "p.x");
    EXPECT_FLOAT_EQ(static_cast<float>(d.where[0].from), 0.2f);
    EXPECT_FLOAT_EQ(static_cast<float>(d.where[0].to), 0.3f);
    EXPECT_EQ(d.where[0].inside, 3u) << "0.25 lies there too, and does not differ";
    EXPECT_EQ(d.where[0].sampled_to, 1);
    EXPECT_EQ(d.where[2].name, "along_x");
}

TEST_F(differences, outside_the_domain_alone_have_a_worst_but_no_place) {
    add(0.f, 0.f, 0.f, bits(1.f), bits(1.f));
    add(2.f, 0.f, 0.f, bits(1.f), bits(0.5f), false);
    add(3.f, 0.f, 0.f, bits(1.f), bits(0.f), false);
    const Difference d = made();
    EXPECT_EQ(d.differ, 2u);
    EXPECT_EQ(d.differ_defined, 0u);
    EXPECT_EQ(d.worst, 2u);
    EXPECT_TRUE(d.where.empty());
}

TEST_F(differences, nothing_differs_in_equal_results) {
    for (int i = 0; i < 100; ++i) add(0.01f * static_cast<float>(i), 0.f, 0.f, bits(1.f), bits(1.f));
    EXPECT_EQ(made().differ, 0u);
}

TEST(difference, is_told_by_value_where_there_are_few) {
    // uvec2 sides of masks: whole numbers.
    for (const Family& family : catalogue())
        for (const Case& c : family.cases) {
            const std::vector<Component> components = components_of(c);
            ASSERT_EQ(components.size(), word_count(c)) << c.name;
        }
    const Case& c = find_case("rsmss/number");
    Records records(c);
    const Mask mask(4, 4, true);
    std::vector<std::uint32_t> a, b;
    for (std::uint32_t x = 0; x < 4; ++x)
        for (std::uint32_t y = 0; y < 4; ++y) {
            records.add(std::array{x, y}, &mask);
            a.push_back(0);
            b.push_back(x == 2 ? 1 : 0);
        }
    const Difference d = difference(c, records, std::vector<std::uint8_t>(16, 1), a, b);
    EXPECT_EQ(d.differ, 4u);
    ASSERT_EQ(d.where.size(), 2u);
    ASSERT_EQ(d.where[0].values.size(), 4u);
    EXPECT_EQ(d.where[0].values[2].value, "2");
    EXPECT_EQ(d.where[0].values[2].differ, 4u);
    EXPECT_EQ(d.where[0].values[1].differ, 0u);
    for (const ValueShare& share : d.where[1].values) EXPECT_EQ(share.differ, 1u);
}

} // namespace
} // namespace gnomon::versus
