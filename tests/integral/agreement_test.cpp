// The quadratures against the closed forms, to 25 digits of the integral of the integrand's absolute value.
#include "casegen/reference/integral/truth.h"
#include "casegen/reference/integral/values.h"
#include "casegen/reference/integral/wave.h"
#include "runtime/files.h"
#include "tests/integral/closed_forms.h"
#include "tests/integral/inputs.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace gnomon::testing {
namespace {

namespace ri = reference::integral;
using closed::Digits;
using ri::Effort;
using ri::Real;
using ri::Wide;

constexpr double agreed = 1e-25;
/// Another order of the same quadrature.
constexpr Effort more{.digits = 33, .extra = 7};
constexpr double orders_agreed = 1e-28;

template <typename R>
Digits wide(const R& x) {
    return Digits(x);
}

/// |a - b| as a part of `scale`.
template <typename A, typename B>
double difference(const A& a, const B& b, double scale) {
    const Digits off = abs(wide(a) - wide(b));
    return off == 0 ? 0 : static_cast<double>(Digits(off / Digits(scale)));
}

std::string show(const Arguments& x, std::size_t count) {
    std::string text;
    for (std::size_t i = 0; i < count; ++i) text += fmt::format("{}{:.9g}", i ? ", " : "", x.numbers[i]);
    return text;
}

/// A truth is its value in digits, rounded.
void expect_rounded(const Truth& truth, const Digits& value, const std::string& what) {
    const double off = difference(truth.value[0], value, 1);
    EXPECT_LE(off, 0x1p-53 * std::abs(truth.value[0]) * (1 + 1e-9) + 1e-300) << what;
}

// --- Waves
// --------------------------------------------------------------------------------------------------------

template <ri::Wave wave>
using WaveNumbers = std::array<Real, 2 + ri::phases_of(wave)>;

template <ri::Wave wave, typename Closed>
void expect_wave(Truth (*truth_of)(const Arguments&), const Closed& closed_form) {
    constexpr int phases = wave == ri::Wave::c1 || wave == ri::Wave::c3 || wave == ri::Wave::c4 ? 1
                           : wave == ri::Wave::c5                                               ? 2
                                                                                                : 0;
    constexpr bool has_s = wave == ri::Wave::c2 || wave == ri::Wave::c4 || wave == ri::Wave::c5;
    int inputs = 0;
    for_each_input(*stiffness::waves(phases, has_s), 30, 1, [&](const Arguments& x, const std::string& from) {
        WaveNumbers<wave> numbers;
        std::array<Digits, 6> wide_numbers;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = x.numbers[i];
            wide_numbers[i] = x.numbers[i];
        }
        if (has_s) {
            const double s = std::abs(x.numbers[2 + phases]);
            if (s == 0 || s == 2 || (s == 1 && x.numbers[2 + phases] < 0)) return; // on a singularity
        }
        if (x.numbers[0] == x.numbers[1]) return;
        const Truth truth = truth_of(x);
        const Real value = ri::wave_integral<wave>(numbers).value;
        const std::string what = from + ": " + show(x, numbers.size());
        const Digits want = closed_form(wide_numbers);
        EXPECT_LE(difference(value, want, truth.scale), agreed) << what;
        EXPECT_LE(difference(ri::wave_integral<wave>(numbers, more).value, value, truth.scale), orders_agreed)
            << what;
        expect_rounded(truth, wide(value), what);
        ++inputs;
    });
    EXPECT_GT(inputs, 50);
}

using Six = const std::array<Digits, 6>&;
TEST(integral_agreement, c0) {
    expect_wave<ri::Wave::c0>(ri::c0, [](Six x) { return closed::c0(x[0], x[1]); });
}
TEST(integral_agreement, c1) {
    expect_wave<ri::Wave::c1>(ri::c1, [](Six x) { return closed::c1(x[0], x[1], x[2]); });
}
TEST(integral_agreement, c2) {
    expect_wave<ri::Wave::c2>(ri::c2, [](Six x) { return closed::c2(x[0], x[1], x[2], x[3]); });
}
TEST(integral_agreement, c3) {
    expect_wave<ri::Wave::c3>(ri::c3, [](Six x) { return closed::c3(x[0], x[1], x[2]); });
}
TEST(integral_agreement, c4) {
    expect_wave<ri::Wave::c4>(ri::c4, [](Six x) { return closed::c4(x[0], x[1], x[2], x[3], x[4]); });
}
TEST(integral_agreement, c5) {
    expect_wave<ri::Wave::c5>(ri::c5, [](Six x) { return closed::c5(x[0], x[1], x[2], x[3], x[4], x[5]); });
}

// --- Cells
// --------------------------------------------------------------------------------------------------------

bool is_singular(double k) { return k == 0 || std::abs(k) == 0.5 || std::abs(k) == 1 || std::abs(k) == 2; }

struct OfCell {
    const char* name;
    Truth (*truth)(const Arguments&);
    Real (*value)(const ri::Moments<Real>&, const Arguments&);
    Digits (*closed_form)(const closed::Boundary&, const Arguments&);
    stiffness::Trailing trailing;
    std::size_t count;
};

template <typename R>
std::array<R, 3> vector_at(const Arguments& x, std::size_t i) {
    return {R(x.numbers[i]), R(x.numbers[i + 1]), R(x.numbers[i + 2])};
}
std::array<Real, 3> phase_at(const Arguments& x, std::size_t i) {
    return ri::axis_of_phase(Real(x.numbers[i]));
}
const std::array<Real, 3> pole = ri::polar_axis<Real>();
using M = ri::Moments<Real>;
using Trailing = stiffness::Trailing;

const OfCell of_cell[] = {
    {"A0", ri::a0, [](const M& m, const Arguments& x) { return ri::first_moment(m, phase_at(x, 5).data()); },
     [](const closed::Boundary& c, const Arguments& x) { return closed::a0(c, x.numbers[5]); },
     Trailing::angle, 6},
    {"A1", ri::a1, [](const M& m, const Arguments&) { return ri::first_moment(m, pole.data()); },
     [](const closed::Boundary& c, const Arguments&) { return closed::a1(c); }, Trailing::nothing, 5},
    {"A", ri::a,
     [](const M& m, const Arguments& x) { return ri::first_moment(m, vector_at<Real>(x, 5).data()); },
     [](const closed::Boundary& c, const Arguments& x) { return closed::a(c, vector_at<Digits>(x, 5)); },
     Trailing::vector, 8},
    {"B0", ri::b0,
     [](const M& m, const Arguments& x) {
         return ri::second_moment(m, phase_at(x, 5).data(), phase_at(x, 6).data());
     },
     [](const closed::Boundary& c, const Arguments& x) { return closed::b0(c, x.numbers[5], x.numbers[6]); },
     Trailing::two_angles, 7},
    {"B1", ri::b1,
     [](const M& m, const Arguments& x) { return ri::second_moment(m, phase_at(x, 5).data(), pole.data()); },
     [](const closed::Boundary& c, const Arguments& x) { return closed::b1(c, x.numbers[5]); },
     Trailing::angle, 6},
    {"B2", ri::b2,
     [](const M& m, const Arguments& x) { return ri::second_moment(m, phase_at(x, 5).data(), pole.data()); },
     [](const closed::Boundary& c, const Arguments& x) { return closed::b1(c, x.numbers[5]); },
     Trailing::angle, 6},
    {"B3", ri::b3,
     [](const M& m, const Arguments&) { return ri::second_moment(m, pole.data(), pole.data()); },
     [](const closed::Boundary& c, const Arguments&) { return closed::b3(c); }, Trailing::nothing, 5},
    {"B", ri::b,
     [](const M& m, const Arguments& x) {
         return ri::second_moment(m, vector_at<Real>(x, 5).data(), vector_at<Real>(x, 8).data());
     },
     [](const closed::Boundary& c, const Arguments& x) {
         return closed::b(c, vector_at<Digits>(x, 5), vector_at<Digits>(x, 8));
     },
     Trailing::two_vectors, 11},
};

class IntegralOverCell : public ::testing::TestWithParam<OfCell> {};
TEST_P(IntegralOverCell, agrees_with_its_closed_form) {
    const OfCell& q = GetParam();
    int inputs = 0;
    for_each_input(
        *stiffness::boundary_cells(q.trailing), 30, 3, [&](const Arguments& x, const std::string& from) {
            if (is_singular(x.numbers[3]) || !stiffness::is_boundary_cell(x)) return;
            const Truth truth = q.truth(x);
            const closed::Boundary c{x.numbers[0], x.numbers[1], x.numbers[2], x.numbers[3], x.numbers[4]};
            const ri::Cell<Real> cell =
                ri::boundary_cell<Real>(x.numbers[0], x.numbers[1], x.numbers[2], x.numbers[3], x.numbers[4]);
            const Real value = q.value(ri::moments(cell), x);
            const std::string what = from + ": " + show(x, q.count);
            EXPECT_LE(difference(value, q.closed_form(c, x), truth.scale), agreed) << what;
            EXPECT_LE(difference(q.value(ri::moments(cell, more), x), value, truth.scale), orders_agreed)
                << what;
            expect_rounded(truth, wide(value), what);
            ++inputs;
        });
    EXPECT_GT(inputs, 80);
}
INSTANTIATE_TEST_SUITE_P(, IntegralOverCell, ::testing::ValuesIn(of_cell),
                         [](const auto& of) { return std::string(of.param.name); });

/// The same test must see a coefficient that is wrong in its 20th digit.
TEST(integral_agreement, notices_a_wrong_coefficient) {
    const Arguments x = arguments_of(0.25, 1.5, 0.5, 0.375, 0.75, 1, 2);
    const closed::Boundary c{x.numbers[0], x.numbers[1], x.numbers[2], x.numbers[3], x.numbers[4]};
    const Real value = ri::second_moment(ri::moments(ri::boundary_cell<Real>(0.25, 1.5, 0.5, 0.375, 0.75)),
                                         phase_at(x, 5).data(), phase_at(x, 6).data());
    const Digits printed = closed::b0(c, 1, 2);
    const Digits c4 = closed::c4(c.phi0, c.phi1, 1, 1, 2);
    const double scale = ri::b0(x).scale;
    EXPECT_LE(difference(value, printed, scale), agreed);
    EXPECT_GT(difference(value, printed + c4 * Digits("1e-20"), scale), agreed);
    EXPECT_GT(difference(value, closed::b0(c, 1, Digits(2) + Digits("1e-20")), scale), agreed);
}

// --- Lobes
// --------------------------------------------------------------------------------------------------------

Digits closed_fit(ri::Fit what, const Digits& a, const Digits& b, const Digits& lambda, const Digits& mu) {
    const closed::Fit fit = closed::fit(a, b, lambda, mu);
    switch (what) {
    case ri::Fit::r0:
        return fit.r0;
    case ri::Fit::r1:
        return fit.r1;
    case ri::Fit::alpha:
        return fit.alpha;
    case ri::Fit::beta:
        return fit.beta;
    case ri::Fit::l2:
        return closed::l2(a, b, lambda, mu);
    case ri::Fit::l1:
        break;
    }
    return 0;
}

struct OfLobe {
    const char* name;
    ri::Fit what;
    Truth (*truth)(const Arguments&);
    bool of_ends;
};
const OfLobe of_lobe[] = {
    {"r0", ri::Fit::r0, ri::fit_r0, false},
    {"r1", ri::Fit::r1, ri::fit_r1, false},
    {"alpha", ri::Fit::alpha, ri::fit_alpha, false},
    {"beta", ri::Fit::beta, ri::fit_beta, false},
    {"l2", ri::Fit::l2, ri::fit_l2, false},
    {"l1", ri::Fit::l1, ri::fit_l1, false},
    {"r0_of_ends", ri::Fit::r0, ri::fit_r0_of_ends, true},
    {"r1_of_ends", ri::Fit::r1, ri::fit_r1_of_ends, true},
    {"alpha_of_ends", ri::Fit::alpha, ri::fit_alpha_of_ends, true},
    {"beta_of_ends", ri::Fit::beta, ri::fit_beta_of_ends, true},
};

class FitOfLobe : public ::testing::TestWithParam<OfLobe> {};
TEST_P(FitOfLobe, agrees_with_its_closed_form) {
    const OfLobe& q = GetParam();
    int inputs = 0;
    const auto generator = q.of_ends ? stiffness::lobes_of_ends() : stiffness::lobes();
    for_each_input(*generator, 40, 2, [&](const Arguments& arguments, const std::string& from) {
        const auto& x = arguments.numbers;
        if (x[0] == x[1] || x[2] == 0) return; // the printed forms divide by both
        const Truth truth = q.truth(arguments);
        const Wide value = ri::fit_value(q.what, x.data(), q.of_ends);
        Digits a = x[0], b = x[1];
        if (!q.of_ends) {
            a = 1 - a;
            b = 1 - b;
        }
        if (b < a) std::swap(a, b);
        const std::string what = from + ": " + show(arguments, 4);
        if (q.what != ri::Fit::l1) {
            EXPECT_LE(difference(value, closed_fit(q.what, a, b, x[2], x[3]), truth.scale), agreed) << what;
        }
        EXPECT_LE(difference(ri::fit_value(q.what, x.data(), q.of_ends, more), value, truth.scale),
                  orders_agreed)
            << what;
        expect_rounded(truth, wide(value), what);
        ++inputs;
    });
    EXPECT_GT(inputs, 80);
}
INSTANTIATE_TEST_SUITE_P(, FitOfLobe, ::testing::ValuesIn(of_lobe),
                         [](const auto& of) { return std::string(of.param.name); });

// --- The whole of it
// ----------------------------------------------------------------------------------------------

TEST(integral_agreement, radiance) {
    int inputs = 0;
    for_each_input(*stiffness::lit_cells(), 60, 3, [&](const Arguments& arguments, const std::string& from) {
        const auto& x = arguments.numbers;
        if (x[1] == 0 || x[13] == x[14] || x[11] == 0) return;
        const Digits phi = x[0], half = x[1], theta0 = x[2], first = x[3], last = x[4];
        const Digits k = (last - first) / (2 * half);
        if (k == 0 || abs(k) == 1 || abs(k) == 2 || 2 * abs(k) == 1) return;
        const closed::Boundary c{phi - half, phi + half, theta0, k, theta0 + (first + last) / 2 - k * phi};
        Digits va = x[13], vb = x[14];
        if (va < vb) std::swap(va, vb);
        closed::Vector axis = vector_at<Digits>(arguments, 8);
        const Digits length = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        for (Digits& component : axis) component /= length;
        const Digits want = closed::radiance(c, vector_at<Digits>(arguments, 5), axis,
                                             closed::fit(1 - va, 1 - vb, x[11], x[12]));
        const auto value_by = [&](const Effort& effort) {
            const ri::Lobe<Wide> lobe = ri::radiance_lobe(x);
            return ri::radiance_value(x, ri::moments({x[0], x[1], x[2], x[3], x[4]}, effort), lobe,
                                      ri::fit_shape(lobe.m(), effort));
        };
        const Truth truth = ri::radiance(arguments);
        const Real value = value_by({});
        const std::string what = from + ": " + show(arguments, 15);
        EXPECT_LE(difference(value, want, truth.scale), agreed) << what;
        EXPECT_LE(difference(value_by(more), value, truth.scale), orders_agreed) << what;
        expect_rounded(truth, wide(value), what);
        ++inputs;
    });
    EXPECT_GT(inputs, 80);
}

} // namespace
} // namespace gnomon::testing
