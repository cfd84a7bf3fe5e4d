#include "casegen/hybrid/column_inputs.h"

#include "casegen/hybrid/triangles.h"

#include <algorithm>
#include <cmath>

namespace gnomon::hybrid {
namespace {

/// Triangles, with a margin at `margin`: as small as roundings of the coordinates, which is what the pipeline
/// asks for, or as large as the triangles.
std::shared_ptr<Generator> with_margin(const char* name, const Layout& layout, std::size_t margin,
                                       std::size_t margin_z = 0) {
    auto generator = std::make_shared<Generator>(*triangles(name, layout));
    const auto small = [layout, margin, margin_z](Random& random, std::span<double> numbers) {
        double largest = 0;
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t k = 0; k < 2; ++k)
                largest = std::max(largest, std::abs(numbers[i * layout.stride + k]));
        numbers[margin] = largest * std::exp2(-24 + 3 + 10 * random.unit());
        if (margin_z != 0) numbers[margin_z] = std::exp2(-24 + 3 + 10 * random.unit());
    };
    generator->draw = [draw = generator->draw, small](Random& random, std::span<double> numbers) {
        draw(random, numbers);
        if (random.chance(0.75)) small(random, numbers);
    };
    return generator;
}

double to_either_side(Random& random, double distance) {
    return random.chance(0.5) ? 1 + distance : 1 - distance;
}
double in_map(double x) { return std::clamp(x, -farthest, farthest); }

/// A point as near to an edge as makes column_coverage unsure. The edge lies on an axis, where products of
/// the small offset are good to its last digits.
Locus beside_an_edge(std::size_t stride, std::size_t point, std::size_t margin) {
    return {"as far from an edge as is unsure", "margins",
            [stride, point, margin](Random& random, double distance, std::span<double> n) {
                const double size = std::exp2(-10 + 20 * random.unit());
                const auto any = [&] { return size * (2 * random.unit() - 1); };
                const std::size_t first = random.below(3), axis = random.below(2), other = 1 - axis;
                const std::size_t a = first * stride, b = (first + 1) % 3 * stride,
                                  c = (first + 2) % 3 * stride;
                n[a + axis] = any(), n[b + axis] = any(), n[a + other] = n[b + other] = 0;
                n[c + axis] = any(), n[c + other] = any() * std::exp2(3 * random.unit() - 1);
                n[point + axis] = n[a + axis] + random.unit() * (n[b + axis] - n[a + axis]);
                n[margin] = random.chance(0.5) ? 0 : size * std::exp2(-6 - 20 * random.unit());
                double far = std::abs(n[c + other]);
                for (const std::size_t corner : {a, b, c})
                    far = std::max(far, std::abs(n[corner + axis] - n[point + axis]));
                const double off = std::max(2 * n[margin], 0x1p-21 * far) * to_either_side(random, distance);
                n[point + other] = random.chance(0.9) ? std::copysign(off, n[c + other]) : -off;
            }};
}

/// Small whole numbers, some of them alike; lengths from `lengths` on.
Locus on_a_coarse_grid(std::size_t lengths) {
    return {"on a coarse grid", "borders", [lengths](Random& random, double, std::span<double> n) {
                const int reach = random.chance(0.5) ? 4 : 32;
                const double unit = std::exp2(random.between(-20, 10));
                for (double& number : n) number = unit * random.between(-reach, reach);
                for (double& length : n.subspan(lengths)) length = std::abs(length);
            }};
}

} // namespace

std::shared_ptr<const Generator> triangles_and_squares() {
    auto generator =
        std::make_shared<Generator>(*triangles("column/overlaps", {.points = {6}, .extents = {8}}));
    generator->loci.push_back(on_a_coarse_grid(8));
    generator->loci.push_back(
        {"at the tip of a needle", "slivers", [](Random& random, double distance, std::span<double> n) {
             // The corner opposite to a short edge, from which the two long ones' rounded area is too far.
             const std::size_t tip = 2 * random.below(3), from = (tip + 2) % 6, to = (tip + 4) % 6;
             const double length = std::hypot(n[tip] - n[from], n[tip + 1] - n[from + 1]);
             n[8] = length * std::exp2(-19 + 12 * random.unit());
             for (std::size_t k = 0; k < 2; ++k) {
                 n[to + k] = in_map(n[from + k] + distance * length * (2 * random.unit() - 1));
                 n[6 + k] = in_map(n[tip + k] + n[8] * (2 * random.unit() - 1));
             }
         }});
    return generator;
}

std::shared_ptr<const Generator> triangles_and_points() {
    auto generator = with_margin("column/coverage", {.points = {6}, .extents = {8}}, 8);
    generator->loci.push_back(beside_an_edge(2, 6, 8));
    generator->loci.push_back(on_a_coarse_grid(8));
    return generator;
}

std::shared_ptr<const Generator> lines_and_points() {
    auto generator = with_margin("column/opposite", {.points = {6}, .extents = {8}}, 8);
    generator->loci.push_back(
        {"as far from the line as is unsure", "margins",
         [](Random& random, double distance, std::span<double> n) {
             // The line is an axis, as in beside_an_edge; c and d are on both sides of it.
             const double size = std::exp2(-10 + 20 * random.unit());
             const auto any = [&] { return size * (2 * random.unit() - 1); };
             const std::size_t axis = random.below(2), other = 1 - axis;
             n[axis] = any(), n[2 + axis] = any(), n[other] = n[2 + other] = 0;
             n[4 + axis] = any(), n[6 + axis] = any();
             n[4 + other] = any(), n[6 + other] = -std::copysign(any(), n[4 + other]);
             n[8] = random.chance(0.5) ? 0 : size * std::exp2(-6 - 20 * random.unit());
             const std::size_t near = random.chance(0.5) ? 4 : 6;
             const double along = std::abs(n[2 + axis] - n[axis]),
                          across = std::abs(n[near + axis] - n[axis]);
             const double off = 2 * n[8] * (1 + across / along) + 0x1p-21 * across;
             n[near + other] = in_map(std::copysign(off * to_either_side(random, distance), n[near + other]));
         }});
    generator->loci.push_back({"as large a margin as there may be", "margins",
                               [](Random& random, double distance, std::span<double> n) {
                                   const double x = n[2] - n[0], y = n[3] - n[1];
                                   double least = farthest;
                                   for (const std::size_t i : {4u, 6u}) {
                                       const double to_x = n[i] - n[0], to_y = n[i + 1] - n[1];
                                       const double all =
                                           std::abs(x) + std::abs(y) + std::abs(to_x) + std::abs(to_y);
                                       if (all > 0)
                                           least = std::min(least, std::abs(x * to_y - y * to_x) / (2 * all));
                                   }
                                   n[8] = in_map(least * to_either_side(random, distance));
                               }});
    generator->loci.push_back(on_a_coarse_grid(8));
    return generator;
}

std::shared_ptr<const Generator> triangles_and_rays() {
    auto generator =
        with_margin("column/rays",
                    {.stride = 3, .points = {9}, .extents = {12, 13, 14}, .depths = {2, 5, 8, 11}}, 13, 14);
    generator->loci.push_back(beside_an_edge(3, 9, 13));
    generator->loci.push_back(
        {"as deep as is unsure", "margins", [](Random& random, double distance, std::span<double> n) {
             // No plane; one end of the triangle's depths is 0, where nothing is rounded.
             n[13] = farthest;
             const double size = std::exp2(-10 + 20 * random.unit()), sign = random.chance(0.5) ? 1 : -1;
             double deepest = 0;
             for (const std::size_t i : {2u, 5u, 8u})
                 deepest = std::max(deepest, std::abs(n[i] = sign * size * random.unit()));
             n[14] = random.chance(0.3) ? size * std::exp2(-22 * random.unit()) : 0;
             // And from the origin to the end it is no way, or a long one.
             n[12] = random.chance(0.5) ? 0 : size * (1 + random.unit());
             n[2 + 3 * random.below(3)] = 0;
             const double off = std::max(n[14], 0x1p-22 * std::max(deepest, 2 * n[12]));
             n[11] = n[12] - sign * off * to_either_side(random, distance);
         }});
    generator->loci.push_back(
        {"depths on a coarse grid", "borders", [](Random& random, double, std::span<double> n) {
             n[2] = n[5] = n[8] = random.between(-4, 4);
             if (random.chance(0.5)) n[5] = random.between(-4, 4);
             n[11] = random.between(-4, 4), n[12] = random.between(0, 4), n[14] = random.between(0, 4);
             if (random.chance(0.5)) n[13] = farthest; // no plane
         }});
    return generator;
}

std::shared_ptr<const Generator> planes() {
    auto generator = with_margin("column/squares",
                                 {.stride = 3, .points = {9}, .extents = {11, 12}, .depths = {2, 5, 8}}, 12);
    generator->loci.push_back(
        {"as thin as a plane may be", "slivers", [](Random& random, double distance, std::span<double> n) {
             const double x = n[3] - n[0], y = n[4] - n[1], to_x = n[6] - n[0], to_y = n[7] - n[1];
             const double longest = std::max({std::abs(x) + std::abs(y), std::abs(to_x) + std::abs(to_y),
                                              std::abs(to_x - x) + std::abs(to_y - y)});
             if (longest == 0) return;
             const double margin =
                 std::abs(x * to_y - y * to_x) / (64 * longest) * to_either_side(random, distance);
             n[12] = margin;
             if (random.chance(0.5)) return;
             // Or as seen from so far away.
             n[12] = 0;
             n[9 + random.below(2)] = in_map(std::exp2(24) * (random.chance(0.5) ? margin : -margin));
         }});
    generator->loci.push_back(
        {"seen from far away", "margins", [](Random& random, double, std::span<double> n) {
             for (double& at : n.subspan(9, 2)) at = in_map(at * std::exp2(12 * random.unit()));
             n[11] = n[12] = 0;
         }});
    generator->loci.push_back(
        {"at one depth", "borders", [](Random&, double, std::span<double> n) { n[5] = n[8] = n[2]; }});
    return generator;
}

std::shared_ptr<const Generator> segments() {
    auto generator = std::make_shared<Generator>();
    generator->name = "column/segments";
    generator->draw = [](Random& random, std::span<double> n) {
        const double size = std::exp2(-13 + 30 * random.unit());
        for (std::size_t i = 0; i < 6; ++i) n[i] = size * (2 * random.unit() - 1);
        n[6] = size * std::exp2(-10 * random.unit());
        if (random.chance(0.2)) n[2] = n[0]; // along an axis
        if (random.chance(0.1)) n[3] = n[1]; // or of no length
    };
    generator->loci.push_back(
        {"through the square's corner", "corners", [](Random& random, double distance, std::span<double> n) {
             // b behind the corner as seen from a, a little off.
             const double off = 1 + distance * (2 * random.unit() - 1);
             const double x = n[4] + (random.chance(0.5) ? n[6] : -n[6]) * off,
                          y = n[5] + (random.chance(0.5) ? n[6] : -n[6]) * off;
             const double t = 1 + random.unit();
             n[2] = n[0] + t * (x - n[0]), n[3] = n[1] + t * (y - n[1]);
         }});
    generator->loci.push_back(on_a_coarse_grid(6));
    return generator;
}

} // namespace gnomon::hybrid
