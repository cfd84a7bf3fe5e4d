#include "casegen/hybrid/conservative_inputs.h"

#include "casegen/hybrid/triangles.h"

#include <algorithm>
#include <cmath>

namespace gnomon::hybrid {

std::shared_ptr<const Generator> depths_in_triangles(const char* name, bool over_texels) {
    const auto base = triangles(
        name, {.stride = 3,
               .points = {9},
               .extents = over_texels ? std::vector<std::size_t>{11, 12} : std::vector<std::size_t>{},
               .depths = {2, 5, 8}});
    const auto move_point = [over_texels](Random& random, std::span<double> n, glm::dvec3 weights) {
        n[9] = weights.x * n[0] + weights.y * n[3] + weights.z * n[6];
        n[10] = weights.x * n[1] + weights.y * n[4] + weights.z * n[7];
        const double share = std::exp2(-16 * random.unit());
        for (std::size_t i = 11; over_texels && i < 13; ++i) n[i] *= share;
    };
    auto generator = std::make_shared<Generator>(*base);
    generator->draw = [=](Random& random, std::span<double> n) {
        base->draw(random, n);
        const double level = random.chance(0.5) ? 0 : 2 * random.unit() - 1;
        const double spread = std::exp2(-12 * random.unit());
        for (const std::size_t i : {2u, 5u, 8u}) n[i] = level + spread * (2 * n[i] - 1);
        if (random.chance(0.5)) return;
        const std::size_t corner = random.below(3);
        if (random.chance(0.5)) n[3 * corner + 2] *= std::exp2(-20 * random.unit());
        const double near = random.chance(0.25) ? 0 : std::exp2(-20 * random.unit()), u = random.unit();
        glm::dvec3 weights(near * u, near * (1 - u), near * u);
        weights[static_cast<int>(corner)] = 0;
        weights[static_cast<int>(corner)] = 1 - weights.x - weights.y - weights.z;
        move_point(random, n, weights);
    };
    for (std::size_t turn = 0; turn < 3; ++turn)
        generator->loci.push_back(
            {"points in a needle", "slivers", [=](Random& random, double distance, std::span<double> n) {
                 // The corners' places turned, so that each edge is the longest somewhere.
                 const std::size_t a = 3 * turn, b = 3 * ((turn + 1) % 3), c = 3 * ((turn + 2) % 3);
                 const double x = n[b] - n[a], y = n[b + 1] - n[a + 1];
                 const double t = random.chance(0.5) ? random.unit() : 1 - 2 * distance * random.unit();
                 const double side = random.chance(0.5) ? -distance : distance;
                 n[c] = std::clamp(n[a] + t * x - side * y, -farthest, farthest);
                 n[c + 1] = std::clamp(n[a + 1] + t * y + side * x, -farthest, farthest);
                 // Some rise along the needle alone.
                 if (random.chance(0.5)) n[c + 2] = n[a + 2] + t * (n[b + 2] - n[a + 2]);
                 const double u = random.unit(), v = random.unit();
                 move_point(random, n, {(1 - u) * (1 - v), u * (1 - v), v});
                 for (std::size_t i = 11; over_texels && i < 13; ++i)
                     if (random.chance(0.5)) n[i] *= distance;
             }});
    return generator;
}

std::shared_ptr<const Generator> pairs_of_lines() {
    auto generator = std::make_shared<Generator>(*triangles("conservative/lines", {.points = {6, 8}}));
    generator->loci.push_back(
        {"parallel lines", "slivers", [](Random& random, double distance, std::span<double> n) {
             const double x = n[2] - n[0], y = n[3] - n[1], t = 2 * random.unit() - 1;
             const double side = random.chance(0.5) ? distance : -distance;
             n[6] = std::clamp(n[4] + t * x - side * y, -farthest, farthest);
             n[7] = std::clamp(n[5] + t * y + side * x, -farthest, farthest);
         }});
    return generator;
}

std::shared_ptr<const Generator> normals_and_texels() {
    auto generator = std::make_shared<Generator>();
    generator->name = "conservative/texels";
    generator->draw = [](Random& random, std::span<double> n) {
        const double angle = 6.283185307179586 * random.unit();
        n[0] = std::cos(angle), n[1] = std::sin(angle);
        n[2] = std::exp2(1 - 20 * random.unit()), n[3] = std::exp2(1 - 20 * random.unit());
    };
    return generator;
}

std::shared_ptr<const Generator> points_and_boxes() {
    auto generator = std::make_shared<Generator>();
    generator->name = "conservative/grid";
    generator->draw = [](Random& random, std::span<double> numbers) {
        for (double& number : numbers) number = random.between(-8, 8) / 4.0;
    };
    return generator;
}

} // namespace gnomon::hybrid
