#include "casegen/reference/integral/cell_interval.h"

#include <boost/math/constants/constants.hpp>

#include <vector>

namespace gnomon::reference::integral {
namespace {

// p̂·ω = A(φ) sinθ + v cosθ with A = p̂.x cosφ + p̂.y sinφ. For a θ held fixed it is linear in A, so wherever
// in the cell an extremum lies, one lies where A is least or greatest: first φ is searched for those two,
// then θ for each of them. In both searches the function is a cosine of the distance to a place it peaks at.

/// The places in middle ± half where cos(x - peak) is greatest: the nearest to a peak, whichever turn it is
/// on. Two, an end each, if they are as near as makes no difference to a float.
std::vector<Real> nearest_to(const Real& peak, const Real& middle, const Real& half) {
    static const Real turn = 2 * boost::math::constants::pi<Real>();
    const Real reach = abs(half);
    const Real away = peak - middle - turn * round((peak - middle) / turn); // -½ turn … ½ turn
    if (abs(away) <= reach) return {middle + away};
    const Real near = away < 0 ? middle - reach : middle + reach;
    const Real far = away < 0 ? middle + reach : middle - reach;
    const Real gap_far = turn - abs(away) - reach,
               gap_near = abs(away) - reach; // beyond the ends, each way round
    if (gap_far - gap_near < Real(1e-6)) return {near, far};
    return {near};
}

struct Place {
    Real phi, theta;
};

} // namespace

CellInterval interval_over(const std::array<Real, 7>& x) {
    const Real &phi = x[0], &half = x[1], &first = x[2], &last = x[3];
    const Real length = sqrt(x[4] * x[4] + x[5] * x[5] + x[6] * x[6]);
    const Real p[3] = {x[4] / length, x[5] / length, x[6] / length};
    static const Real pi = boost::math::constants::pi<Real>();
    const Real azimuth = atan2(p[1], p[0]);

    std::vector<Place> places[2]; // of the least and of the greatest
    const Real theta_middle = (first + last) / 2, theta_half = (last - first) / 2;
    for (const bool of_greatest_a : {false, true})
        for (const Real& at : nearest_to(of_greatest_a ? azimuth : azimuth + pi, phi, half)) {
            const Real a = p[0] * cos(at) + p[1] * sin(at);
            const Real peak = atan2(a, p[2]);
            for (const Real& theta : nearest_to(peak, theta_middle, theta_half))
                places[1].push_back({at, theta});
            for (const Real& theta : nearest_to(peak + pi, theta_middle, theta_half))
                places[0].push_back({at, theta});
        }

    const auto extremum = [&](int sign) {
        std::vector<Extremum> all;
        for (const Place& place : places[sign > 0 ? 1 : 0]) {
            const Real st = sin(place.theta), ct = cos(place.theta), sp = sin(place.phi), cp = cos(place.phi);
            const Real w[3] = {st * cp, st * sp, ct};
            Extremum e;
            // |ω - p̂|² / 2 keeps the digits that 1 - p̂·ω loses.
            e.versine = 0;
            for (int i = 0; i < 3; ++i) e.versine += (w[i] - p[i]) * (w[i] - p[i]) / 2;
            // At an extremum over x, t in [-1, 1] x [0, 1] the place itself may be held fixed (Danskin).
            const Real by_phi = st * (p[1] * cp - p[0] * sp);
            const Real by_theta = ct * (p[0] * cp + p[1] * sp) - p[2] * st;
            const Real across = half == 0 ? Real(0) : Real((place.phi - phi) / half);
            const Real along = first == last ? Real(0.5) : Real((place.theta - first) / (last - first));
            e.by = {by_phi, across * by_phi, (1 - along) * by_theta, along * by_theta};
            for (std::size_t i = 0; i < 3; ++i) e.by[4 + i] = (w[i] - (1 - e.versine) * p[i]) / length;
            all.push_back(e);
        }
        const auto sensitivity = [&](const Extremum& e) {
            Real sum = 0;
            for (std::size_t i = 0; i < 7; ++i) sum += abs(x[i] * e.by[i]);
            return sum;
        };
        Extremum best = all.front();
        for (const Extremum& e : all)
            if (sign > 0 ? e.versine < best.versine : e.versine > best.versine) best = e;
        const Extremum at = best;
        for (const Extremum& e : all)
            if (abs(e.versine - at.versine) <= Real(1e-7) * at.versine && sensitivity(e) > sensitivity(best))
                best.by = e.by;
        return best;
    };
    return {extremum(-1), extremum(1)};
}

} // namespace gnomon::reference::integral
