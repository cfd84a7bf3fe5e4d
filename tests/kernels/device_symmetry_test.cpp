// Transposition and mirror images on the device: the same bits, for points at which nothing is rounded.
#include "casegen/catalogue.h"
#include "casegen/symmetry.h"
#include "tests/support/device.h"
#include "tests/support/masks.h"

#include <gtest/gtest.h>

#include <bit>
#include <deque>

namespace gnomon {
namespace {

class device_symmetry : public ::testing::TestWithParam<Symmetry> {};

void add(Records& records, const Mask& mask, glm::ivec2 texel, const glm::dvec2* p) {
    std::vector<std::uint32_t> words{std::bit_cast<std::uint32_t>(texel.x),
                                     std::bit_cast<std::uint32_t>(texel.y)};
    if (p)
        for (const double component : {p->x, p->y})
            words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(component)));
    records.add(words, &mask);
}

/// Every texel of masks of all families at one point each, and its image.
struct Pairs {
    Records values, turned_values, numbers, turned_numbers;
    std::vector<glm::uvec2> sides{};
};

Pairs pairs_of(const Family& family, const Symmetry& turn, const std::vector<NamedMask>& masks,
               std::deque<Mask>& images) {
    const Case &visibility = *find_kernel(family, "visibility"), &number = *find_kernel(family, "number");
    Pairs pairs{Records(visibility), Records(visibility), Records(number), Records(number)};
    Random random(72);
    for (const NamedMask& named : masks) {
        images.push_back(turn.of_mask(named.mask));
        for (int y = 0; y < named.mask.height; ++y)
            for (int x = 0; x < named.mask.width; ++x) {
                // Multiples of 1/64 within the texel: 1 - p is exact, and so is most that follows.
                const glm::dvec2 p{random.between(1, 63) / 64.0, random.between(1, 63) / 64.0};
                const glm::dvec2 turned = turn.of_point(p);
                const glm::ivec2 image = turn.of_texel(named.mask, {x, y});
                add(pairs.values, named.mask, {x, y}, &p);
                add(pairs.turned_values, images.back(), image, &turned);
                add(pairs.numbers, named.mask, {x, y}, nullptr);
                add(pairs.turned_numbers, images.back(), image, nullptr);
                pairs.sides.push_back(reference::discontinuity(named.mask, {x, y}));
            }
    }
    return pairs;
}

TEST_P(device_symmetry, of_smsr_has_no_exception) {
    const Symmetry& turn = GetParam();
    const std::vector<NamedMask> masks = mask_corpus(71, 4, 32);
    std::deque<Mask> images; // records point at them
    const Pairs pairs = pairs_of(technique_family("smsr"), turn, masks, images);
    EXPECT_EQ(testing::run_kernel("smsr/visibility", pairs.values),
              testing::run_kernel("smsr/visibility", pairs.turned_values));
    const std::vector<std::uint32_t> here = testing::run_kernel("smsr/number", pairs.numbers);
    const std::vector<std::uint32_t> there = testing::run_kernel("smsr/number", pairs.turned_numbers);
    ASSERT_EQ(here.size(), pairs.sides.size());
    std::array<int, 13> met{};
    for (std::size_t i = 0; i < here.size(); ++i) {
        ASSERT_EQ(there[i], turn.of_number(here[i], pairs.sides[i]));
        ++met.at(here[i]);
    }
    for (std::size_t n = 0; n < met.size(); ++n) EXPECT_GT(met[n], 0) << "case " << n << " was never met";
}

TEST_P(device_symmetry, of_filters_and_shapes_is_exact_but_for_roundings) {
    const std::vector<NamedMask> masks = mask_corpus(73, 4, 32);
    for (const std::string technique : {"rsmss", "rbsm-silhouette", "rbsm-filter"}) {
        std::deque<Mask> images;
        const Family& family = technique_family(technique);
        const Pairs pairs = pairs_of(family, GetParam(), masks, images);
        const std::string kernel = find_kernel(family, "visibility")->name;
        const std::vector<std::uint32_t> here = testing::run_kernel(kernel, pairs.values);
        const std::vector<std::uint32_t> there = testing::run_kernel(kernel, pairs.turned_values);
        ASSERT_EQ(here.size(), there.size());
        std::size_t grey = 0;
        for (std::size_t i = 0; i < here.size(); ++i) {
            const float a = std::bit_cast<float>(here[i]), b = std::bit_cast<float>(there[i]);
            ASSERT_NEAR(a, b, 0x1p-22) << technique; // half an ulp of 2, twice
            grey += a > 0 && a < 1 ? 1 : 0;
        }
        if (technique != "rbsm-silhouette") EXPECT_GT(grey, 2000u) << technique;
    }
}

INSTANTIATE_TEST_SUITE_P(of_the_square, device_symmetry, ::testing::ValuesIn(symmetries),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace
} // namespace gnomon
