// Shrinking with failures that are known: what is left must be what an author would write.
#include "casegen/fuzz/shrink.h"

#include "casegen/catalogue.h"
#include "tests/support/text.h"

#include <gtest/gtest.h>

#include <bit>
#include <functional>

namespace gnomon::fuzz {
namespace {

using testing::bits;

using Fails = std::function<bool(const Input&)>;

Shrunk shrink_while(const Case& c, const Input& input, const Fails& fails) {
    EXPECT_TRUE(fails(input)) << "the input must fail";
    return shrink(c, input, [&](std::span<const Input> candidates) {
        std::vector<bool> each;
        for (const Input& candidate : candidates) each.push_back(fails(candidate));
        return each;
    });
}

float number(const Input& input, std::size_t word) { return std::bit_cast<float>(input.words[word]); }
int whole(const Input& input, std::size_t word) { return std::bit_cast<std::int32_t>(input.words[word]); }

TEST(shrink, what_always_fails_shrinks_to_zeros) {
    const Case& c = find_case("smsr/case_09");
    const Input input{{bits(0.12345f), bits(0.9f), bits(0.777f)}, {}};
    EXPECT_EQ(shrink_while(c, input, [](const Input&) { return true; }).input.words,
              (std::vector<std::uint32_t>{0, 0, 0}));
}

TEST(shrink, a_threshold_shrinks_to_a_short_number_beyond_it) {
    const Case& c = find_case("smsr/case_09");
    const Input input{{bits(0.71234f), bits(0.3f), bits(0.6f)}, {}};
    const Shrunk shrunk =
        shrink_while(c, input, [](const Input& i) { return number(i, 0) > 0.3f && number(i, 0) < 0.9f; });
    EXPECT_EQ(number(shrunk.input, 0), 0.5f);
    EXPECT_EQ(number(shrunk.input, 1), 0);
}

TEST(shrink, numbers_that_only_fail_together_shrink_together) {
    const Case& c = find_case("smsr/case_09");
    const Input input{{bits(0.71234f), bits(0.28766f), bits(0.6f)}, {}};
    const Shrunk shrunk = shrink_while(c, input, [](const Input& i) {
        const float sum = number(i, 0) + number(i, 1);
        return sum > 0.999f && sum < 1.001f;
    });
    EXPECT_LE(complexity(c, shrunk.input), 1) << "1 + 0, or 0.5 twice";
}

TEST(shrink, nan_stays_nan_where_only_nan_fails) {
    const Case& c = find_case("smsr/case_09");
    const Input input{{bits(0.7f), 0x7fc12345u, bits(0.6f)}, {}};
    const Shrunk shrunk = shrink_while(c, input, [](const Input& i) { return std::isnan(number(i, 1)); });
    EXPECT_TRUE(std::isnan(number(shrunk.input, 1)));
    EXPECT_EQ(number(shrunk.input, 0), 0);
}

/// Lit, with shadow at +x.
bool lit_before_shadow(const Input& i) {
    const int x = whole(i, 0), y = whole(i, 1);
    return i.mask.lit(x, y) && !i.mask.lit(x + 1, y);
}

TEST(shrink, a_mask_shrinks_to_the_texels_that_matter) {
    const Case& c = find_case("smsr/visibility");
    Input input{{9, 7, bits(0.3f), bits(0.6f)}, Mask(32, 20)};
    for (int y = 0; y < 20; ++y)
        for (int x = 10; x < 32; ++x) input.mask.set(x, y, (x * y) % 3 == 0);
    input.mask.set(10, 7, false);
    const Shrunk shrunk = shrink_while(c, input, lit_before_shadow);
    EXPECT_EQ(shrunk.input.mask.texels.size(), 1u) << format_mask(shrunk.input.mask, '\n');
    EXPECT_TRUE(lit_before_shadow(shrunk.input));
}

TEST(shrink, mask_and_point_that_must_change_together_do) {
    // Dark to the left for n texels in a row, and p.x close to n / 8: no step of mask or point alone keeps
    // it.
    const auto fails = [](const Input& i) {
        const int x = whole(i, 0), y = whole(i, 1);
        if (!i.mask.lit(x, y)) return false;
        int run = 0;
        while (run < 20 && x - run - 1 >= 0 && !i.mask.lit(x - run - 1, y)) ++run;
        return run > 0 && std::abs(number(i, 2) - static_cast<float>(run) / 8) < 0.01f;
    };
    const Case& c = find_case("smsr/visibility");
    Input input{{7, 2, bits(0.751f), bits(0.6f)}, Mask(12, 6)};
    for (int x = 1; x < 7; ++x) input.mask.set(x, 2, false);
    const Shrunk shrunk = shrink_while(c, input, fails);
    EXPECT_LE(shrunk.input.mask.texels.size(), 9u) << format_mask(shrunk.input.mask, '\n');
    EXPECT_TRUE(fails(shrunk.input));
}

TEST(shrink, depends_on_nothing_but_its_input) {
    const Case& c = find_case("smsr/visibility");
    Input input{{9, 7, bits(0.3f), bits(0.6f)}, Mask(32, 20)};
    input.mask.set(10, 7, false);
    const Shrunk first = shrink_while(c, input, lit_before_shadow);
    const Shrunk second = shrink_while(c, input, lit_before_shadow);
    EXPECT_EQ(first.input.words, second.input.words);
    EXPECT_EQ(first.input.mask, second.input.mask);
    EXPECT_EQ(first.tried, second.tried);
}

TEST(shrink, never_asks_for_more_than_it_may_and_ends) {
    const Case& c = find_case("smsr/visibility");
    const Input input{{9, 7, bits(0.3f), bits(0.6f)}, Mask(48, 48)};
    std::size_t most = 0, asked = 0;
    const ShrinkOptions options{.candidates = 100, .rounds = 7, .small_masks_at_once = 0};
    shrink(
        c, input,
        [&](std::span<const Input> candidates) {
            most = std::max(most, candidates.size());
            ++asked;
            return std::vector<bool>(candidates.size(), false);
        },
        options);
    EXPECT_LE(most, 100u);
    EXPECT_LE(asked, 7u);
    EXPECT_GE(asked, 2u);
}

TEST(complexity, orders_numbers_as_people_would) {
    const Case& c = find_case("nsm/visibility");
    ASSERT_TRUE(c.reference.takes_mask);
    const auto of = [&](float value) { return complexity(c, {{0, 0, bits(value), 0}, Mask(1, 1)}); };
    const float inf = std::numeric_limits<float>::infinity();
    EXPECT_LT(of(0), of(1));
    EXPECT_LT(of(1), of(0.5f));
    EXPECT_LT(of(0.5f), of(0.75f));
    EXPECT_LT(of(0.75f), of(0.1f));
    EXPECT_LT(of(0.1f), of(-0.1f));
    EXPECT_LT(of(0.1f), of(inf));
    EXPECT_LT(of(inf), of(std::numeric_limits<float>::quiet_NaN()));
}

} // namespace
} // namespace gnomon::fuzz
