// Intervals of azimuth, phases and a frequency: phi0, phi1, p, q, s, t.
#include "casegen/stiffness/draw.h"

#include <fmt/format.h>

namespace gnomon::stiffness {
namespace {

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

} // namespace

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

} // namespace gnomon::stiffness
