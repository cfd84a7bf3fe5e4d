#include "casegen/mask_families.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace gnomon {
namespace {

/// Texels whose centre the predicate accepts become shadow. Centres are at (x + 0.5, y + 0.5).
Mask shadow_where(int size, const std::function<bool(double, double)>& inside) {
    Mask mask(size, size);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            if (inside(x + 0.5, y + 0.5)) mask.set(x, y, false);
    return mask;
}

void fill(Mask& mask, int x0, int y0, int x1, int y1, bool lit) {
    for (int y = std::max(y0, 0); y < std::min(y1, mask.height); ++y)
        for (int x = std::max(x0, 0); x < std::min(x1, mask.width); ++x) mask.set(x, y, lit);
}

/// One of the eight symmetries of the square, so that no direction is favoured.
Mask oriented(Random& random, Mask mask) {
    if (random.chance(0.5)) mask = transposed(mask);
    if (random.chance(0.5)) mask = mirrored_x(mask);
    if (random.chance(0.5)) mask = mirrored_y(mask);
    return mask;
}

// Every number is drawn in a statement of its own: compilers evaluate a call's arguments in different orders.
// Directions are slopes, not angles: sine and cosine differ in their last bits from one C library to the
// next.
Mask random_half_plane(Random& random, int size) {
    const double slope = random.chance(0.5) ? random.between(0, 16) / 16.0 : random.unit();
    const double offset = (random.unit() - 0.5) * size / 2;
    return oriented(random, shadow_where(size, [&](double x, double y) {
                        return y - size / 2.0 > slope * (x - size / 2.0) + offset;
                    }));
}

Mask circle(Random& random, int size) {
    const double cx = size * (0.3 + 0.4 * random.unit()), cy = size * (0.3 + 0.4 * random.unit());
    const double radius = size * (0.05 + 0.4 * random.unit());
    const bool hole = random.chance(0.3);
    return shadow_where(size, [&](double x, double y) {
        return ((x - cx) * (x - cx) + (y - cy) * (y - cy) < radius * radius) != hole;
    });
}

Mask thin_strip(Random& random, int size) {
    const double slope = random.unit(), width = 0.4 + 2.2 * random.unit(),
                 offset = (random.unit() - 0.5) * size / 2;
    return oriented(random, shadow_where(size, [&](double x, double y) {
                        return std::abs(y - size / 2.0 - slope * (x - size / 2.0) - offset) <
                               0.5 * width * std::sqrt(1 + slope * slope);
                    }));
}

Mask segments(Random& random, int size) {
    Mask mask(size, size);
    for (int i = random.between(1, 5); i > 0; --i) {
        const double x0 = random.unit() * size, y0 = random.unit() * size;
        const double x1 = random.unit() * size, y1 = random.unit() * size;
        const int steps = 4 * size;
        for (int k = 0; k <= steps; ++k) {
            const double t = static_cast<double>(k) / steps;
            const int x = static_cast<int>(x0 + t * (x1 - x0)), y = static_cast<int>(y0 + t * (y1 - y0));
            if (x >= 0 && y >= 0 && x < size && y < size) mask.set(x, y, false);
        }
    }
    return mask;
}

Mask rectangles(Random& random, int size) {
    Mask mask(size, size);
    for (int i = random.between(1, 6); i > 0; --i) {
        const int x = random.between(-2, size), y = random.between(-2, size);
        const int w = random.between(1, size / 2), h = random.between(1, size / 2);
        fill(mask, x, y, x + w, y + h, random.chance(0.3));
    }
    return mask;
}

/// The four shapes of an edge (Optimized RBSM 2017, figure 2): I no end, U both ends, L one, O closed all
/// round.
Mask shapes(Random& random, int size) {
    Mask mask(size, size);
    for (int i = random.between(2, 6); i > 0; --i) {
        const int x = random.between(1, size - 6), y = random.between(1, size - 6);
        const int w = random.between(1, 8), h = random.between(1, 4);
        switch (random.below(4)) {
        case 0:
            fill(mask, 0, y, size, y + h, false);
            break; // I: across the whole map
        case 1:    // U: a notch in a block
            fill(mask, x, y, x + w + 2, y + h + 1, false);
            fill(mask, x + 1, y, x + w + 1, y + h, true);
            break;
        case 2: // L: a step
            fill(mask, x, y, x + w + 2, y + h, false);
            fill(mask, x, y + h, x + 1, y + 2 * h, false);
            break;
        default: // O: a hole in a block
            fill(mask, x, y, x + w + 2, y + h + 2, false);
            fill(mask, x + 1, y + 1, x + w + 1, y + h + 1, true);
        }
    }
    return oriented(random, mask);
}

Mask comb(Random& random, int size) {
    Mask mask(size, size);
    const int period = random.between(2, 6), tooth = random.between(1, period - 1),
              base = random.between(0, 4);
    fill(mask, 0, 0, size, base, false);
    for (int x = random.between(0, period); x < size; x += period)
        fill(mask, x, base, x + tooth, base + random.between(1, size - 6), false);
    return oriented(random, mask);
}

Mask blobs(Random& random, int size) {
    struct Bump {
        double x, y, inverse_radius2;
    };
    std::array<Bump, 5> bumps{};
    for (Bump& bump : bumps) {
        const double radius = size * (0.08 + 0.2 * random.unit());
        bump = {random.unit() * size, random.unit() * size, 1 / (radius * radius)};
    }
    return shadow_where(size, [&](double x, double y) {
        double field = 0; // a sum of 1/(1+r²): smooth, and exact arithmetic on every machine
        for (const Bump& b : bumps)
            field += 1 / (1 + ((x - b.x) * (x - b.x) + (y - b.y) * (y - b.y)) * b.inverse_radius2);
        return field > 0.9;
    });
}

Mask maze(Random& random, int size) {
    Mask mask(size, size, false);
    for (int y = 1; y < size; y += 2)
        for (int x = 1; x < size; x += 2) { // a binary-tree maze: every cell opens one wall
            mask.set(x, y, true);
            if (random.chance(0.5) && x + 1 < size)
                mask.set(x + 1, y, true);
            else if (y + 1 < size)
                mask.set(x, y + 1, true);
        }
    return oriented(random, mask);
}

Mask noise(Random& random, int size) {
    const double density = 0.1 + 0.8 * random.unit();
    Mask mask(size, size);
    for (std::uint8_t& texel : mask.texels) texel = random.chance(density) ? 0 : 1;
    return mask;
}

Mask single_texels(Random& random, int size) {
    const bool lit = random.chance(0.5);
    Mask mask(size, size, !lit);
    for (int i = random.between(1, size); i > 0; --i) {
        const int x = random.between(0, size - 1), y = random.between(0, size - 1);
        mask.set(x, y, lit);
    }
    return mask;
}

} // namespace

const std::vector<MaskFamily>& mask_families() {
    static const std::vector<MaskFamily> families{
        {"half-planes", "straight edges at many slopes, eight orientations", random_half_plane},
        {"circles", "discs and round holes", circle},
        {"thin-strips", "bars 0.4 to 2.6 texels wide", thin_strip},
        {"segments", "lines one texel wide", segments},
        {"rectangles", "overlapping boxes and holes", rectangles},
        {"shapes", "edges of I, U, L and O shape", shapes},
        {"combs", "teeth and slots of equal width", comb},
        {"blobs", "smooth closed curves", blobs},
        {"mazes", "corridors one texel wide", maze},
        {"noise", "every texel at random", noise},
        {"single-texels", "isolated texels", single_texels},
    };
    return families;
}

std::vector<NamedMask> mask_corpus(std::uint64_t seed, int members, int size) {
    std::vector<NamedMask> corpus;
    for (const MaskFamily& family : mask_families())
        for (int i = 0; i < members; ++i) {
            Random random(seed, corpus.size());
            NamedMask named{fmt::format("{}/{}", family.name, i), family.make(random, size)};
            named.mask.outside = static_cast<Outside>(corpus.size() % 3);
            corpus.push_back(std::move(named));
        }
    return corpus;
}

Mask half_plane(int size, double a, double b, double c) {
    return shadow_where(size, [&](double x, double y) { return a * x + b * y < c; });
}

} // namespace gnomon
