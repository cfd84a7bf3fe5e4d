// RSMSS's 31 cases: total, without overlap, all reachable; and two references that differ in kind, against
// each other. docs/revectorization.md 4
#include "casegen/reference/rsmss.h"
#include "casegen/witness.h"
#include "runtime/files.h"
#include "tests/support/case_chain.h"
#include "tests/support/environment.h"
#include "tests/support/masks.h"
#include "tests/support/smsr_chain.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

namespace gnomon {
namespace {

using glm::dvec2;
using glm::ivec2;
using namespace reference;

const testing::CaseChain& chain() {
    static const testing::CaseChain cases("rsmss");
    return cases;
}

const Family& family() {
    for (const Family& f : catalogue())
        if (f.name == "rsmss") return f;
    throw std::logic_error("no rsmss");
}

template <typename Visit>
void for_texels(const Mask& mask, const Visit& visit) {
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x) visit(ivec2(x, y));
}

/// Every edge, of lit and of shadowed texels, that differs in what the decision list reads: of all 4x4 masks
/// in light and in shadow, and of masks of all families.
const std::map<std::uint64_t, Edge>& realisable_edges() {
    static const auto edges = [] {
        std::map<std::uint64_t, Edge> found;
        const auto collect = [&](const Mask& mask) {
            for_texels(mask, [&](ivec2 texel) {
                const Edge e = edge(mask, texel);
                if (e.sides != glm::uvec2(0))
                    found.emplace(testing::decision_key(e) << 1 | (e.lit ? 1u : 0u), e);
            });
        };
        for (const Outside outside : {Outside::lit, Outside::shadow})
            testing::for_all_4x4_masks(outside, collect);
        for (const NamedMask& named : mask_corpus(21, 20, 40)) collect(named.mask);
        return found;
    }();
    return edges;
}

/// docs/revectorization.md 4.1, line by line: the third statement of it besides conditions and kernel.
unsigned number_by_list(const Edge& e) {
    const bool lit = e.lit;
    if (e.sides.x == both && e.sides.y == both) return lit ? 2 : 3;
    if (e.sides.x == both) {
        if (e.type.y == -1) return lit ? 1 : 0;
        if (lit && e.type.y == 1) return e.sides.y == 0 ? 4 : 5;
        if (lit) return e.sides.y == 0 ? 9 : 8;
        return e.sides.y == 0 ? 13 : 12;
    }
    if (e.sides.y == both) {
        if (e.type.x == -1) return lit ? 1 : 0;
        if (lit && e.type.x == 1) return e.sides.x == 0 ? 6 : 7;
        if (lit) return e.sides.x == 0 ? 11 : 10;
        return e.sides.x == 0 ? 15 : 14;
    }
    if (e.sides.x != 0 && e.sides.y != 0) {
        const unsigned which = e.dominant.x && e.dominant.y ? 19 : e.dominant.x ? 16 : e.dominant.y ? 17 : 18;
        return lit ? which : which + 8;
    }
    const int type = e.sides.x == 0 ? e.type.x : e.type.y;
    const unsigned across = e.sides.x == 0 ? 0 : 1;
    if (type == -1) return lit ? 1 : 0;
    return (type == 1 ? 20 : 22) + across + (lit ? 0 : 8);
}

TEST(rsmss_decision, at_most_one_case_applies_and_none_only_to_shadow_beside_an_open_edge) {
    std::map<unsigned, int> edges_of;
    for (const auto& [key, e] : realisable_edges()) {
        int applying = 0;
        unsigned number = 0;
        for (const Case& c : family().cases)
            if (c.number != 0 && holds(c.condition, e)) ++applying, number = c.number;
        EXPECT_LE(applying, 1);
        EXPECT_EQ(number, number_by_list(e))
            << "sides " << e.sides.x << e.sides.y << " types " << e.type.x << e.type.y << " lit " << e.lit;
        if (number == 0) EXPECT_FALSE(e.lit);
        ++edges_of[number];
    }
    for (unsigned number = 0; number <= 31; ++number) EXPECT_GT(edges_of[number], 0) << "case " << number;
}

TEST(rsmss_decision, number_of_realisable_edges) { EXPECT_EQ(realisable_edges().size(), 126u); }

// docs/revectorization.md 1.2
TEST(rsmss_decision, a_dominant_edge_s_run_never_ends_twice_along_the_other_axis) {
    for (const auto& [key, e] : realisable_edges()) {
        if (e.dominant.x && !e.dominant.y) EXPECT_NE(e.type.x, 1);
        if (e.dominant.y && !e.dominant.x) EXPECT_NE(e.type.y, 1);
    }
}

const std::vector<BranchWitness>& witnesses() {
    static const std::vector<BranchWitness> found = branch_witnesses(family());
    return found;
}

TEST(rsmss_witnesses, every_case_is_reached_within_3_by_3_texels) {
    std::set<unsigned> cases;
    for (const BranchWitness& w : branch_witnesses(family(), 9, 3)) cases.insert(w.branch.kernel->number);
    EXPECT_EQ(cases.size(), 31u);
}

TEST(rsmss_witnesses, every_branch_that_occurs_anywhere_has_one) {
    std::set<std::string> known, larger;
    for (const BranchWitness& w : witnesses()) {
        known.insert(to_string(w.branch));
        if (w.witness.mask.width > 3 || w.witness.mask.height > 3) larger.insert(to_string(w.branch));
    }
    // Far breaches of a bar's end, and breaches equally far both ways, need a fourth texel along the slot.
    EXPECT_EQ(known.size(), 193u);
    EXPECT_EQ(larger.size(), 12u);
    const auto visit = [&](const Mask& mask) {
        for_texels(mask, [&](ivec2 texel) {
            if (const auto branch = branch_of(family(), mask, texel);
                branch && !known.contains(to_string(*branch)))
                ADD_FAILURE() << to_string(*branch) << " at " << texel.x << "," << texel.y << " of\n"
                              << format_mask(mask, '\n');
        });
    };
    for (const Outside outside : {Outside::lit, Outside::shadow, Outside::clamp})
        for (std::uint32_t bits = 0; bits < 1u << 16; bits += 5)
            visit(testing::mask_of_bits(bits, 4, outside));
    for (const NamedMask& named : mask_corpus(22, 20, 40)) visit(named.mask);
}

TEST(rsmss_witnesses, the_fixture_is_what_the_search_finds) {
    std::string text = "// gnomon witnesses rsmss\n";
    for (const BranchWitness& w : witnesses()) text += to_string(w) + "\n";
    EXPECT_EQ(read_file(testing::fixtures_folder() / "witnesses/rsmss_branches.txt"), text);
}

const std::vector<dvec2> points{{0.1237, 0.3391}, {0.7713, 0.0911}, {0.5171, 0.8837}, {0.9419, 0.6173}};

std::size_t compare(const Mask& mask, Random& random) {
    std::size_t compared = 0;
    for_texels(mask, [&](ivec2 texel) {
        const Edge e = edge(mask, texel);
        if (e.sides == glm::uvec2(0)) return;
        const unsigned options = random.below(128);
        for (const dvec2 p : {points[random.below(4)], dvec2{random.unit(), 0.25}}) {
            ASSERT_NEAR(rsmss_visibility_in_mask_space(mask, texel, p, options),
                        chain().value(mask, texel, e, p, options), 1e-12)
                << "options " << options << ", texel " << texel.x << "," << texel.y << " at " << p.x << ","
                << p.y << " of\n"
                << format_mask(mask, '\n');
            ++compared;
        }
    });
    return compared;
}

class rsmss_mask_space : public ::testing::TestWithParam<Outside> {};

TEST_P(rsmss_mask_space, agrees_with_the_cases_on_4x4_masks_with_all_options) {
    Random random(61, static_cast<std::uint64_t>(GetParam()));
    std::size_t compared = 0;
    for (std::uint32_t bits = 0; bits < 1u << 16 && !HasFatalFailure(); bits += 7)
        compared += compare(testing::mask_of_bits(bits, 4, GetParam()), random);
    EXPECT_GT(compared, 100000u);
}

INSTANTIATE_TEST_SUITE_P(surround, rsmss_mask_space,
                         ::testing::Values(Outside::lit, Outside::shadow, Outside::clamp));

TEST(rsmss_mask_space_families, agrees_with_the_cases_with_all_options) {
    Random random(62);
    std::size_t compared = 0;
    for (const NamedMask& named : mask_corpus(63, 8, 40)) {
        SCOPED_TRACE(named.name);
        compared += compare(named.mask, random);
        ASSERT_FALSE(HasFatalFailure());
    }
    EXPECT_GT(compared, 60000u);
}

// Each option changes something, and only its own cases.
TEST(rsmss_options, change_the_cases_that_they_are_about) {
    const std::map<unsigned, std::set<unsigned>> about{
        {printed_end, {5, 7}},
        {first_opening, {4, 6}},
        {first_breach, {9, 11, 13, 15}},
        {opposite_breach, {9, 11, 13, 15}},
        {ramped_bar, {12, 13, 14, 15}},
        {breach_by_position, {12, 14}},
        {long_runs, {8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 19, 22, 23, 24, 25, 27, 30, 31}}};
    std::map<unsigned, std::set<unsigned>> changed;
    for (const NamedMask& named : mask_corpus(64, 24, 40))
        for_texels(named.mask, [&](ivec2 texel) {
            const Edge e = edge(named.mask, texel);
            const Case* c = chain().case_of(e);
            if (!c) return;
            for (const auto& [option, cases] : about)
                for (const dvec2 p : points)
                    if (rsmss_visibility_in_mask_space(named.mask, texel, p, option) !=
                        rsmss_visibility_in_mask_space(named.mask, texel, p, 0))
                        changed[option].insert(c->number);
        });
    for (const auto& [option, cases] : about) {
        for (const unsigned number : changed[option])
            EXPECT_TRUE(cases.contains(number)) << "option " << option << " changes case " << number;
        EXPECT_FALSE(changed[option].empty()) << "option " << option << " changes nothing";
        if (option != long_runs) EXPECT_EQ(changed[option], cases) << "option " << option;
    }
}

// By hand: one step. The ramp's middle leads from (4, 1.5), where the lit run of row 1 ends, to (20, 2.5),
// for the run goes on beyond the border and is taken as 16 long.
TEST(rsmss_by_hand, the_ramp_beside_one_step) {
    const Mask mask = parse_mask("........\n####....\n########\n", '\n', "m"); // row 1: shadow to x = 4
    for (const double x : {4.25, 5.5, 6.75}) // lit run of row 1 from x = 4, open towards +x: taken as 16 long
        for (const double y : {1.1, 1.5, 1.9}) {
            const double line = 1.5 + (x - 4) / 16;
            const ivec2 texel(static_cast<int>(x), 1);
            EXPECT_NEAR(rsmss_visibility_in_mask_space(mask, texel, dvec2(x, y) - dvec2(texel), 0),
                        std::clamp(0.5 + line - y, 0.0, 1.0), 1e-12)
                << x << " " << y;
        }
}

} // namespace
} // namespace gnomon
