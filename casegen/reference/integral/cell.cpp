#include "casegen/reference/integral/cell.h"

#include <bit>
#include <mutex>
#include <unordered_map>

namespace gnomon::reference::integral {
namespace {

struct SinCos {
    Real s, c;
};
SinCos sin_cos_of(const Real& x) {
    SinCos result;
    sin_cos(x, result.s, result.c);
    return result;
}

/// ∫ dt over [0, 1] at one φ of sin²θ, sinθ cosθ, sin³θ, sin²θ cosθ, cos²θ sinθ.
struct Column {
    Real sin2 = 0, sin_cos = 0, sin3 = 0, sin2_cos = 0, cos2_sin = 0;
    void add(const Real& weight, const Real& s, const Real& c) {
        const Real ws = weight * s, wss = ws * s, wsc = ws * c;
        sin2 += wss;
        sin_cos += wsc;
        sin3 += wss * s;
        sin2_cos += wss * c;
        cos2_sin += wsc * c;
    }
};

Column integrate_column(const Real& theta0, const Real& rise, int panels, const Rule<Real>& rule) {
    Column column;
    const Real half = rise / (2 * panels);
    std::vector<SinCos> steps; // from a panel's middle to its nodes: the same in every panel
    const std::size_t n = rule.nodes.size();
    for (std::size_t j = n / 2; j < n; ++j) steps.push_back(sin_cos_of(half * rule.nodes[j]));
    for (int panel = 0; panel < panels; ++panel) {
        const SinCos middle = sin_cos_of(theta0 + half * (2 * panel + 1));
        for (std::size_t j = n / 2; j < n; ++j) {
            const Real weight = rule.weights[j] / (2 * panels);
            const SinCos& step = steps[j - n / 2];
            const Real sc = middle.s * step.c, cs = middle.c * step.s, cc = middle.c * step.c,
                       ss = middle.s * step.s;
            column.add(weight, sc + cs, cc - ss);
            if (n % 2 == 0 || j > n / 2) column.add(weight, sc - cs, cc + ss); // the node at -x
        }
    }
    return column;
}

struct SameKey { // bit for bit
    bool operator()(const CellKey& a, const CellKey& b) const {
        using Bits = std::array<std::uint64_t, 5>;
        return a.of_boundary == b.of_boundary &&
               std::bit_cast<Bits>(a.numbers) == std::bit_cast<Bits>(b.numbers);
    }
};
struct HashKey {
    std::size_t operator()(const CellKey& key) const {
        std::uint64_t state = key.of_boundary ? 1 : 2;
        for (const double number : key.numbers)
            state = (state ^ std::bit_cast<std::uint64_t>(number)) * 0x9e3779b97f4a7c15ull,
            state ^= state >> 32;
        return state;
    }
};

} // namespace

Moments<Real> moments(const Cell<Real>& cell, const Effort& effort) {
    const double rise0 = std::abs(value_of(cell.rise0)), rise1 = std::abs(value_of(cell.rise1));
    // θ(x) takes part in products of three sines, and beside them stand at most two of φ.
    const double omega_phi =
        1.5 * std::abs(value_of(Real(cell.rise1 - cell.rise0))) + 2 * std::abs(value_of(cell.half));
    const double omega_theta = 1.5 * std::max(rise0, rise1);
    Moments<Real> sum{};
    if (!(omega_phi < most_frequency) || !(omega_theta < most_frequency)) {
        sum.fill(std::numeric_limits<Real>::quiet_NaN());
        return sum;
    }
    const int panels_phi = panels_for(omega_phi), panels_theta = panels_for(omega_theta);
    const Rule<Real>& rule_phi = gauss_rule<Real>(nodes_for(omega_phi / panels_phi, effort));
    const Rule<Real>& rule_theta = gauss_rule<Real>(nodes_for(omega_theta / panels_theta, effort));
    for (int panel = 0; panel < panels_phi; ++panel)
        for (std::size_t i = 0; i < rule_phi.nodes.size(); ++i) {
            const Real x = (rule_phi.nodes[i] + (2 * panel + 1 - panels_phi)) / panels_phi;
            const Real rise = ((1 - x) * cell.rise0 + (1 + x) * cell.rise1) / 2;
            const Column column = integrate_column(cell.theta0, rise, panels_theta, rule_theta);
            const SinCos phi = sin_cos_of(cell.middle + cell.half * x);
            const Real weight = rule_phi.weights[i] / panels_phi * cell.half * rise;
            const Real c = weight * phi.c, s = weight * phi.s;
            sum[sin2_cos_phi] += c * column.sin2;
            sum[sin2_sin_phi] += s * column.sin2;
            sum[sin_cos_theta] += weight * column.sin_cos;
            sum[sin3_cos2_phi] += c * phi.c * column.sin3;
            sum[sin3_sin_cos_phi] += c * phi.s * column.sin3;
            sum[sin3_sin2_phi] += s * phi.s * column.sin3;
            sum[sin2_cos_cos_phi] += c * column.sin2_cos;
            sum[sin2_cos_sin_phi] += s * column.sin2_cos;
            sum[cos2_sin] += weight * column.cos2_sin;
        }
    return sum;
}

Cell<Real> exact_cell(const CellKey& key) {
    const auto& x = key.numbers;
    if (key.of_boundary) return boundary_cell<Real>(x[0], x[1], x[2], x[3], x[4]);
    return {x[0], x[1], x[2], x[3], x[4]};
}

Moments<Real> kept_moments(const CellKey& key) {
    constexpr std::size_t most_kept = 32768; // 20 MB
    static std::mutex mutex;
    static std::unordered_map<CellKey, Moments<Real>, HashKey, SameKey> kept;
    {
        const std::scoped_lock lock(mutex);
        if (const auto found = kept.find(key); found != kept.end()) return found->second;
    }
    const Moments<Real> result = moments(exact_cell(key)); // twice at worst, if two threads ask at once
    const std::scoped_lock lock(mutex);
    if (kept.size() >= most_kept) kept.clear();
    kept.emplace(key, result);
    return result;
}

} // namespace gnomon::reference::integral
