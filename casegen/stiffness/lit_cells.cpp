// Lit cells: phi, half, theta0, rise (2), n (3), p (3), lambda, mu, versines (2).
#include "casegen/stiffness/draw.h"

#include <fmt/format.h>

namespace gnomon::stiffness {
namespace {

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
    if (n[11] * n[14] > 40) n[11] = 40 / n[14];
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
    for (const AxisLocus& locus : axis_loci())
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

std::shared_ptr<const Generator> lit_cells() {
    auto generator = std::make_shared<Generator>();
    generator->name = "lit cells";
    generator->draw = draw_lit_cell;
    generator->loci = lit_cell_loci();
    return generator;
}

bool is_lit_cell(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    const glm::dvec3 p(n[8], n[9], n[10]);
    const double length = glm::length(p);
    if (!(std::abs(n[1]) <= pi + 1e-5 && is_polar(n[2]) && is_polar(n[2] + n[3]) && is_polar(n[2] + n[4]) &&
          std::abs(length - 1) < 1e-3 && n[11] * std::min(n[13], n[14]) <= 104 &&
          n[11] * std::abs(n[13] - n[14]) <= 4 * sharpest))
        return false;
    // The fit is made for all that x does in the cell: beyond its interval it means nothing. (A thousandth of
    // its width, or a few roundings, is no harm.)
    const double low = std::min({n[2], n[2] + n[3], n[2] + n[4]}),
                 high = std::max({n[2], n[2] + n[3], n[2] + n[4]});
    const double far = 1 + dot_highest(n[0], n[1], low, high, -p / length),
                 near = 1 - dot_highest(n[0], n[1], low, high, p / length);
    const double slack = 1e-3 * (far - near) + 1e-6 * far + 1e-12;
    return near >= std::min(n[13], n[14]) - slack && far <= std::max(n[13], n[14]) + slack;
}

} // namespace gnomon::stiffness
