#include "casegen/hybrid/triangles.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::hybrid {
namespace {

double log_uniform(Random& random, double lower, double upper) {
    return std::exp(std::log(lower) + random.unit() * std::log(upper / lower));
}
double symmetric(Random& random) { return 2 * random.unit() - 1; }
double within(double x) { return std::clamp(x, -farthest, farthest); }

struct Corner {
    double x, y;
};
Corner corner(std::span<const double> numbers, const Layout& layout, std::size_t i) {
    return {numbers[i * layout.stride], numbers[i * layout.stride + 1]};
}
void place(std::span<double> numbers, const Layout& layout, std::size_t i, Corner at) {
    numbers[i * layout.stride] = within(at.x);
    numbers[i * layout.stride + 1] = within(at.y);
}
double length(Corner a, Corner b) { return std::hypot(b.x - a.x, b.y - a.y); }

/// The inscribed circle's radius.
double radius(std::span<const double> numbers, const Layout& layout) {
    const Corner a = corner(numbers, layout, 0), b = corner(numbers, layout, 1),
                 c = corner(numbers, layout, 2);
    const double area = std::abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
    const double around = length(a, b) + length(b, c) + length(c, a);
    return around > 0 ? area / around : 0;
}

/// Twice the area over an edge's length.
std::array<double, 3> heights(std::span<const double> numbers, const Layout& layout) {
    std::array<Corner, 3> at;
    for (std::size_t i = 0; i < 3; ++i) at[i] = corner(numbers, layout, i);
    double around = 0;
    std::array<double, 3> lengths;
    for (std::size_t i = 0; i < 3; ++i) around += lengths[i] = length(at[i], at[(i + 1) % 3]);
    for (double& each : lengths) each = each > 0 ? radius(numbers, layout) * around / each : 0;
    return lengths;
}

void draw(Random& random, std::span<double> numbers, const Layout& layout) {
    // Half of the triangles are of a map's scale: in [-1, 1], of a few texels.
    const bool in_map = random.chance(0.5);
    const double size = in_map ? log_uniform(random, 1e-3, 1) : log_uniform(random, 1e-6, 5e5);
    const double away = in_map                ? 1
                        : random.chance(0.25) ? std::min(size * log_uniform(random, 1, 1e3), 4e5)
                                              : 0;
    const Corner middle{away * symmetric(random), away * symmetric(random)};
    for (std::size_t i = 0; i < 3; ++i)
        place(numbers, layout, i, {middle.x + size * symmetric(random), middle.y + size * symmetric(random)});
    for (const std::size_t at : layout.depths) numbers[at] = random.unit();
    for (const std::size_t at : layout.points) {
        numbers[at] = within(middle.x + 1.5 * size * symmetric(random));
        numbers[at + 1] = within(middle.y + 1.5 * size * symmetric(random));
    }
    for (const std::size_t at : layout.extents) numbers[at] = size * log_uniform(random, 1e-3, 1);
    if (layout.distance >= 0)
        numbers[static_cast<std::size_t>(layout.distance)] =
            radius(numbers, layout) * (random.chance(0.1) ? 0 : log_uniform(random, 1e-3, 3));
    for (std::size_t i = 0; i < layout.counts.size(); ++i) {
        const auto [at, largest] = layout.counts[i];
        numbers[at] = random.below(largest + 1);
        if (i == 0 && !layout.choices_away.empty())
            numbers[at] =
                layout.choices_away[random.below(static_cast<std::uint32_t>(layout.choices_away.size()))];
    }
}

} // namespace

std::shared_ptr<const Generator> triangles(const char* name, const Layout& layout) {
    auto generator = std::make_shared<Generator>();
    generator->name = name;
    generator->draw = [layout](Random& random, std::span<double> numbers) { draw(random, numbers, layout); };
    generator->loci.push_back(
        {"corners in a line", "slivers",
         [layout](Random& random, double distance, std::span<double> numbers) {
             const Corner a = corner(numbers, layout, 0), b = corner(numbers, layout, 1);
             const double t = 3 * symmetric(random), side = random.chance(0.5) ? -distance : distance;
             place(numbers, layout, 2,
                   {a.x + t * (b.x - a.x) - side * (b.y - a.y), a.y + t * (b.y - a.y) + side * (b.x - a.x)});
             if (layout.distance >= 0)
                 numbers[static_cast<std::size_t>(layout.distance)] =
                     random.chance(0.5) ? random.unit() * radius(numbers, layout)
                                        : random.unit() * length(a, b);
         }});
    generator->loci.push_back(
        {"two corners at one place", "slivers",
         [layout](Random& random, double distance, std::span<double> numbers) {
             const Corner a = corner(numbers, layout, 0), b = corner(numbers, layout, 1);
             const double reach = distance * length(a, b);
             place(numbers, layout, 2, {b.x + reach * symmetric(random), b.y + reach * symmetric(random)});
             if (layout.distance >= 0)
                 numbers[static_cast<std::size_t>(layout.distance)] = random.unit() * radius(numbers, layout);
         }});
    if (layout.distance >= 0)
        generator->loci.push_back({"lambda as the inscribed radius", "lambda",
                                   [layout](Random& random, double distance, std::span<double> numbers) {
                                       numbers[static_cast<std::size_t>(layout.distance)] =
                                           radius(numbers, layout) *
                                           (random.chance(0.5) ? 1 + distance : 1 - distance);
                                   }});
    return generator;
}

std::shared_ptr<const Generator> shrunken_triangles(const char* name, const Layout& layout) {
    auto generator = std::make_shared<Generator>(*triangles(name, layout));
    const auto at = static_cast<std::size_t>(layout.distance);
    // An edge is lost where the cuts, or edges that move in, at both its ends use it up: each uses lambda
    // over the sine there, which is lambda / height of the edge's length.
    const auto lost = [](double one_height, double other_height) {
        const double sum = one_height + other_height;
        return sum > 0 ? one_height * other_height / sum : 0;
    };
    generator->draw = [layout, at, lost](Random& random, std::span<double> numbers) {
        draw(random, numbers, layout);
        if (random.chance(0.5)) return;
        const std::array<double, 3> h = heights(numbers, layout);
        const double r = radius(numbers, layout);
        std::array<double, 10> changes{
            0, r, 2 * r, lost(h[0], h[1]), lost(h[1], h[2]), lost(h[2], h[0]), h[0], h[1], h[2], 0};
        changes[9] = 1.25 * *std::max_element(changes.begin(), changes.end());
        std::sort(changes.begin(), changes.end());
        const std::size_t i = random.below(9);
        numbers[at] = within(changes[i] + random.unit() * (changes[i + 1] - changes[i]));
    };
    const auto add = [&](const char* what, auto distance_of) {
        generator->loci.push_back(
            {what, "lambda",
             [layout, at, distance_of](Random& random, double distance, std::span<double> numbers) {
                 const double of = distance_of(random, heights(numbers, layout));
                 numbers[at] = within(of * (random.chance(0.5) ? 1 + distance : 1 - distance));
             }});
    };
    add("lambda where an edge is lost", [lost](Random& random, const std::array<double, 3>& h) {
        const std::size_t i = random.below(3);
        return lost(h[i], h[(i + 1) % 3]);
    });
    add("lambda as a height",
        [](Random& random, const std::array<double, 3>& h) { return h[random.below(3)]; });
    add("lambda as the inscribed diameter", [](Random&, const std::array<double, 3>& h) {
        return h[0] > 0 ? 2 / (1 / h[0] + 1 / h[1] + 1 / h[2]) : 0;
    });
    return generator;
}

} // namespace gnomon::hybrid
