// Triangles, rays and squares on a lattice, with margins as runtime/hybrid/column_space.cpp makes them, and
// the true ones that the margins leave room for.
#pragma once

#include "tests/hybrid_kernels/lattice.h"
#include "tests/hybrid_kernels/rows.h"

#include <algorithm>

namespace gnomon::testing {

/// A triangle, a point (a ray's origin, a square's middle, a fourth corner), half a square's side, margins,
/// all in units of 2^exponent.
struct ColumnTrial {
    LatticeTriangle corners;
    LatticePoint origin;
    std::int64_t half_side, margin, margin_z, tmin;
    int exponent;
    std::uint64_t seed;

    double real(std::int64_t units) const { return std::ldexp(static_cast<double>(units), exponent); }
    double real_margin() const { return real(margin); }
    double half() const { return real(half_side); }
    Numbered flat(std::initializer_list<double> more) const {
        Numbered row;
        for (const LatticePoint& p : corners.p) row.insert(row.end(), {real(p.x), real(p.y)});
        row.insert(row.end(), {real(origin.x), real(origin.y)});
        row.insert(row.end(), more);
        return row;
    }
    Numbered deep(std::initializer_list<double> more) const {
        Numbered row;
        for (const LatticePoint& p : corners.p) row.insert(row.end(), {real(p.x), real(p.y), real(p.z)});
        row.insert(row.end(), {real(origin.x), real(origin.y)});
        row.insert(row.end(), more);
        return row;
    }
    Numbered ray() const { return deep({real(origin.z), real(tmin), real(margin), real(margin_z)}); }

    /// Anywhere within the margin, mostly at the corners of what that leaves, where laws break first.
    std::int64_t off(Random& random) const {
        const auto n = static_cast<int>(margin);
        return random.chance(0.7) ? (random.chance(0.5) ? n : -n) : random.between(-n, n);
    }
    LatticePoint moved(LatticePoint p, Random& random) const {
        return {p.x + off(random), p.y + off(random), p.z};
    }
    /// The triangle itself, and others that it may truly be.
    std::vector<LatticeTriangle> moved(int count) const {
        std::vector<LatticeTriangle> all{corners};
        Random random(seed, 1);
        for (int i = 1; i < count; ++i) {
            LatticeTriangle one;
            for (std::size_t k = 0; k < 3; ++k) one.p[k] = moved(corners.p[k], random);
            all.push_back(one);
        }
        return all;
    }
    std::vector<LatticePoint> moved_origins(int count) const {
        std::vector<LatticePoint> all{origin};
        Random random(seed, 2);
        for (int i = 1; i < count; ++i) all.push_back(moved(origin, random));
        return all;
    }
    LatticePoint in_square(Random& random) const {
        const auto n = static_cast<int>(half_side);
        return {origin.x + random.between(-n, n), origin.y + random.between(-n, n)};
    }
};

namespace detail {

inline ColumnTrial column_trial(std::uint64_t seed, std::uint64_t index) {
    Random random(seed, index);
    const auto any = [&] { return 2 * random.unit() - 1; };
    // Units: corners reach to 2^29 of them, so that a margin of 5 · 2^-24 of that is 160.
    const double reach = std::exp2(29 - (random.chance(0.5) ? 0 : 6 * random.unit()));
    const double size = reach * std::exp2(random.chance(0.6) ? -6 * random.unit() : -14 * random.unit());
    const double x = (reach - size) * any(), y = (reach - size) * any();
    ColumnTrial t{};
    t.seed = random.bits();
    for (LatticePoint& p : t.corners.p)
        p = {rounded(x + size * any()), rounded(y + size * any()), rounded(reach * any())};
    auto& p = t.corners.p;
    // Some nearly flat to the light, so that slopes are gentle; some wholly.
    if (random.chance(0.5)) {
        const double flat = random.chance(0.2) ? 0 : std::exp2(-20 * random.unit());
        for (std::size_t k = 1; k < 3; ++k)
            p[k].z = rounded(static_cast<double>(p[0].z) + flat * size * any());
    }
    // Slivers, down to none: the third corner beside the line of the others.
    if (random.chance(0.5)) {
        const double along = random.chance(0.8) ? random.unit() : 1.5 * any();
        const double beside = (random.chance(0.1) ? 0 : std::exp2(-24 * random.unit())) * any();
        const auto dx = static_cast<double>(p[1].x - p[0].x), dy = static_cast<double>(p[1].y - p[0].y);
        p[2].x = rounded(static_cast<double>(p[0].x) + along * dx - beside * dy);
        p[2].y = rounded(static_cast<double>(p[0].y) + along * dy + beside * dx);
    }
    if (random.chance(0.03)) p[2] = p[1];
    double farthest = 0;
    for (const LatticePoint& each : p)
        farthest = std::max({farthest, std::abs(static_cast<double>(each.x)),
                             std::abs(static_cast<double>(each.y)), std::abs(static_cast<double>(each.z))});
    // The pipeline's receivers lie round the origin of its space: no farther than R.
    const double least = 0x1p-24 * 5 * farthest;
    const double more = random.chance(0.5) ? 1 : std::exp2(10 * random.unit());
    // A point on the triangle, on an edge or at a corner, or anywhere near; then off by a few margins.
    std::array<double, 3> w{random.unit(), random.unit(), random.unit()};
    if (random.chance(0.5)) w[random.below(3)] = 0;
    if (random.chance(0.15)) w = {0, 0, 1};
    if (random.chance(0.1)) w[random.below(3)] *= -1;
    const double sum = w[0] + w[1] + w[2];
    double at[3] = {0, 0, 0};
    for (std::size_t k = 0; k < 3; ++k) {
        const double share = std::abs(sum) > 1e-3 ? w[k] / sum : 1.0 / 3;
        at[0] += share * static_cast<double>(p[k].x);
        at[1] += share * static_cast<double>(p[k].y);
        at[2] += share * static_cast<double>(p[k].z);
    }
    for (double& each : at) each = std::clamp(each, -0x1p29, 0x1p29);
    const double here = std::max(std::abs(at[0]), std::abs(at[1]));
    const double margin = (least + 0x1p-24 * 9 * here) * more;
    t.half_side =
        rounded(std::min(0x1p28, random.chance(0.5) ? 8 * margin * random.unit() : size * random.unit()));
    const double beside = std::exp2(6 * random.unit()) * margin, off = random.chance(0.6) ? beside : size;
    const double square = random.chance(0.5) ? static_cast<double>(t.half_side) : 0;
    t.origin = {rounded(at[0] + off * any() + square * any()), rounded(at[1] + off * any() + square * any())};
    const double depth = 0x1p-24 * (5 * farthest + 9 * std::abs(at[2]));
    t.margin = std::min<std::int64_t>(
        1 << 28,
        rounded(std::ceil(1 + more * (least + 0x1p-24 * 9 *
                                                  std::max(std::abs(static_cast<double>(t.origin.x)),
                                                           std::abs(static_cast<double>(t.origin.y)))))));
    t.margin_z = rounded(std::ceil(1 + depth * 2));
    t.tmin = rounded(depth * 8 * random.unit());
    const double away = random.chance(0.6) ? depth * std::exp2(12 * random.unit()) : reach;
    t.origin.z = rounded(at[2] + static_cast<double>(t.tmin) + away * any());
    t.exponent = random.between(-42, -12); // texels of 1e-4 of a unit, and maps of 1e5 texels
    return t;
}

} // namespace detail

inline std::vector<ColumnTrial> column_trials(std::uint64_t seed, std::size_t count) {
    std::vector<ColumnTrial> all;
    for (std::size_t i = 0; i < count; ++i) all.push_back(detail::column_trial(seed, i));
    return all;
}

} // namespace gnomon::testing
