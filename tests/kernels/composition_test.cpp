// The assembled kernel is nothing but its parts: on every texel of every mask, what smsr/visibility and
// smsr/number give is bit for bit what the standalone kernels give when each runs on the results of the one
// before.
#include "casegen/catalogue.h"
#include "tests/support/device.h"
#include "tests/support/masks.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <bit>
#include <map>

namespace gnomon {
namespace {

using Words = std::vector<std::uint32_t>;
using testing::run_kernel;

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

/// Texels of masks, each with a point in it; everything that the device said about them so far.
struct Texels {
    struct Place {
        const Mask* mask;
        std::uint32_t x, y; ///< as a kernel takes them
        float px, py;
    };
    std::vector<Place> places;
    std::map<std::string, Words> facts; ///< by parameter name: that many components per place

    /// `name`'s results, on the components that each parameter already has here.
    Words run(const std::string& name, const std::map<std::string, std::string>& renamed = {}) const {
        const Case& c = find_case(name);
        Records records(c);
        for (std::size_t i = 0; i < places.size(); ++i) {
            Words words;
            for (std::size_t p = 0; p < c.parameters.size(); ++p) {
                const auto found = renamed.find(c.parameters[p].name);
                const Words& from = facts.at(found == renamed.end() ? c.parameters[p].name : found->second);
                const auto components = static_cast<std::size_t>(c.reference.parameters[p].components);
                for (std::size_t k = 0; k < components; ++k) words.push_back(from.at(i * components + k));
            }
            records.add(words, places[i].mask);
        }
        return run_kernel(name, records);
    }
};

/// Every `stride`-th component from `first` on, `count` at a time.
Words components(const Words& words, std::size_t stride, std::size_t first, std::size_t count) {
    Words chosen;
    for (std::size_t i = first; i < words.size(); i += stride)
        chosen.insert(chosen.end(), words.begin() + static_cast<std::ptrdiff_t>(i),
                      words.begin() + static_cast<std::ptrdiff_t>(i + count));
    return chosen;
}

Words together(const Words& first, const Words& second) {
    Words both;
    for (std::size_t i = 0; i < first.size(); ++i) both.insert(both.end(), {first[i], second[i]});
    return both;
}

Texels every_texel(const std::vector<NamedMask>& masks, int beyond) {
    // Points on a border of light and shadow and beside one; the last column of a texel and its first.
    constexpr float points[][2] = {{0.5f, 0.5f},   {0.1f, 0.7f},  {0.75f, 0.25f},  {0.0f, 1.0f},
                                   {0.99f, 0.33f}, {0.3f, 0.01f}, {0.625f, 0.875f}};
    Texels texels;
    Random random(61);
    for (const NamedMask& named : masks)
        for (int y = -beyond; y < named.mask.height + beyond; ++y)
            for (int x = -beyond; x < named.mask.width + beyond; ++x) {
                const auto& point = points[random.below(std::size(points))];
                texels.places.push_back({&named.mask, std::bit_cast<std::uint32_t>(x),
                                         std::bit_cast<std::uint32_t>(y), point[0], point[1]});
            }
    for (const Texels::Place& place : texels.places) {
        texels.facts["texel"].insert(texels.facts["texel"].end(), {place.x, place.y});
        texels.facts["p"].insert(texels.facts["p"].end(), {bits(place.px), bits(place.py)});
    }
    return texels;
}

/// Runs the parts in the order in which each needs the one before.
void gather_facts(Texels& texels) {
    texels.facts["sides"] = texels.run("revectorize/discontinuity");
    texels.facts["side_x"] = components(texels.facts["sides"], 2, 0, 1);
    texels.facts["side_y"] = components(texels.facts["sides"], 2, 1, 1);
    texels.facts["reach"] = texels.run("revectorize/traversal");
    texels.facts["reach_x"] = components(texels.facts["reach"], 4, 0, 2);
    texels.facts["reach_y"] = components(texels.facts["reach"], 4, 2, 2);
    texels.facts["p_x"] = components(texels.facts["p"], 2, 0, 1);
    texels.facts["p_y"] = components(texels.facts["p"], 2, 1, 1);
    texels.facts["type"] = together(texels.run("revectorize/edge_type", {{"reach", "reach_x"}}),
                                    texels.run("revectorize/edge_type", {{"reach", "reach_y"}}));
    texels.facts["along_x"] = texels.run("revectorize/along", {{"reach", "reach_x"}, {"c", "p_x"}});
    texels.facts["along_y"] = texels.run("revectorize/along", {{"reach", "reach_y"}, {"c", "p_y"}});
    texels.facts["dominant"] = texels.run("revectorize/dominance");
    texels.facts["number"] = texels.run("smsr/decision");
}

class composition : public ::testing::Test {
protected:
    void compare(Texels texels) {
        gather_facts(texels);
        std::vector<Words> cases(13);
        for (unsigned number = 1; number <= 12; ++number)
            cases[number] = texels.run(fmt::format("smsr/case_{:02}", number));
        const Words visibility = texels.run("smsr/visibility"), number = texels.run("smsr/number");

        std::map<std::uint32_t, std::size_t> met;
        for (std::size_t i = 0; i < texels.places.size(); ++i) {
            const Texels::Place& place = texels.places[i];
            const int x = std::bit_cast<int>(place.x), y = std::bit_cast<int>(place.y);
            const bool lit = place.mask->lit(x, y);
            const std::uint32_t decided = lit ? texels.facts["number"][i] : 0;
            ASSERT_LE(decided, 12u);
            const std::uint32_t composed = !lit ? bits(0.0f) : decided == 0 ? bits(1.0f) : cases[decided][i];
            ASSERT_EQ(number[i], decided) << x << "," << y << " of\n" << format_mask(*place.mask, '\n');
            ASSERT_EQ(visibility[i], composed)
                << x << "," << y << " at " << place.px << "," << place.py << ", case " << decided << ", of\n"
                << format_mask(*place.mask, '\n');
            ++met[lit ? decided : 99];
        }
        for (unsigned n = 0; n <= 12; ++n) EXPECT_GT(met[n], 0u) << "case " << n << " was never met";
    }
};

TEST_F(composition, equals_the_assembly_on_every_texel_of_every_family) {
    const std::vector<NamedMask> masks = mask_corpus(62, 6, 32);
    compare(every_texel(masks, 2));
}

TEST_F(composition, equals_the_assembly_on_small_masks) {
    std::vector<NamedMask> masks;
    for (const Outside outside : {Outside::lit, Outside::shadow, Outside::clamp})
        for (std::uint32_t pattern = 0; pattern < 512; ++pattern)
            masks.push_back({"3x3", testing::mask_of_bits(pattern, 3, outside)});
    compare(every_texel(masks, 0));
}

// The whole table of the decision list, realisable or not.
TEST(decision_kernel, agrees_with_the_conditions_on_every_input) {
    const Case& c = find_case("smsr/decision");
    Records records(c);
    for (std::uint32_t n = 0; n < 16 * 9 * 4; ++n) {
        const auto type = [](std::uint32_t value) { return value - 1; }; // -1, 0, 1 as words
        const Words words{n % 4, n / 4 % 4, type(n / 16 % 3), type(n / 48 % 3), n / 144 % 2, n / 288 % 2};
        records.add(words, nullptr);
    }
    const Words numbers = run_kernel(c.name, records);
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
