// Cells under a boundary: phi0, phi1, theta0, k, b.
#include "casegen/stiffness/draw.h"

#include <fmt/format.h>

namespace gnomon::stiffness {
namespace {

/// The boundary from the height `first` at φ0 to `last` at φ1, as k and b of the φ that float holds.
void set_boundary(Span n, double first, double last) {
    const double phi0 = as_float(n[0]), phi1 = as_float(n[1]);
    n[3] = phi1 == phi0 ? 0 : as_float((last - first) / (phi1 - phi0));
    n[4] = first - n[3] * phi0;
}
/// With this k: the heights as far as 0 … π lets them, the width cut if that does not suffice.
void set_slope(Random& random, Span n, double k) {
    const double reach = 0.999 * pi;
    if (std::abs(k * (n[1] - n[0])) > reach) n[1] = n[0] + std::copysign(reach / std::abs(k), n[1] - n[0]);
    const double gain = k * (n[1] - n[0]);
    const double first = uniform(random, std::max(0.0, -gain), pi - std::max(0.0, gain));
    n[3] = as_float(k);
    n[4] = first - n[3] * as_float(n[0]);
}

void draw_boundary_cell(Random& random, Span n) {
    const double width =
        random.chance(0.5) ? uniform(random, 0.05, 2 * pi) : over_decades(random, 0.01, 2 * pi);
    n[0] = uniform(random, -pi, pi);
    n[1] = n[0] + width;
    if (random.chance(0.1)) std::swap(n[0], n[1]);
    n[2] = uniform(random, 0, pi);
    set_boundary(n, uniform(random, 0, pi), uniform(random, 0, pi));
}

std::vector<Locus> boundary_loci() {
    std::vector<Locus> loci;
    const auto add = [&](std::string name, std::string group,
                         std::function<void(Random&, double, Span)> place) {
        loci.push_back({std::move(name), std::move(group), std::move(place)});
    };
    for (const auto& [name, k0] : std::initializer_list<std::pair<const char*, double>>{{"0", 0},
                                                                                        {"1/3", 1.0 / 3},
                                                                                        {"1/2", 0.5},
                                                                                        {"2/3", 2.0 / 3},
                                                                                        {"1", 1},
                                                                                        {"2", 2},
                                                                                        {"-1/3", -1.0 / 3},
                                                                                        {"-1/2", -0.5},
                                                                                        {"-2/3", -2.0 / 3},
                                                                                        {"-1", -1},
                                                                                        {"-2", -2}})
        add(fmt::format("k = {}", name), "k",
            [k0 = k0](Random& random, double d, Span n) { set_slope(random, n, k0 + about(random, d)); });
    add("phi1 - phi0 = 0", "narrow", [](Random& random, double d, Span n) {
        n[1] = n[0] + about(random, d);
        const double first = uniform(random, 0, pi);
        // Half of them with the slope that ordinary cells have, half with any height at either end.
        const double last = random.chance(0.5) ? uniform(random, 0, pi) : first + about(random, d);
        set_boundary(n, first, std::clamp(last, 0.0, pi));
    });
    add("phi1 - phi0 = 2 pi", "full turn", [](Random& random, double d, Span n) {
        n[1] = n[0] + 2 * pi - d;
        set_boundary(n, uniform(random, 0, pi), uniform(random, 0, pi));
    });
    add("theta = theta0", "slab", [](Random& random, double d, Span n) {
        const auto near = [&] { return std::clamp(n[2] + about(random, d), 0.0, pi); };
        const double first = near();
        set_boundary(n, first, near());
    });
    add("theta = theta0 at one end", "slab", [](Random& random, double d, Span n) {
        const double near = std::clamp(n[2] + about(random, d), 0.0, pi);
        set_boundary(n, near, uniform(random, 0, pi));
    });
    for (const bool south : {false, true})
        add(south ? "theta = pi" : "theta = 0", "pole", [south](Random& random, double d, Span n) {
            const auto near = [&](double distance) { return south ? pi - distance : distance; };
            n[2] = near(d * random.unit());
            const double first = near(d * random.unit());
            // On the pole itself: a cell that begins there.
            if (d == 0)
                set_boundary(n, uniform(random, 0, pi), uniform(random, 0, pi));
            else
                set_boundary(n, first, near(d * random.unit()));
        });
    add("1/k = 0", "steep", [](Random& random, double d, Span n) {
        const double k = inverse(d, 1e7);
        n[0] = about(random, 3 * pi / k);
        n[1] = n[0] + uniform(random, 0.3, 1) * pi / k;
        set_slope(random, n, either(random, k));
    });
    add("1/phi = 0", "offset", [](Random& random, double d, Span n) {
        const double shift = either(random, 2 * pi * std::round(inverse(d, most_turns)));
        n[0] += shift;
        n[1] += shift;
        set_boundary(n, uniform(random, 0, pi), uniform(random, 0, pi));
    });
    add("boundary below theta0", "negative", [](Random& random, double d, Span n) {
        n[2] = uniform(random, 0.5, 1) * pi;
        const double below = n[2] - std::min(d, 0.5);
        set_boundary(n, uniform(random, 0, 1) * below, uniform(random, 0, 1) * below);
    });
    return loci;
}

std::size_t trailing_size(Trailing trailing) {
    switch (trailing) {
    case Trailing::nothing:
        return 0;
    case Trailing::angle:
        return 1;
    case Trailing::two_angles:
        return 2;
    case Trailing::vector:
        return 3;
    case Trailing::two_vectors:
        break;
    }
    return 6;
}

void draw_trailing(Random& random, Trailing trailing, Span rest) {
    if (trailing == Trailing::angle || trailing == Trailing::two_angles)
        for (double& angle : rest) angle = uniform(random, -pi, pi);
    else
        for (std::size_t i = 0; i + 3 <= rest.size(); i += 3)
            put(rest.subspan(i), direction(random) * uniform(random, 0.5, 2));
}

} // namespace

std::shared_ptr<const Generator> boundary_cells(Trailing trailing) {
    auto generator = std::make_shared<Generator>();
    generator->name = "cells under a boundary";
    const std::size_t rest = trailing_size(trailing);
    generator->draw = [trailing](Random& random, Span n) {
        draw_boundary_cell(random, n);
        // From a stream of its own: a cell is the same whatever follows it, and its truths are found once.
        Random of_rest(random.bits());
        draw_trailing(of_rest, trailing, n.subspan(5));
    };
    generator->loci = boundary_loci();
    if (trailing == Trailing::vector || trailing == Trailing::two_vectors)
        for (std::size_t vector = 0; vector < rest / 3; ++vector)
            generator->loci.push_back(
                {vector + 1 == rest / 3 && vector > 0 ? "p on the pole" : "n on the pole", "axis",
                 [vector](Random& random, double d, Span n) {
                     n[5 + 3 * vector] = about(random, d);
                     n[6 + 3 * vector] = about(random, d);
                 }});
    return generator;
}

bool is_boundary_cell(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return std::abs(n[1] - n[0]) <= 2 * pi + 1e-5 && is_polar(n[2]) && is_polar(n[3] * n[0] + n[4]) &&
           is_polar(n[3] * n[1] + n[4]);
}

} // namespace gnomon::stiffness
