#include "casegen/stiffness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace gnomon::stiffness {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double most_turns =
    1000; ///< whole turns that φ is moved by: beyond 8192 radians no float knows its sine
constexpr double sharpest = 1e6; ///< λq
using Span = std::span<double>;

double uniform(Random& random, double lower, double upper) { return lower + (upper - lower) * random.unit(); }
double over_decades(Random& random, double lower, double upper) {
    return std::exp(uniform(random, std::log(lower), std::log(upper)));
}
double either(Random& random, double value) { return random.chance(0.5) ? -value : value; }
/// A distance that is not the same on both sides, nor at both ends.
double about(Random& random, double distance) { return either(random, distance * uniform(random, 0.5, 1)); }
double inverse(double distance, double most) { return distance > 0 ? std::min(1 / distance, most) : most; }

glm::dvec3 direction(Random& random) {
    const double z = uniform(random, -1, 1), phi = uniform(random, -pi, pi), u = std::sqrt(1 - z * z);
    return {u * std::cos(phi), u * std::sin(phi), z};
}
glm::dvec3 direction(double phi, double theta) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
void put(Span to, glm::dvec3 v) { to[0] = v.x, to[1] = v.y, to[2] = v.z; }

bool is_polar(double theta) { return theta >= -1e-5 && theta <= pi + 1e-5; }
/// What the device sees of it.
double as_float(double number) { return static_cast<double>(static_cast<float>(number)); }

// --- Cells under a boundary: phi0, phi1, theta0, k, b
// -----------------------------------------------------------

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
            [k0](Random& random, double d, Span n) { set_slope(random, n, k0 + about(random, d)); });
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

// --- Waves
// ------------------------------------------------------------------------------------------------------

void draw_wave(Random& random, Span n, int phases, bool wave) {
    const double width =
        random.chance(0.5) ? uniform(random, 0.05, 2 * pi) : over_decades(random, 0.01, 2 * pi);
    n[0] = uniform(random, -pi, pi);
    n[1] = n[0] + width;
    if (random.chance(0.1)) std::swap(n[0], n[1]);
    std::size_t i = 2;
    for (int phase = 0; phase < phases; ++phase) n[i++] = uniform(random, -pi, pi);
    if (!wave) return;
    n[i++] = random.chance(0.5) ? uniform(random, -6, 6) : either(random, over_decades(random, 0.01, 30));
    n[i] = uniform(random, -pi, pi);
}

// --- Lobes
// ------------------------------------------------------------------------------------------------------

struct LobeNumbers { // as drawn; versines of the interval's ends
    double far = 1, near = 0, lambda = 1, mu = 1;
};

LobeNumbers draw_lobe(Random& random) {
    LobeNumbers lobe;
    const double width = random.chance(0.5) ? uniform(random, 0.01, 2) : over_decades(random, 1e-6, 2);
    lobe.near = random.chance(0.3) ? 0 : uniform(random, 0, 2 - width);
    lobe.far = lobe.near + width;
    lobe.lambda = over_decades(random, 0.01, 1000);
    // Not so far that nothing is left of it.
    if (lobe.lambda * lobe.near > 80) lobe.lambda = uniform(random, 0, 80) / lobe.near;
    lobe.mu = either(random, uniform(random, 0.01, 10));
    return lobe;
}

using PlaceLobe = std::function<void(Random&, double, LobeNumbers&)>;
struct LobeLocus {
    const char* name;
    const char* group;
    PlaceLobe place;
};

/// λ for this λq, the interval moved to the lobe if too little of it would be left.
void set_m(LobeNumbers& lobe, double m) {
    const double q = 0.5 * (lobe.far - lobe.near);
    lobe.lambda = m / q;
    if (lobe.lambda * lobe.near > 80) {
        lobe.near = 40 / lobe.lambda;
        lobe.far = lobe.near + 2 * q;
    }
}

const std::vector<LobeLocus>& lobe_loci() {
    static const std::vector<LobeLocus> loci{
        {"lambda q = 0", "flat lobe",
         [](Random& random, double d, LobeNumbers& lobe) { set_m(lobe, d * uniform(random, 0.5, 1)); }},
        {"width = 0", "flat lobe",
         [](Random& random, double d, LobeNumbers& lobe) {
             lobe.far = lobe.near + d * uniform(random, 0.5, 1);
         }},
        {"1 / lambda q = 0", "sharp lobe",
         [](Random& random, double d, LobeNumbers& lobe) {
             set_m(lobe, inverse(d, sharpest) * uniform(random, 0.5, 1));
         }},
        {"lambda q = 1", "joins",
         [](Random& random, double d, LobeNumbers& lobe) { set_m(lobe, 1 + about(random, d)); }},
        {"lambda q = 3", "joins",
         [](Random& random, double d, LobeNumbers& lobe) { set_m(lobe, 3 + about(random, d)); }},
        {"lambda q = 88", "joins",
         [](Random& random, double d, LobeNumbers& lobe) { set_m(lobe, 88 + 10 * about(random, d)); }},
        {"peak", "peak",
         [](Random& random, double d, LobeNumbers& lobe) {
             const double width = lobe.far - lobe.near;
             lobe.near = d * random.unit();
             lobe.far = lobe.near + std::min(width, random.chance(0.5) ? d + 1e-12 : 2 - lobe.near);
             lobe.lambda = over_decades(random, 1, 1e6);
         }},
        {"far from the peak", "far",
         [](Random& random, double d, LobeNumbers& lobe) {
             lobe.near = uniform(random, 0.1, 1);
             lobe.far = lobe.near + uniform(random, 0.01, 1);
             lobe.lambda = (100 - 99 * std::sqrt(d)) / lobe.near;
         }},
        {"mu = 0", "mu", [](Random& random, double d, LobeNumbers& lobe) { lobe.mu = about(random, d); }},
        {"the whole sphere", "whole",
         [](Random& random, double d, LobeNumbers& lobe) {
             lobe.near = d * random.unit();
             lobe.far = 2 - d * random.unit();
             lobe.lambda = over_decades(random, 0.1, 200);
             if (lobe.lambda * lobe.near > 80) lobe.lambda = 80 / lobe.near;
         }},
        {"a = b", "reversed",
         [](Random& random, double d, LobeNumbers& lobe) {
             lobe.far = std::max(0.0, lobe.near - d * random.unit());
         }},
    };
    return loci;
}

std::shared_ptr<const Generator> lobe_generator(const char* name,
                                                void (*put_lobe)(const LobeNumbers&, Span)) {
    auto generator = std::make_shared<Generator>();
    generator->name = name;
    generator->draw = [put_lobe](Random& random, Span n) { put_lobe(draw_lobe(random), n); };
    for (const LobeLocus& locus : lobe_loci())
        generator->loci.push_back(
            {locus.name, locus.group, [&locus, put_lobe](Random& random, double d, Span n) {
                 LobeNumbers lobe = draw_lobe(random);
                 locus.place(random, d, lobe);
                 put_lobe(lobe, n);
             }});
    return generator;
}

// --- Cells and axes
// ---------------------------------------------------------------------------------------------

/// An axis at this distance from a part of the cell φ ± half, θ0 … θ1.
struct AxisLocus {
    const char* name;
    glm::dvec3 (*axis)(Random&, double d, double phi, double half, double theta0, double theta1);
};
const AxisLocus axis_loci[] = {
    {"axis inside",
     [](Random& random, double d, double phi, double half, double theta0, double theta1) {
         // On the middle and from there: inside for most cells.
         return direction(phi + half * about(random, d),
                          0.5 * (theta0 + theta1) + about(random, d) * 0.5 * (theta1 - theta0));
     }},
    {"axis on a theta edge",
     [](Random& random, double d, double phi, double half, double theta0, double) {
         return direction(phi + half * uniform(random, -1, 1), theta0 + about(random, d));
     }},
    {"axis on a phi edge",
     [](Random& random, double d, double phi, double half, double theta0, double theta1) {
         return direction(phi + half + about(random, d), uniform(random, theta0, theta1));
     }},
    {"axis on a corner",
     [](Random& random, double d, double phi, double half, double, double theta1) {
         return direction(phi - half + about(random, d), theta1 + about(random, d));
     }},
    {"axis opposite",
     [](Random& random, double d, double phi, double half, double theta0, double theta1) {
         return -direction(phi + half * about(random, d), 0.5 * (theta0 + theta1) + about(random, d));
     }},
    {"axis on the pole", // u = 0
     [](Random& random, double d, double, double, double, double) {
         return either(random, 1) * direction(uniform(random, -pi, pi), d * random.unit());
     }},
    {"axis on the equator", // v = 0
     [](Random& random, double d, double, double, double, double) {
         return direction(uniform(random, -pi, pi), 0.5 * pi + about(random, d));
     }},
};

void draw_cell_and_axis(Random& random, Span n) {
    n[0] = uniform(random, -pi, pi);
    n[1] = random.chance(0.3) ? uniform(random, 0, pi) : over_decades(random, 0.01, 1);
    n[2] = uniform(random, 0, pi);
    n[3] = random.chance(0.3) ? uniform(random, 0, pi)
                              : std::clamp(n[2] + over_decades(random, 0.01, 1), 0.0, pi);
    if (n[3] < n[2]) std::swap(n[2], n[3]);
    const bool near = random.chance(0.5); // within a cell or two
    put(n.subspan(4), near ? direction(n[0] + 4 * n[1] * uniform(random, -1, 1),
                                       uniform(random, n[2] - (n[3] - n[2]), n[3] + (n[3] - n[2])))
                           : direction(random));
}

// --- Lit cells: phi, half, theta0, rise (2), n (3), p (3), lambda, mu, versines (2)
// -------------------------------

/// The highest value of c cos t + s sin t over |t| <= half.
double highest(double c, double s, double half) {
    const double peak = std::hypot(c, s);
    return half >= pi || c >= peak * std::cos(half) ? peak
                                                    : c * std::cos(half) + std::abs(s) * std::sin(half);
}
double dot_highest(double phi, double half, double theta0, double theta1, glm::dvec3 p) {
    const double amplitude = highest(p.x * std::cos(phi) + p.y * std::sin(phi),
                                     p.y * std::cos(phi) - p.x * std::sin(phi), std::abs(half));
    const double middle = 0.5 * (theta0 + theta1);
    return highest(amplitude * std::sin(middle) + p.z * std::cos(middle),
                   amplitude * std::cos(middle) - p.z * std::sin(middle), 0.5 * std::abs(theta1 - theta0));
}

/// The interval of the lobe over the cell's bounding rectangle, from what the device will see of the cell.
void set_versines(Span n) {
    const double theta0 = as_float(n[2]), first = theta0 + as_float(n[3]), last = theta0 + as_float(n[4]);
    const double low = std::min({theta0, first, last}), high = std::max({theta0, first, last});
    const glm::dvec3 p(as_float(n[8]), as_float(n[9]), as_float(n[10]));
    n[13] = std::clamp(1 + dot_highest(as_float(n[0]), as_float(n[1]), low, high, -p), 0.0, 2.0);
    n[14] = std::clamp(1 - dot_highest(as_float(n[0]), as_float(n[1]), low, high, p), 0.0, 2.0);
    // A lobe of which nothing is left teaches nothing.
    if (n[11] * n[14] > 60) n[11] = 60 / n[14];
}
double low_theta(Span n) { return std::min({n[2], n[2] + n[3], n[2] + n[4]}); }
double high_theta(Span n) { return std::max({n[2], n[2] + n[3], n[2] + n[4]}); }
void set_rise(Span n, double first, double last) {
    n[3] = first - n[2];
    n[4] = last - n[2];
}

void draw_lit_cell(Random& random, Span n) {
    n[0] = uniform(random, -pi, pi);
    n[1] = random.chance(0.3) ? uniform(random, 0, pi) : over_decades(random, 0.01, 1);
    n[2] = uniform(random, 0, pi);
    const double reach = random.chance(0.5) ? pi : over_decades(random, 0.01, 1);
    const auto height = [&] { return std::clamp(n[2] + reach * random.unit(), 0.0, pi); };
    const double first = height();
    set_rise(n, first, height());
    put(n.subspan(5), direction(random));
    put(n.subspan(8), random.chance(0.5) ? direction(random)
                                         : direction(n[0] + 2 * n[1] * uniform(random, -1, 1),
                                                     uniform(random, low_theta(n), high_theta(n))));
    n[11] = over_decades(random, 0.1, 1e4);
    n[12] = uniform(random, 0.1, 2);
    if (random.chance(0.1)) n[12] = -n[12];
    if (random.chance(0.05)) n[1] = -n[1];
    set_versines(n);
}

std::vector<Locus> lit_cell_loci() {
    std::vector<Locus> loci;
    const auto add = [&](std::string name, std::string group,
                         std::function<void(Random&, double, Span)> place) {
        loci.push_back({std::move(name), std::move(group), [place](Random& random, double d, Span n) {
                            place(random, d, n);
                            set_versines(n);
                        }});
    };
    add("size = 0", "small", [](Random& random, double d, Span n) {
        n[1] = d * uniform(random, 0.5, 1);
        set_rise(n, std::min(pi, n[2] + d * random.unit()), std::min(pi, n[2] + d * random.unit()));
        put(n.subspan(8), random.chance(0.5)
                              ? direction(random)
                              : direction(n[0] + 2 * about(random, d), n[2] + 2 * about(random, d)));
        n[11] = over_decades(random, 1, 1e6);
    });
    add("half_width = 0", "narrow",
        [](Random& random, double d, Span n) { n[1] = d * uniform(random, 0.5, 1); });
    add("half_width = pi", "full turn",
        [](Random& random, double d, Span n) { n[1] = pi - d * random.unit(); });
    add("rise = 0", "slab", [](Random& random, double d, Span n) {
        const double first = std::clamp(n[2] + about(random, d), 0.0, pi);
        set_rise(n, first, std::clamp(n[2] + about(random, d), 0.0, pi));
    });
    for (const bool south : {false, true})
        add(south ? "theta = pi" : "theta = 0", "pole", [south](Random& random, double d, Span n) {
            const auto near = [&](double distance) { return south ? pi - distance : distance; };
            n[2] = near(d * random.unit());
            const double first = near(d == 0 ? random.unit() : d * random.unit());
            set_rise(n, first, near(d == 0 ? random.unit() : d * random.unit()));
        });
    add("1 / boundary's slope = 0", "steep", [](Random& random, double d, Span n) {
        n[1] = 1 / inverse(d, 1e7);
        n[2] = uniform(random, 0, pi);
        const double first = uniform(random, 0, pi);
        set_rise(n, first, uniform(random, 0, pi));
    });
    add("1/phi = 0", "offset", [](Random& random, double d, Span n) {
        n[0] += either(random, 2 * pi * std::round(inverse(d, most_turns)));
    });
    add("boundary below theta0", "negative", [](Random& random, double d, Span n) {
        n[2] = uniform(random, 0.5, 1) * pi;
        const double below = n[2] - std::min(d, 0.5), first = below * random.unit();
        set_rise(n, first, below * random.unit());
    });
    add("lambda q = 0", "flat lobe", [](Random& random, double d, Span n) {
        set_versines(n);
        n[11] = d * uniform(random, 0.5, 1) / std::max(1e-12, 0.5 * (n[13] - n[14]));
    });
    add("1 / lambda q = 0", "sharp lobe", [](Random& random, double d, Span n) {
        put(n.subspan(8),
            direction(n[0] + n[1] * uniform(random, -1, 1), uniform(random, low_theta(n), high_theta(n))));
        set_versines(n);
        n[11] = std::min(1e8, inverse(d, sharpest) * uniform(random, 0.5, 1) /
                                  std::max(1e-12, 0.5 * (n[13] - n[14])));
    });
    add("mu = 0", "mu", [](Random& random, double d, Span n) { n[12] = about(random, d); });
    for (const AxisLocus& locus : axis_loci)
        add(locus.name, "axis", [&locus](Random& random, double d, Span n) {
            put(n.subspan(8), locus.axis(random, d, n[0], n[1], low_theta(n), high_theta(n)));
            n[11] = over_decades(random, 0.1, 1e6);
        });
    add("normal on the pole", "axis", [](Random& random, double d, Span n) {
        put(n.subspan(5), direction(uniform(random, -pi, pi), d * random.unit()) * either(random, 1));
    });
    return loci;
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

std::shared_ptr<const Generator> waves(int phases, bool wave) {
    auto generator = std::make_shared<Generator>();
    generator->name = "waves";
    generator->draw = [phases, wave](Random& random, Span n) { draw_wave(random, n, phases, wave); };
    const auto add = [&](std::string name, std::string group,
                         std::function<void(Random&, double, Span)> place) {
        generator->loci.push_back({std::move(name), std::move(group), std::move(place)});
    };
    const auto s = static_cast<std::size_t>(2 + phases);
    if (wave)
        for (const double s0 : {0.0, 1.0, -1.0, 2.0, -2.0})
            add(fmt::format("s = {}", s0), "s",
                [s, s0](Random& random, double d, Span n) { n[s] = s0 + about(random, d); });
    add("phi1 - phi0 = 0", "narrow",
        [](Random& random, double d, Span n) { n[1] = n[0] + about(random, d); });
    add("phi1 - phi0 = 2 pi", "full turn", [](Random&, double d, Span n) { n[1] = n[0] + 2 * pi - d; });
    add("1/phi = 0", "offset", [s, wave](Random& random, double d, Span n) {
        // No further than the second wave is known.
        const double most = 7000 / (2 * pi * (wave ? std::abs(n[s]) + 2 : 1));
        const double shift = either(random, 2 * pi * std::floor(inverse(d, std::min(most, most_turns))));
        n[0] += shift;
        n[1] += shift;
    });
    if (wave)
        add("1/s = 0", "fast", [s](Random& random, double d, Span n) {
            const double frequency = inverse(d, 1e4);
            n[s] = either(random, frequency);
            n[0] = about(random, 3 * pi / frequency);
            n[1] = n[0] + uniform(random, 0.3, 1) * pi / frequency;
        });
    return generator;
}

std::function<bool(const Arguments&)> is_wave(std::size_t s) {
    return [s](const Arguments& arguments) {
        const auto& n = arguments.numbers;
        const double width = std::abs(n[1] - n[0]), far = std::max(std::abs(n[0]), std::abs(n[1]));
        return width <= 2 * pi + 1e-5 &&
               (s == 0 || (width * std::abs(n[s]) <= 200 && far * (std::abs(n[s]) + 2) <= 8000));
    };
}

std::shared_ptr<const Generator> lobes() {
    return lobe_generator("lobes", [](const LobeNumbers& lobe, Span n) {
        n[0] = lobe.far, n[1] = lobe.near, n[2] = lobe.lambda, n[3] = lobe.mu;
    });
}
std::shared_ptr<const Generator> lobes_of_ends() {
    return lobe_generator("lobes by their ends", [](const LobeNumbers& lobe, Span n) {
        n[0] = 1 - lobe.far, n[1] = 1 - lobe.near, n[2] = lobe.lambda, n[3] = lobe.mu;
    });
}
bool is_lobe(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return n[2] * std::min(n[0], n[1]) <= 104 && std::abs(n[0] - n[1]) * n[2] <= 4 * sharpest;
}
bool is_lobe_of_ends(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return n[2] * (1 - std::max(n[0], n[1])) <= 104 && std::abs(n[0] - n[1]) * n[2] <= 4 * sharpest;
}

std::shared_ptr<const Generator> cells_and_axes() {
    auto generator = std::make_shared<Generator>();
    generator->name = "cells and axes";
    generator->draw = draw_cell_and_axis;
    for (const AxisLocus& locus : axis_loci)
        generator->loci.push_back({locus.name, "axis", [&locus](Random& random, double d, Span n) {
                                       put(n.subspan(4), locus.axis(random, d, n[0], n[1], n[2], n[3]));
                                   }});
    generator->loci.push_back({"half_width = 0", "narrow",
                               [](Random& random, double d, Span n) { n[1] = d * uniform(random, 0.5, 1); }});
    generator->loci.push_back({"half_width = pi", "full turn",
                               [](Random& random, double d, Span n) { n[1] = pi - d * random.unit(); }});
    generator->loci.push_back({"theta1 = theta0", "slab", [](Random& random, double d, Span n) {
                                   n[3] = std::min(pi, n[2] + d * random.unit());
                               }});
    generator->loci.push_back({"size = 0", "small", [](Random& random, double d, Span n) {
                                   n[1] = d * uniform(random, 0.5, 1);
                                   n[3] = std::min(pi, n[2] + d * random.unit());
                                   put(n.subspan(4),
                                       direction(n[0] + 2 * about(random, d), n[2] + 2 * about(random, d)));
                               }});
    generator->loci.push_back({"theta = 0", "pole", [](Random& random, double d, Span n) {
                                   n[2] = d * random.unit();
                                   n[3] = n[2] + (d == 0 ? 1 : d) * random.unit();
                               }});
    generator->loci.push_back({"theta = pi", "pole", [](Random& random, double d, Span n) {
                                   n[3] = pi - d * random.unit();
                                   n[2] = n[3] - (d == 0 ? 1 : d) * random.unit();
                               }});
    return generator;
}

bool is_cell_and_axis(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return is_polar(n[2]) && is_polar(n[3]) && std::abs(n[1]) <= pi + 1e-5 &&
           std::abs(std::hypot(n[4], n[5], n[6]) - 1) < 1e-6;
}

std::shared_ptr<const Generator> lit_cells() {
    auto generator = std::make_shared<Generator>();
    generator->name = "lit cells";
    generator->draw = draw_lit_cell;
    generator->loci = lit_cell_loci();
    return generator;
}

bool is_lit_cell(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return std::abs(n[1]) <= pi + 1e-5 && is_polar(n[2]) && is_polar(n[2] + n[3]) && is_polar(n[2] + n[4]) &&
           std::abs(std::hypot(n[8], n[9], n[10]) - 1) < 1e-3 && n[11] * std::min(n[13], n[14]) <= 104 &&
           n[11] * std::abs(n[13] - n[14]) <= 4 * sharpest;
}

} // namespace gnomon::stiffness
