// What an atlas is made of and needs no device: witnesses as pictures, inputs, judged values, shares.
#include "casegen/atlas/frequency.h"
#include "casegen/atlas/picture.h"
#include "casegen/atlas/values.h"
#include "casegen/mask_families.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::atlas {
namespace {

namespace fs = std::filesystem;
using gnomon::testing::error_of;
using gnomon::testing::TemporaryFolder;
using testing::count_of;
using ::testing::HasSubstr;

std::vector<const Case*> numbered_cases() {
    std::vector<const Case*> numbered;
    for (const Case* c : find_cases(""))
        if (c->number != 0) numbered.push_back(c);
    return numbered;
}

TEST(witness_picture, has_texels_ring_and_arrows) {
    Witness witness{parse_mask(".#/..", '/', "m"), {0, 0}};
    witness.mask.outside = Outside::lit;
    const std::string svg = witness_svg(witness, "a <b>");
    EXPECT_THAT(svg, HasSubstr("width=\"160\" height=\"160\""));
    EXPECT_THAT(svg, HasSubstr("<title>a &lt;b&gt;</title>"));
    EXPECT_EQ(count_of(svg, "class=\"lit\"") + count_of(svg, "class=\"dark\""), 16u);
    EXPECT_EQ(count_of(svg, "class=\"dark\""), 1u);
    EXPECT_EQ(count_of(svg, "class=\"beyond\""), 12u);
    EXPECT_EQ(count_of(svg, "class=\"tested\""), 1u);
    EXPECT_EQ(count_of(svg, "class=\"head\""), 1u);
    EXPECT_THAT(svg, HasSubstr("<path class=\"shaft\" d=\"M64.8 60 L84.8 60\"/>")); // towards +x
}

TEST(witness_picture, an_arrow_for_every_side_that_differs) {
    for (const Case* c : numbered_cases()) {
        const std::optional<Witness> witness = smallest_witness(*c);
        ASSERT_TRUE(witness) << c->name;
        const glm::uvec2 sides = reference::edge(witness->mask, witness->texel).sides;
        EXPECT_EQ(count_of(witness_svg(*witness, ""), "class=\"head\""),
                  static_cast<std::size_t>(std::popcount(sides.x) + std::popcount(sides.y)))
            << c->name;
    }
}

TEST(words_of_a_call, are_facts_or_the_domain_s_first) {
    const Case& c = find_case("smsr/case_04"); // p, along_y, side_x
    Facts facts;
    facts.p = {0.25, 0.5};
    facts.edge.sides = {reference::plus, 0};
    facts.edge.reach = {1, -1, 2, -2}; // one end: a position along the run exists
    const auto bits = [](float v) { return std::bit_cast<std::uint32_t>(v); };
    std::vector<std::uint32_t> words = words_of(c, facts);
    ASSERT_EQ(words.size(), 4u);
    EXPECT_EQ(words[0], bits(0.25f));
    EXPECT_EQ(words[1], bits(0.5f));
    EXPECT_EQ(words[2], bits(static_cast<float>(reference::along({2, -2}, 0.5))));
    EXPECT_EQ(words[3], reference::plus);

    Case unknown = c;
    unknown.parameters[1].name = "options";
    unknown.parameters[1].domain = {0.75, 1, {}};
    unknown.parameters[2].name = "mode";
    unknown.parameters[2].domain.choices = {{7}, {9}};
    words = words_of(unknown, facts);
    EXPECT_EQ(words[2], bits(0.75f));
    EXPECT_EQ(words[3], 7u);
    EXPECT_THAT(untold(c, facts), ::testing::IsEmpty());
    EXPECT_THAT(untold(unknown, facts), ::testing::ElementsAre("options = 0.75", "mode = 7"));
}

TEST(words_of_a_call, look_beyond_the_texel) {
    const Case& c = find_case("rsmss/case_04"); // p, neighbours, options
    const Witness slot{parse_mask(".#/.#/..", '/', "m"), {0, 1}};
    Witness dark = slot;
    dark.mask.outside = Outside::shadow;
    const std::vector<std::uint32_t> words = words_of(c, facts_of(dark));
    const glm::uvec2 neighbours =
        reference::neighbours(dark.mask, dark.texel, reference::discontinuity(dark.mask, dark.texel));
    EXPECT_NE(neighbours, glm::uvec2(0));
    EXPECT_EQ(words.at(2), neighbours.x);
    EXPECT_EQ(words.at(3), neighbours.y);
    EXPECT_THAT(untold(c, facts_of(dark)), ::testing::ElementsAre("options = 0"));
}

TEST(value_map, references_are_defined_over_every_witness) {
    for (const Case* c : numbered_cases()) {
        const ValueMap map = make_value_map(*c, value_records(*c, *smallest_witness(*c), 16), 16, nullptr);
        ASSERT_EQ(map.want.size(), 256u) << c->name;
        EXPECT_TRUE(std::ranges::none_of(map.want, [](double v) { return std::isnan(v); })) << c->name;
        EXPECT_TRUE(map.got.empty());
    }
}

/// The reference's own values as a device would return them, but for some.
Outputs outputs_of(const ValueMap& map) {
    Outputs outputs;
    for (const double value : map.want)
        outputs.words.push_back(std::bit_cast<std::uint32_t>(static_cast<float>(value)));
    outputs.unwritten.assign(map.want.size(), 0);
    return outputs;
}

TEST(value_map, judges_every_point) {
    const Case& c = find_case("smsr/case_09");
    const Records records = value_records(c, *smallest_witness(c), 8);
    Outputs outputs = outputs_of(make_value_map(c, records, 8, nullptr));
    ValueMap map = make_value_map(c, records, 8, &outputs);
    EXPECT_EQ(map.differ, 0u);
    EXPECT_EQ(map.largest_difference, 0);
    EXPECT_EQ(map.agreement[0], Agreement::equal);
    const Image equal = difference_image(c, map);
    EXPECT_EQ(std::ranges::count(equal.pixels, equal.pixels.front()), 64);

    outputs.words[3] ^= std::bit_cast<std::uint32_t>(1.0f); // 0 for 1, 1 for 0
    outputs.unwritten[5] = 1;
    map = make_value_map(c, records, 8, &outputs);
    EXPECT_EQ(map.differ, 2u);
    EXPECT_EQ(map.refused, 2u);
    EXPECT_EQ(map.agreement[3], Agreement::refused);
    EXPECT_TRUE(std::isnan(map.got[5]));
    EXPECT_TRUE(std::isinf(map.largest_difference));
    EXPECT_NE(difference_image(c, map).pixels[3], equal.pixels[3]);
    EXPECT_NE(values_image(c, map, map.got).pixels[5], values_image(c, map, map.want).pixels[5]);
}

TEST(value_map, what_the_tolerance_allows_is_seen_but_not_refused) {
    Case c = find_case("smsr/case_01");
    c.tolerance = absolute(0.1);
    const Records records = value_records(c, *smallest_witness(c), 2);
    Outputs outputs = outputs_of(make_value_map(c, records, 2, nullptr));
    outputs.words[1] = std::bit_cast<std::uint32_t>(0.95f);
    const ValueMap map = make_value_map(c, records, 2, &outputs);
    EXPECT_EQ(map.agreement[1], Agreement::allowed);
    EXPECT_EQ(map.differ, 1u);
    EXPECT_EQ(map.refused, 0u);
    EXPECT_NEAR(map.largest_difference, 0.05, 1e-7);
    EXPECT_EQ(difference_scale(c), 0.1);
}

TEST(corpus_share, counts_edge_texels) {
    EdgePool pool;
    for (std::size_t i = 0; i < 2 * mask_families().size(); ++i) pool.masks.emplace_back(4, 4);
    const auto add = [&](std::uint16_t mask, bool lit) {
        EdgePool::Entry entry{};
        entry.mask = mask;
        entry.lit = lit;
        pool.entries.push_back(entry);
    };
    for (int i = 0; i < 3; ++i) add(0, true);
    add(0, false);
    add(2, false); // the second family's first mask; all others have no edge
    Case c = find_case("smsr/case_01");
    c.condition = {{.light = sets::lit}};
    const CorpusShare share = corpus_share(c, pool);
    EXPECT_DOUBLE_EQ(share.overall, 0.6);
    EXPECT_DOUBLE_EQ(share.mean, 0.375);
    EXPECT_DOUBLE_EQ(share.deviation, 0.375 * std::sqrt(2.0)) /* of two masks, the sample's */;
    ASSERT_EQ(share.by_family.size(), mask_families().size());
    EXPECT_DOUBLE_EQ(share.by_family[0], 0.75);
    EXPECT_DOUBLE_EQ(share.by_family[1], 0);
}

TEST(corpus_share, of_smsr_s_cases_adds_up_to_the_lit_texels) {
    const EdgePool pool = make_edge_pool(default_seed("masks"));
    double sum = 0;
    for (const Case* c : find_cases("smsr/case_*")) sum += corpus_share(*c, pool).overall;
    const auto lit = std::ranges::count_if(pool.entries, [](const EdgePool::Entry& e) { return e.lit; });
    EXPECT_NEAR(sum, static_cast<double>(lit) / static_cast<double>(pool.entries.size()), 1e-12);
}

TEST(census, is_read_and_bad_ones_are_named) {
    const TemporaryFolder folder;
    const Census census = read_census(folder.write("lattice.json", R"({"smsr": {"9": 0.25, "12": 0}})"));
    EXPECT_EQ(census.where, "lattice");
    EXPECT_EQ(census.shares.at("smsr").at(9), 0.25);
    const Census whole =
        read_census(folder.write("demo.json", R"({"technique": "smsr", "shares": {"smsr": {"9": 0.5}}})"));
    EXPECT_EQ(whole.shares.at("smsr").at(9), 0.5);
    const auto refused = [&](const char* text) {
        const fs::path path = folder.write("bad.json", text);
        const std::string message = error_of([&] { read_census(path); });
        EXPECT_THAT(message, HasSubstr("bad.json")) << text;
        return message;
    };
    refused("");
    refused("[1]");
    refused("{\"smsr\": 1}");
    EXPECT_THAT(refused(R"({"two\nlines": {"1": 0.5}})"), HasSubstr("two lines"));
    EXPECT_THAT(refused(R"({"smsr": {"9\n": 0.5}})"), HasSubstr("no case \"9\""));
    EXPECT_THAT(refused("{\"smrs\": {}}"), HasSubstr("smrs"));
    EXPECT_THAT(refused("{\"smsr\": {\"13\": 0.1}}"), HasSubstr("\"13\""));
    EXPECT_THAT(refused("{\"smsr\": {\"0\": 0.1}}"), HasSubstr("\"0\""));
    EXPECT_THAT(refused("{\"smsr\": {\"9x\": 0.1}}"), HasSubstr("9x"));
    EXPECT_THAT(refused("{\"smsr\": {\"9\": 1.5}}"), HasSubstr("0 to 1"));
    EXPECT_THAT(refused("{\"smsr\": {\"9\": \"much\"}}"), HasSubstr("0 to 1"));
    EXPECT_THAT(error_of([&] { read_census(folder.path() / "none.json"); }), HasSubstr("none.json"));
}

} // namespace
} // namespace gnomon::atlas
