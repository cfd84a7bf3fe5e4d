// The assembled kernels are nothing but their parts: on every texel of every mask, what visibility and number
// give is bit for bit what the standalone kernels give when each runs on the results of the one before.
#include "casegen/composition.h"
#include "tests/support/device.h"
#include "tests/support/masks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace gnomon {
namespace {

using testing::run_kernel;

std::vector<TexelPoint> every_texel(const std::vector<NamedMask>& masks, int beyond) {
    // Points on a border of light and shadow and beside one; the last column of a texel and its first.
    constexpr float points[][2] = {{0.5f, 0.5f},   {0.1f, 0.7f},  {0.75f, 0.25f},  {0.0f, 1.0f},
                                   {0.99f, 0.33f}, {0.3f, 0.01f}, {0.625f, 0.875f}};
    std::vector<TexelPoint> texels;
    Random random(61);
    for (const NamedMask& named : masks)
        for (int y = -beyond; y < named.mask.height + beyond; ++y)
            for (int x = -beyond; x < named.mask.width + beyond; ++x) {
                const auto& point = points[random.below(std::size(points))];
                texels.push_back({&named.mask, {x, y}, {point[0], point[1]}});
            }
    return texels;
}

std::vector<std::uint32_t> run_by_name(const Case& c, const Records& records) {
    return run_kernel(c.name, records);
}

class composition : public ::testing::TestWithParam<std::string> {
protected:
    void compare(const std::vector<TexelPoint>& points) {
        const Family& family = technique_family(GetParam());
        const Composition::Composed composed = Composition(points, run_by_name).compose(family);
        const std::vector<std::uint32_t> visibility = run_assembled(*find_kernel(family, "visibility"),
                                                                    points, run_by_name),
                                         number = run_assembled(*find_kernel(family, "number"), points,
                                                                run_by_name);
        std::map<std::uint32_t, std::size_t> met;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const TexelPoint& at = points[i];
            ASSERT_EQ(number[i], composed.numbers[i]) << at.texel.x << "," << at.texel.y << " of\n"
                                                      << format_mask(*at.mask, '\n');
            ASSERT_EQ(visibility[i], composed.visibility[i])
                << at.texel.x << "," << at.texel.y << " at " << at.p.x << "," << at.p.y << ", case "
                << number[i] << ", of\n"
                << format_mask(*at.mask, '\n');
            ++met[number[i]];
        }
        EXPECT_GT(met[0], 0u);
        for (const Case* c : numbered_cases(family))
            EXPECT_GT(met[c->number], 0u) << "case " << c->number << " was never met";
    }
};

TEST_P(composition, equals_the_assembly_on_every_texel_of_every_family) {
    const std::vector<NamedMask> masks = mask_corpus(62, 6, 32);
    compare(every_texel(masks, 2));
}

TEST_P(composition, equals_the_assembly_on_small_masks) {
    std::vector<NamedMask> masks;
    for (const Outside outside : {Outside::lit, Outside::shadow, Outside::clamp})
        for (std::uint32_t pattern = 0; pattern < 512; ++pattern)
            masks.push_back({"3x3", testing::mask_of_bits(pattern, 3, outside)});
    compare(every_texel(masks, 0));
}

INSTANTIATE_TEST_SUITE_P(of, composition, ::testing::ValuesIn(numbered_techniques()),
                         [](const auto& instance) {
                             std::string name = instance.param;
                             std::ranges::replace(name, '-', '_');
                             return name;
                         });

// The whole table of the decision list, realisable or not.
TEST(decision_kernel, agrees_with_the_conditions_on_every_input) {
    const Case& c = find_case("smsr/decision");
    Records records(c);
    for (std::uint32_t n = 0; n < 16 * 9 * 4; ++n) {
        const auto type = [](std::uint32_t value) { return value - 1; }; // -1, 0, 1 as words
        const std::vector<std::uint32_t> words{n % 4,       n / 4 % 4,  type(n / 16 % 3), type(n / 48 % 3),
                                               n / 144 % 2, n / 288 % 2};
        records.add(words, nullptr);
    }
    const std::vector<std::uint32_t> numbers = run_kernel(c.name, records);
    std::map<std::uint32_t, int> met;
    for (std::size_t i = 0; i < records.size(); ++i) {
        const Arguments with = arguments(c, records.input(i), nullptr);
        if (!in_domain(c, with)) continue;
        EXPECT_EQ(numbers[i], static_cast<std::uint32_t>(c.reference.call(with)[0])) << "input " << i;
        ++met[numbers[i]];
    }
    EXPECT_EQ(met.size(), 13u);
}

} // namespace
} // namespace gnomon
