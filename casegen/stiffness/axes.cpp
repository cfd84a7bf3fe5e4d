// Cells and axes: phi, half, theta (2), p (3).
#include "casegen/stiffness/draw.h"

#include <fmt/format.h>

namespace gnomon::stiffness {
namespace {

const AxisLocus loci_of_axes[] = {
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

} // namespace

std::span<const AxisLocus> axis_loci() { return loci_of_axes; }

std::shared_ptr<const Generator> cells_and_axes() {
    auto generator = std::make_shared<Generator>();
    generator->name = "cells and axes";
    generator->draw = [](Random& random, Span n) {
        draw_cell_and_axis(random, n);
        if (random.chance(0.3))
            put(n.subspan(4), glm::dvec3(n[4], n[5], n[6]) * over_decades(random, 0.01, 1));
    };
    for (const AxisLocus& locus : axis_loci())
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
    generator->loci.push_back({"axis along an axis", "axis", [](Random& random, double d, Span n) {
                                   const std::size_t along = 4 + random.below(3);
                                   for (std::size_t i = 4; i < 7; ++i)
                                       n[i] = i == along ? either(random, 1) : about(random, d);
                                   put(n.subspan(4), glm::normalize(glm::dvec3(n[4], n[5], n[6])));
                               }});
    // Whose square is no float.
    generator->loci.push_back({"length = 0", "axis", [](Random& random, double d, Span n) {
                                   const double length = std::max(1e-29, d * d * d);
                                   put(n.subspan(4), direction(random) * length);
                               }});
    return generator;
}

bool is_cell_and_axis(const Arguments& arguments) {
    const auto& n = arguments.numbers;
    return is_polar(n[2]) && is_polar(n[3]) && std::abs(n[1]) <= pi + 1e-5 &&
           std::hypot(n[4], n[5], n[6]) > 1e-30;
}

} // namespace gnomon::stiffness
