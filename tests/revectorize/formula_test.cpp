// The formulas that people read (describe, atlas) against the references: on every edge of the mask families,
// with the recommended readings.
#include "tests/support/formula.h"

#include "casegen/sampling.h"
#include "tests/support/case_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace gnomon {
namespace {

using Names = std::map<std::string, double>;

double distance(double p, unsigned side) { return side == reference::minus ? p : 1 - p; }

double along(glm::ivec2 reach, double c) {
    return reference::edge_type(reach) == 0 ? reference::along(reach, c) : 1;
}

/// What the formulas' names stand for at a point of a texel; the legend of the atlas says it in words.
Names names_at(const Mask& mask, glm::ivec2 texel, const reference::Edge& e, glm::dvec2 p) {
    Names names{{"NEITHER", 0}, {"MINUS", 1}, {"PLUS", 2}, {"BOTH", 3}, {"UNBROKEN", 4}};
    names["p.x"] = p.x, names["p.y"] = p.y;
    names["t_h"] = e.type.x, names["t_v"] = e.type.y;
    names["d_c.b"] = e.lit ? 0 : 1, names["entering"] = e.lit ? 1 : 0;
    names["along_x"] = along({e.reach.x, e.reach.y}, p.x);
    names["along_y"] = along({e.reach.z, e.reach.w}, p.y);
    names["q_x"] = distance(p.x, e.sides.x), names["q_y"] = distance(p.y, e.sides.y);
    names["E_x"] = e.type.y == 1 ? names["q_x"] : 1 + names["q_x"] - names["along_y"];
    names["E_y"] = e.type.x == 1 ? names["q_y"] : 1 + names["q_y"] - names["along_x"];
    names["X_x"] = 1 - names["E_x"], names["X_y"] = 1 - names["E_y"];
    if (e.sides.x != reference::both && e.sides.y != reference::both) return names;
    const bool across_x = e.sides.x == reference::both; // the slot lies along y
    const glm::uvec2 next = reference::neighbours(mask, texel, e.sides);
    const unsigned breach = reference::breach(mask, texel, e.sides);
    const unsigned n = (across_x ? e.sides.y : e.sides.x) == reference::plus ? next.x : next.y;
    const double across = across_x ? p.x : p.y;
    const std::string axis = across_x ? "y" : "x";
    names["n_-" + axis] = next.x, names["n_+" + axis] = next.y, names["n"] = n, names["d_cb"] = breach;
    names["w_-" + axis] = distance(across, next.x), names["w_+" + axis] = distance(across, next.y);
    names["w"] = distance(across, n), names["w_cb"] = distance(across, breach);
    return names;
}

class formulas : public ::testing::TestWithParam<std::string> {};

TEST_P(formulas, give_what_the_reference_gives) {
    const testing::CaseChain chain(GetParam());
    const EdgePool pool = make_edge_pool(95);
    std::map<std::string, std::size_t> compared;
    for (const EdgePool::Entry& entry : pool.entries) {
        const Mask& mask = pool.masks[entry.mask];
        const glm::ivec2 texel(entry.texel);
        const reference::Edge edge = entry.edge();
        const Case* c = chain.case_of(edge);
        if (!c || c->number == 0) continue;
        for (const glm::dvec2 p :
             {glm::dvec2(0.1237, 0.3391), glm::dvec2(0.7713, 0.0911), glm::dvec2(0.5171, 0.8837)}) {
            const double said = testing::value_of_formula(c->formula, names_at(mask, texel, edge, p));
            ASSERT_NEAR(std::clamp(said, 0.0, 1.0), chain.value(mask, texel, edge, p), 1e-12)
                << c->name << ": " << c->formula << "\n"
                << texel.x << "," << texel.y << " of\n"
                << format_mask(mask, '\n');
            ++compared[c->name];
        }
    }
    for (const Case* c : find_cases(GetParam() + "/"))
        if (c->number != 0) EXPECT_GT(compared[c->name], 50u) << c->name;
}

INSTANTIATE_TEST_SUITE_P(of, formulas, ::testing::Values("smsr", "rsmss", "rbsm/silhouette", "rbsm/filter"));

TEST(formula_reader, tells_wrong_formulas) {
    const Names names{{"p.x", 0.25}, {"n_-y", 3}};
    EXPECT_EQ(testing::value_of_formula("1 - p.x", names), 0.75);
    EXPECT_EQ(
        testing::value_of_formula("0 if n_-y = 2; max(p.x, 0.5) if n_-y = 3 and p.x < 1; 1 otherwise", names),
        0.5);
    EXPECT_EQ(testing::value_of_formula("0 if n_-y = 2 or p.x < 0.5; 1 otherwise", names), 0);
}

} // namespace
} // namespace gnomon
