#include "runtime/pipeline/judge.h"

namespace gnomon {
namespace {

bool is_lit(float visibility) { return visibility >= 0.5f; } // NaN is not

} // namespace

PixelCounts count_pixels(const Surfaces& surfaces, std::span<const float> visibility,
                         std::span<const float> truth) {
    PixelCounts counts;
    counts.all = surfaces.covered.size();
    for (std::size_t i = 0; i < counts.all; ++i) {
        if (surfaces.covered[i] == 0) continue;
        ++counts.covered;
        if (surfaces.facing[i] == 0) {
            ++counts.facing_away;
            continue;
        }
        ++counts.facing;
        const bool lit = is_lit(visibility[i]), truly = is_lit(truth[i]);
        ++(truly ? counts.truly_lit : counts.truly_shadowed);
        if (lit && !truly) ++counts.wrong_lit;
        if (!lit && truly) ++counts.wrong_shadowed;
    }
    return counts;
}

std::size_t count_differing(std::span<const float> visibility, std::span<const float> truth) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) count += visibility[i] == truth[i] ? 0 : 1;
    return count;
}

Image false_colours(const Surfaces& surfaces, std::span<const float> visibility, std::span<const float> truth,
                    int width, int height) {
    constexpr Rgb background{255, 255, 255}, away{92, 104, 120}, lit{208, 208, 208}, shadow{72, 72, 72};
    constexpr Rgb wrong_lit{230, 30, 30}, wrong_shadowed{30, 90, 240};
    Image image(width, height, background);
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        if (surfaces.covered[i] == 0) continue;
        const bool found = is_lit(visibility[i]), truly = is_lit(truth[i]);
        image.pixels[i] = surfaces.facing[i] == 0 ? away
                          : found == truly        ? (truly ? lit : shadow)
                          : found                 ? wrong_lit
                                                  : wrong_shadowed;
    }
    return image;
}

} // namespace gnomon
