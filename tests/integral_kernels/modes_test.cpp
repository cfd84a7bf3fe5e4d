// Sine, cosine and exp from elsewhere than kernels/integral/elementary; and those there, operation by
// operation.
#include "casegen/measure/accuracy.h"
#include "tests/integral_kernels/rows.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <set>

namespace gnomon {
namespace {

using testing::Row;
using testing::run_rows;

class modes : public ::testing::Test {
protected:
    static measure::Quantiles error(Trigonometry mode) {
        const Case& c = find_case("integral/mix/radiance");
        static const measure::Inputs inputs =
            measure::draw_inputs(c, {.ordinary = 2048, .repeats = 2, .seed = default_seed(c)});
        const Outputs outputs = evaluate(
            testing::shared_device(), kernel_sources(testing::kernels_folder(), {}, mode), c, inputs.records);
        EXPECT_TRUE(outputs.complaint().empty()) << outputs.complaint();
        return summarise(c, inputs, deviations(c, inputs, outputs.words)).all.of_scale;
    }
};

TEST_F(modes, the_built_in_functions_are_about_as_good_as_ours) {
    const measure::Quantiles portable = error(Trigonometry::portable),
                             built_in = error(Trigonometry::built_in);
    RecordProperty("portable", fmt::format("{:.3g}", portable.median));
    RecordProperty("built-in", fmt::format("{:.3g}", built_in.median));
    EXPECT_LT(built_in.median, 3 * portable.median);
    EXPECT_GT(built_in.median, portable.median / 3);
    EXPECT_EQ(built_in.non_finite, 0u);
}

TEST_F(modes, functions_as_coarse_as_they_may_be_cost_what_they_are_off) {
    const measure::Quantiles coarse = error(Trigonometry::coarse);
    RecordProperty("coarse", fmt::format("{:.3g}", coarse.median));
    EXPECT_GT(coarse.median, 1e-4);
    EXPECT_LT(coarse.median, 1e-2);
    EXPECT_EQ(coarse.non_finite, 0u);
}

// --- The same operations on this machine: one rounding each, none left out or fused.

struct Quarter {
    float rest;
    unsigned quadrant;
};
Quarter reduce(float x) {
    if (!(std::abs(x) <= 65536.0f)) return {0, 0};
    const float count = std::floor(x * 0.636619772f + 0.5f);
    const float rest =
        ((x - count * 1.5703125f) - count * 4.837512969970703125e-4f) - count * 7.549789948768648e-8f;
    return {rest, static_cast<unsigned>(static_cast<int>(count)) & 3u};
}
float sine_near_0(float x) {
    const float z = x * x;
    const float sum = ((2.75573192e-6f * z - 1.98412698e-4f) * z + 8.33333333e-3f) * z - 0.166666667f;
    return x + x * z * sum;
}
float cosine_near_0(float x) {
    const float z = x * x;
    const float sum = ((-2.75573192e-7f * z + 2.48015873e-5f) * z - 1.38888889e-3f) * z + 4.16666667e-2f;
    return 1.0f - (0.5f * z - z * z * sum);
}
float sine(float x) {
    const auto [rest, quadrant] = reduce(x);
    const float value = (quadrant & 1u) == 0 ? sine_near_0(rest) : cosine_near_0(rest);
    return (quadrant & 2u) == 0 ? value : -value;
}
float cosine(float x) {
    const auto [rest, quadrant] = reduce(x);
    const float value = (quadrant & 1u) == 0 ? cosine_near_0(rest) : -sine_near_0(rest);
    return (quadrant & 2u) == 0 ? value : -value;
}
float exponential(float x) {
    const float within = x >= -104.0f ? std::min(x, 88.72f) : x < -104.0f ? -104.0f : 0.0f;
    const float count = std::floor(within * 1.44269504f + 0.5f);
    const float r = (within - count * 0.693359375f) + count * 2.12194440e-4f;
    const float sum =
        ((((1.98412698e-4f * r + 1.38888889e-3f) * r + 8.33333333e-3f) * r + 4.16666667e-2f) * r +
         0.166666667f) *
            r +
        0.5f;
    const float power = 1.0f + (r + r * r * sum);
    const int half = static_cast<int>(count) >> 1;
    const float scale = std::ldexp(1.0f, half), other = std::ldexp(1.0f, static_cast<int>(count) - half);
    return power * scale * other;
}

std::vector<Row> arguments_of(double most) {
    std::vector<Row> rows;
    Random random(51);
    for (int i = 0; i < 200'000; ++i)
        rows.push_back({static_cast<float>(most * (2 * random.unit() - 1) *
                                           (i % 2 == 0 ? 1 : std::pow(random.unit(), 8)))});
    for (int i = 0; i < 100'000; ++i)
        rows.push_back({std::bit_cast<float>(static_cast<std::uint32_t>(random.bits()))});
    std::erase_if(rows,
                  [](const Row& row) { return !(std::abs(row[0]) >= 0x1p-126f); }); // NaN, and denormals
    return rows;
}

void expect_same_bits(const char* kernel, double most, float (*replay)(float)) {
    const std::vector<Row> rows = arguments_of(most);
    const std::vector<float> results = run_rows(kernel, rows);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const float want = replay(rows[i][0]);
        // A device may flush a denormal result to zero.
        if (std::abs(want) < 0x1p-126f) continue;
        ASSERT_TRUE(testing::same_bits(results[i], want))
            << fmt::format("{}({:a}) is {:a}, and {:a} in C++", kernel, rows[i][0], results[i], want);
    }
}

TEST(elementary, functions_are_the_same_bits_as_the_same_operations_in_cpp) {
    expect_same_bits("integral/elementary/sin", 8192, sine);
    expect_same_bits("integral/elementary/cos", 8192, cosine);
    expect_same_bits("integral/elementary/exp", 104, exponential);
}

TEST(elementary, turn_is_the_cosine_and_the_sine) {
    const std::vector<Row> rows = arguments_of(8192);
    const std::vector<float> turned = run_rows("integral/elementary/turn", rows);
    const std::vector<float> cosines = run_rows("integral/elementary/cos", rows);
    const std::vector<float> sines = run_rows("integral/elementary/sin", rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        ASSERT_TRUE(turned[2 * i] == cosines[i] && turned[2 * i + 1] == sines[i]) << rows[i][0];
}

TEST(elementary, sine_is_odd_and_cosine_even_to_the_last_bit) {
    std::vector<Row> rows = arguments_of(8192), negated = rows;
    for (Row& row : negated) row[0] = -row[0];
    for (const auto& [kernel, sign] :
         {std::pair{"integral/elementary/sin", -1.0f}, std::pair{"integral/elementary/cos", 1.0f}}) {
        const std::vector<float> one = run_rows(kernel, rows), other = run_rows(kernel, negated);
        std::size_t different = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) different += one[i] == sign * other[i] ? 0 : 1;
        // Half way between two multiples of π/2 either of them may be taken off.
        EXPECT_LT(different, 10u) << kernel;
    }
}

// What a compiler may fuse to one rounding gives other bits on other devices.
TEST(elementary, no_product_may_be_fused_with_a_sum) {
    constexpr std::uint32_t decorate = 71, no_contraction = 42, add = 129, subtract = 131, multiply = 133;
    for (const char* name : {"sin", "cos", "turn", "exp"}) {
        const Case& c = find_case(fmt::format("integral/elementary/{}", name));
        const glsl::Spirv words = compile_standalone(c, kernel_sources(testing::kernels_folder()));
        std::set<std::uint32_t> kept, products;
        const auto for_each = [&](auto&& visit) { // (opcode, words of the instruction), behind the header
            for (std::size_t at = 5; at < words.size(); at += words[at] >> 16)
                visit(words[at] & 0xffffu, std::span(words).subspan(at, words[at] >> 16));
        };
        for_each([&](std::uint32_t op, std::span<const std::uint32_t> instruction) {
            if (op == decorate && instruction[2] == no_contraction) kept.insert(instruction[1]);
            if (op == multiply) products.insert(instruction[2]);
        });
        for_each([&](std::uint32_t op, std::span<const std::uint32_t> instruction) {
            if (op != add && op != subtract) return;
            const bool of_product = products.contains(instruction[3]) || products.contains(instruction[4]);
            EXPECT_TRUE(!of_product || kept.contains(instruction[2])) << c.name;
        });
        EXPECT_FALSE(products.empty()) << c.name;
    }
}

} // namespace
} // namespace gnomon
