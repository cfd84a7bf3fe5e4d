// Lobes on an interval: versines or ends (2), lambda, mu.
#include "casegen/stiffness/draw.h"

#include <fmt/format.h>

namespace gnomon::stiffness {
namespace {

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

} // namespace

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

} // namespace gnomon::stiffness
