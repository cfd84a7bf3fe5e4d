#include "casegen/reference/integral/truth.h"

#include "casegen/reference/integral/cell.h"
#include "casegen/reference/integral/cell_interval.h"
#include "casegen/reference/integral/values.h"
#include "casegen/reference/integral/wave.h"

#include <algorithm>
#include <limits>

namespace gnomon::reference::integral {
namespace {

constexpr double half_ulp = 0x1p-24; // of a float, relative
/// For conditionings and scales, in double.
constexpr Effort rough{.digits = 10, .extra = 2};

Truth no_truth() {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    return {{nan, nan, nan, nan}, {nan, nan, nan, nan}, nan};
}

/// MPFR keeps π and its like once per thread, and would leave them behind with it.
void free_constants_with_the_thread() {
    struct Free {
        ~Free() { mpfr_free_cache(); }
    };
    static thread_local const Free at_its_end;
    static_cast<void>(at_its_end);
}

/// The first thing that every truth asks.
template <std::size_t N>
bool all_finite(const Arguments& x) {
    free_constants_with_the_thread();
    return std::all_of(x.numbers.begin(), x.numbers.begin() + N, [](double n) { return std::isfinite(n); });
}

template <std::size_t N>
std::array<Real, N> exact(const Arguments& x) {
    std::array<Real, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = x.numbers[i];
    return result;
}

template <std::size_t N>
std::array<Dual<N>, N> duals(const Arguments& x) {
    std::array<Dual<N>, N> result;
    for (std::size_t i = 0; i < N; ++i) result[i] = Dual<N>::input(x.numbers[i], i);
    return result;
}

/// Σ |x_i ∂_i| · 2⁻²⁴.
template <typename Derivatives>
double conditioning(const Arguments& x, const Derivatives& by) {
    double sum = 0;
    for (std::size_t i = 0; i < by.size(); ++i) sum += std::abs(x.numbers[i] * value_of(by[i]));
    return sum * half_ulp;
}

template <typename R, std::size_t N>
Truth truth_of(const Arguments& x, const R& value, const Dual<N>& derivatives, double scale) {
    Truth truth;
    truth.value[0] = value_of(value);
    truth.conditioning[0] = conditioning(x, derivatives.by);
    truth.scale = scale;
    return truth;
}

template <Wave wave>
Truth wave_truth(const Arguments& x) {
    constexpr std::size_t count = 2 + phases_of(wave);
    if (!all_finite<count>(x)) return no_truth();
    const auto numbers = exact<count>(x);
    if (!(wave_omega<wave>(numbers) < most_frequency)) return no_truth();
    const Integral<Dual<count>> near = wave_integral<wave>(duals<count>(x), rough);
    return truth_of(x, wave_integral<wave>(numbers).value, near.value, near.magnitude);
}

// ---------------------------------------------------------------------------------------------------------------------

CellKey boundary_key(const Arguments& x) {
    return {true, {x.numbers[0], x.numbers[1], x.numbers[2], x.numbers[3], x.numbers[4]}};
}

/// A dual's value, from better digits than its own.
template <std::size_t N>
void refine(Dual<N>& x, const Real& value) {
    x.value = value_of(value);
}

/// The truth of an integral over a boundary's cell: `combine(moments, x)` of the numbers behind the cell's
/// five in multiprecision, `integrand(direction, x)` in duals.
template <std::size_t N, typename Combine, typename Integrand>
Truth cell_truth(const Arguments& arguments, const Combine& combine, const Integrand& integrand) {
    if (!all_finite<N>(arguments)) return no_truth();
    const CellKey key = boundary_key(arguments);
    const auto x = exact<N>(arguments);
    const Moments<Real> of_cell = kept_moments(key);
    if (isnan(of_cell[0])) return no_truth();
    const Real value = combine(of_cell, x.data() + 5);

    const auto d = duals<N>(arguments);
    Cell<Dual<N>> cell = boundary_cell(d[0], d[1], d[2], d[3], d[4]);
    const Cell<Real> exact_one = exact_cell(key);
    refine(cell.middle, exact_one.middle);
    refine(cell.half, exact_one.half);
    refine(cell.rise0, exact_one.rise0);
    refine(cell.rise1, exact_one.rise1);
    const Integral<Dual<N>> near = integrate_over(
        cell, [&](const Direction<Dual<N>>& to) { return integrand(to, d.data() + 5); }, rough);
    return truth_of(arguments, value, near.value, near.magnitude);
}

template <typename T>
T sine_of(const Direction<T>& to, const T& phase) {
    T s, c;
    sin_cos(phase, s, c);
    return to.sin_phi * c + to.cos_phi * s;
}

template <typename T>
T dot(const Direction<T>& to, const T* n) {
    return (n[0] * to.cos_phi + n[1] * to.sin_phi) * to.sin_theta + n[2] * to.cos_theta;
}

Truth phase_and_cosine(const Arguments& arguments) {
    return cell_truth<6>(
        arguments,
        [](const Moments<Real>& m, const Real* x) {
            return second_moment(m, axis_of_phase(x[0]).data(), polar_axis<Real>().data());
        },
        [](const auto& to, const auto* x) {
            return sine_of(to, x[0]) * to.cos_theta * to.sin_theta * to.sin_theta;
        });
}

// ---------------------------------------------------------------------------------------------------------------------

/// Of versines, or of the interval's ends.
template <Fit what>
Truth fit_truth(const Arguments& arguments, bool of_ends) {
    if (!all_finite<4>(arguments)) return no_truth();
    const Lobe<Wide> lobe = exact_lobe(arguments.numbers.data(), of_ends);
    const Wide m = lobe.m();
    if (!(m >= 0)) return no_truth(); // a lobe that grows away from its axis
    const FitShape<Wide> shape = fit_shape(m);
    const Slope<Wide> error = fit_error(what, m, shape);
    const Wide value = fit_result(what, lobe, shape, error, [](const Slope<Wide>& f) { return f.value; });

    using D = Dual<4>;
    auto in = duals<4>(arguments);
    if (of_ends) {
        in[0] = D(1) - in[0];
        in[1] = D(1) - in[1];
    }
    const Lobe<D> near(in[0], in[1], in[2], in[3]);
    const auto chained = [&](const Slope<Wide>& f) {
        return chain(near.m(), value_of(f.value), value_of(f.slope));
    };
    const D derivatives = fit_result(what, near, shape, error, chained);
    double scale = std::abs(value_of(value));
    if (what == Fit::alpha) {
        const FitParts<D> parts = fit_parts(near, shape, chained);
        scale = std::abs(parts.r0.value) + std::abs(parts.beta.value * parts.x_m.value);
    }
    return truth_of(arguments, value, derivatives, scale);
}

} // namespace

Truth c0(const Arguments& x) { return wave_truth<Wave::c0>(x); }
Truth c1(const Arguments& x) { return wave_truth<Wave::c1>(x); }
Truth c2(const Arguments& x) { return wave_truth<Wave::c2>(x); }
Truth c3(const Arguments& x) { return wave_truth<Wave::c3>(x); }
Truth c4(const Arguments& x) { return wave_truth<Wave::c4>(x); }
Truth c5(const Arguments& x) { return wave_truth<Wave::c5>(x); }

Truth a0(const Arguments& arguments) {
    return cell_truth<6>(
        arguments,
        [](const Moments<Real>& m, const Real* x) { return first_moment(m, axis_of_phase(x[0]).data()); },
        [](const auto& to, const auto* x) { return sine_of(to, x[0]) * to.sin_theta * to.sin_theta; });
}
Truth a1(const Arguments& arguments) {
    return cell_truth<5>(
        arguments, [](const Moments<Real>& m, const Real*) { return m[sin_cos_theta]; },
        [](const auto& to, const auto*) { return to.cos_theta * to.sin_theta; });
}
Truth a(const Arguments& arguments) {
    return cell_truth<8>(
        arguments, [](const Moments<Real>& m, const Real* n) { return first_moment(m, n); },
        [](const auto& to, const auto* n) { return dot(to, n) * to.sin_theta; });
}
Truth b0(const Arguments& arguments) {
    return cell_truth<7>(
        arguments,
        [](const Moments<Real>& m, const Real* x) {
            return second_moment(m, axis_of_phase(x[0]).data(), axis_of_phase(x[1]).data());
        },
        [](const auto& to, const auto* x) {
            return sine_of(to, x[0]) * sine_of(to, x[1]) * to.sin_theta * to.sin_theta * to.sin_theta;
        });
}
Truth b1(const Arguments& arguments) { return phase_and_cosine(arguments); }
Truth b2(const Arguments& arguments) { return phase_and_cosine(arguments); }
Truth b3(const Arguments& arguments) {
    return cell_truth<5>(
        arguments, [](const Moments<Real>& m, const Real*) { return m[cos2_sin]; },
        [](const auto& to, const auto*) { return to.cos_theta * to.cos_theta * to.sin_theta; });
}
Truth b(const Arguments& arguments) {
    return cell_truth<11>(
        arguments, [](const Moments<Real>& m, const Real* x) { return second_moment(m, x, x + 3); },
        [](const auto& to, const auto* x) { return dot(to, x) * dot(to, x + 3) * to.sin_theta; });
}

Truth radiance(const Arguments& arguments) {
    constexpr std::size_t count = 15;
    if (!all_finite<count>(arguments)) return no_truth();
    const auto& numbers = arguments.numbers;
    const CellKey key{false, {numbers[0], numbers[1], numbers[2], numbers[3], numbers[4]}};
    const Moments<Real> m = kept_moments(key);
    const Lobe<Wide> lobe = radiance_lobe(numbers);
    const bool has_axis = numbers[8] != 0 || numbers[9] != 0 || numbers[10] != 0;
    if (isnan(m[0]) || !has_axis || !(lobe.m() >= 0)) return no_truth();
    const FitShape<Wide> shape = fit_shape(lobe.m());
    const Real value = radiance_value(numbers, m, lobe, shape);

    using D = Dual<count>;
    const auto d = duals<count>(arguments);
    const Cell<D> cell{d[0], d[1], d[2], d[3], d[4]};
    const Lobe<D> near(d[13], d[14], d[11], d[12]);
    const FitParts<D> near_parts = fit_parts(near, shape, [&](const Slope<Wide>& f) {
        return chain(near.m(), value_of(f.value), value_of(f.slope));
    });
    // p̂·ω - x_m as a difference of versines, which keeps its digits where the cell is small: 1 - p̂·ω is
    // |ω - p̂|²/2.
    using std::sqrt;
    const D length = sqrt(d[8] * d[8] + d[9] * d[9] + d[10] * d[10]);
    const D* normal = d.data() + 5;
    const D axis[3] = {d[8] / length, d[9] / length, d[10] / length};
    const D of_middle = near.versine_of_middle();
    const Integral<D> sum = integrate_over(
        cell,
        [&](const Direction<D>& to) {
            const D across = to.sin_theta * to.cos_phi - axis[0], along = to.sin_theta * to.sin_phi - axis[1],
                    up = to.cos_theta - axis[2];
            const D versine = 0.5 * (across * across + along * along + up * up);
            return (near_parts.r0 + near_parts.beta * (of_middle - versine)) * dot(to, normal) * to.sin_theta;
        },
        rough);
    return truth_of(arguments, value, sum.value, sum.magnitude);
}

Truth fit_r0(const Arguments& x) { return fit_truth<Fit::r0>(x, false); }
Truth fit_r1(const Arguments& x) { return fit_truth<Fit::r1>(x, false); }
Truth fit_alpha(const Arguments& x) { return fit_truth<Fit::alpha>(x, false); }
Truth fit_beta(const Arguments& x) { return fit_truth<Fit::beta>(x, false); }
Truth fit_l2(const Arguments& x) { return fit_truth<Fit::l2>(x, false); }
Truth fit_l1(const Arguments& x) { return fit_truth<Fit::l1>(x, false); }
Truth fit_r0_of_ends(const Arguments& x) { return fit_truth<Fit::r0>(x, true); }
Truth fit_r1_of_ends(const Arguments& x) { return fit_truth<Fit::r1>(x, true); }
Truth fit_alpha_of_ends(const Arguments& x) { return fit_truth<Fit::alpha>(x, true); }
Truth fit_beta_of_ends(const Arguments& x) { return fit_truth<Fit::beta>(x, true); }

namespace {

Truth interval_truth(const Arguments& arguments, bool of_versines) {
    if (!all_finite<7>(arguments)) return no_truth();
    const auto x = exact<7>(arguments);
    if (x[4] == 0 && x[5] == 0 && x[6] == 0) return no_truth();
    const CellInterval found = interval_over(x);
    const Extremum* ends[] = {&found.least, &found.greatest};
    Truth truth;
    truth.scale = of_versines ? 2 : 1;
    for (std::size_t i = 0; i < 2; ++i) {
        const double versine = value_of(ends[i]->versine);
        truth.value[i] = of_versines ? versine : value_of(Real(1 - ends[i]->versine));
        truth.conditioning[i] = conditioning(arguments, ends[i]->by);
        if (!of_versines) continue;
        // Near 0 a versine is half a square: moved by ε, it changes by ε²/2 where its derivative is none.
        double moved = 1; // p̂, by at most this much
        for (std::size_t k = 0; k < 4; ++k) moved += std::abs(arguments.numbers[k]);
        moved *= half_ulp;
        truth.conditioning[i] = std::max(truth.conditioning[i] + moved * moved / 2, versine * half_ulp);
        truth.scale = std::min(truth.scale, versine);
    }
    return truth;
}

} // namespace

Truth interval(const Arguments& x) { return interval_truth(x, false); }
Truth interval_versines(const Arguments& x) { return interval_truth(x, true); }

} // namespace gnomon::reference::integral
