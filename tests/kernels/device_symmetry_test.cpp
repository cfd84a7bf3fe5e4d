// Transposition and mirror images on the device: the same bits, for points at which nothing is rounded.
#include "casegen/catalogue.h"
#include "tests/support/device.h"
#include "tests/support/masks.h"
#include "tests/support/symmetry.h"

#include <gtest/gtest.h>

#include <bit>
#include <deque>

namespace gnomon {
namespace {

using testing::Symmetry;

class device_symmetry : public ::testing::TestWithParam<Symmetry> {};

void add(Records& records, const Mask& mask, glm::ivec2 texel, const glm::dvec2* p) {
    std::vector<std::uint32_t> words{std::bit_cast<std::uint32_t>(texel.x),
                                     std::bit_cast<std::uint32_t>(texel.y)};
    if (p)
        for (const double component : {p->x, p->y})
            words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(component)));
    records.add(words, &mask);
}

TEST_P(device_symmetry, has_no_exception) {
    const Symmetry& turn = GetParam();
    const std::vector<NamedMask> masks = mask_corpus(71, 4, 32);
    std::deque<Mask> images; // records point at them
    const Case &visibility = find_case("smsr/visibility"), &number = find_case("smsr/number");
    Records values(visibility), turned_values(visibility), numbers(number), turned_numbers(number);
    std::vector<glm::uvec2> sides;
    Random random(72);
    for (const NamedMask& named : masks) {
        images.push_back(turn.of_mask(named.mask));
        for (int y = 0; y < named.mask.height; ++y)
            for (int x = 0; x < named.mask.width; ++x) {
                // Multiples of 1/64 within the texel: 1 - p is exact, and so is all that follows.
                const glm::dvec2 p{random.between(1, 63) / 64.0, random.between(1, 63) / 64.0};
                const glm::dvec2 turned = turn.of_point(p);
                const glm::ivec2 image = turn.of_texel(named.mask, {x, y});
                add(values, named.mask, {x, y}, &p);
                add(turned_values, images.back(), image, &turned);
                add(numbers, named.mask, {x, y}, nullptr);
                add(turned_numbers, images.back(), image, nullptr);
                sides.push_back(reference::discontinuity(named.mask, {x, y}));
            }
    }
    EXPECT_EQ(testing::run_kernel("smsr/visibility", values),
              testing::run_kernel("smsr/visibility", turned_values));
    const std::vector<std::uint32_t> here = testing::run_kernel("smsr/number", numbers);
    const std::vector<std::uint32_t> there = testing::run_kernel("smsr/number", turned_numbers);
    ASSERT_EQ(here.size(), sides.size());
    std::array<int, 13> met{};
    for (std::size_t i = 0; i < here.size(); ++i) {
        ASSERT_EQ(there[i], turn.of_number(here[i], sides[i]));
        ++met.at(here[i]);
    }
    for (std::size_t n = 0; n < met.size(); ++n) EXPECT_GT(met[n], 0) << "case " << n << " was never met";
}

INSTANTIATE_TEST_SUITE_P(of_the_square, device_symmetry, ::testing::ValuesIn(testing::symmetries),
                         [](const auto& instance) { return std::string(instance.param.name); });

} // namespace
} // namespace gnomon
