// How well float32 inputs determine a truth, against differences of truths at inputs that are moved.
#include "casegen/reference/integral/truth.h"
#include "runtime/files.h"
#include "tests/integral/inputs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace gnomon::testing {
namespace {

namespace ri = reference::integral;
using TruthOf = Truth (*)(const Arguments&);

/// Σ |x_i ∂_i value| · 2⁻²⁴ by central differences. `step`: how far each input is moved, by which the value
/// must change smoothly.
double by_differences(TruthOf truth, const Arguments& x, std::size_t count, double step,
                      std::size_t component) {
    double sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Arguments more = x, less = x;
        const double by = std::max(step, 1e-9 * std::abs(x.numbers[i]));
        more.numbers[i] += by;
        less.numbers[i] -= by;
        const double change = truth(more).value[component] - truth(less).value[component];
        sum += std::abs(x.numbers[i] * change / (more.numbers[i] - less.numbers[i]));
    }
    return sum * 0x1p-24;
}

struct Conditioned {
    const char* name;
    TruthOf truth;
    std::shared_ptr<const Generator> (*inputs)();
    std::size_t count;
    std::size_t components = 1;
};

template <stiffness::Trailing trailing>
std::shared_ptr<const Generator> cells() {
    return stiffness::boundary_cells(trailing);
}
template <int phases, bool wave>
std::shared_ptr<const Generator> waves() {
    return stiffness::waves(phases, wave);
}
using stiffness::Trailing;

const Conditioned all[] = {
    {"c0", ri::c0, waves<0, false>, 2},
    {"c1", ri::c1, waves<1, false>, 3},
    {"c2", ri::c2, waves<0, true>, 4},
    {"c3", ri::c3, waves<1, false>, 3},
    {"c4", ri::c4, waves<1, true>, 5},
    {"c5", ri::c5, waves<2, true>, 6},
    {"a0", ri::a0, cells<Trailing::angle>, 6},
    {"a1", ri::a1, cells<Trailing::nothing>, 5},
    {"a", ri::a, cells<Trailing::vector>, 8},
    {"b0", ri::b0, cells<Trailing::two_angles>, 7},
    {"b1", ri::b1, cells<Trailing::angle>, 6},
    {"b2", ri::b2, cells<Trailing::angle>, 6},
    {"b3", ri::b3, cells<Trailing::nothing>, 5},
    {"b", ri::b, cells<Trailing::two_vectors>, 11},
    {"radiance", ri::radiance, stiffness::lit_cells, 15},
    {"r0", ri::fit_r0, stiffness::lobes, 4},
    {"r1", ri::fit_r1, stiffness::lobes, 4},
    {"alpha", ri::fit_alpha, stiffness::lobes, 4},
    {"beta", ri::fit_beta, stiffness::lobes, 4},
    {"l2", ri::fit_l2, stiffness::lobes, 4},
    {"l1", ri::fit_l1, stiffness::lobes, 4},
    {"r0_of_ends", ri::fit_r0_of_ends, stiffness::lobes_of_ends, 4},
    {"r1_of_ends", ri::fit_r1_of_ends, stiffness::lobes_of_ends, 4},
    {"alpha_of_ends", ri::fit_alpha_of_ends, stiffness::lobes_of_ends, 4},
    {"beta_of_ends", ri::fit_beta_of_ends, stiffness::lobes_of_ends, 4},
};

class Conditioning : public ::testing::TestWithParam<Conditioned> {};
TEST_P(Conditioning, is_what_differences_say) {
    const Conditioned& q = GetParam();
    const auto generator = q.inputs();
    int compared = 0;
    for (int i = 0; i < 60; ++i) {
        Random random(hash(q.name), static_cast<std::uint64_t>(i));
        Arguments x{};
        generator->draw(random, x.numbers);
        round_to_float(x);
        // A step that is small to the sharpest lobe, and large to the doubles that values are.
        double least = 1;
        for (std::size_t k = 0; k < q.count; ++k)
            if (x.numbers[k] != 0)
                least = std::min({least, std::abs(x.numbers[k]), 1 / std::abs(x.numbers[k])});
        if (q.count == 4 && q.inputs != waves<0, true>) // a lobe's interval may be narrow far from 0
            least = std::min(least, std::abs(x.numbers[0] - x.numbers[1]));
        const double step = 1e-5 * least;
        const Truth truth = q.truth(x);
        const double wanted = by_differences(q.truth, x, q.count, step, 0);
        const double noise =
            0x1p-24 * 0x1p-50 * std::max(std::abs(truth.value[0]), 1e-3 * truth.scale) / step * 1000;
        EXPECT_NEAR(truth.conditioning[0], wanted, 1e-3 * wanted + noise) << i;
        compared += noise < 0.1 * wanted;
    }
    EXPECT_GT(compared, 30);
}
INSTANTIATE_TEST_SUITE_P(, Conditioning, ::testing::ValuesIn(all),
                         [](const auto& of) { return std::string(of.param.name); });

class Scale : public ::testing::TestWithParam<Conditioned> {};
TEST_P(Scale, is_no_less_than_the_value) {
    const Conditioned& q = GetParam();
    for_each_input(*q.inputs(), 40, 3, [&](const Arguments& x, const std::string& from) {
        const Truth truth = q.truth(x);
        EXPECT_LE(std::abs(truth.value[0]), truth.scale * (1 + 1e-6)) << from;
        EXPECT_TRUE(std::isfinite(truth.conditioning[0]) && truth.conditioning[0] >= 0) << from;
    });
}
INSTANTIATE_TEST_SUITE_P(, Scale, ::testing::ValuesIn(all),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(truth, is_none_of_inputs_that_are_not_finite) {
    for (const Conditioned& q : all) {
        Arguments x{};
        Random random(1);
        q.inputs()->draw(random, x.numbers);
        for (std::size_t i = 0; i < q.count; ++i)
            for (const double bad :
                 {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
                Arguments y = x;
                y.numbers[i] = bad;
                EXPECT_TRUE(std::isnan(q.truth(y).value[0])) << q.name << " " << i;
            }
    }
}

} // namespace
} // namespace gnomon::testing
