#include "casegen/assembly.h"

#include "casegen/catalogue.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/text.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon {
namespace {

using testing::count_of;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

const Family& smsr() { return technique_family("smsr"); }

std::vector<unsigned> numbers(const std::vector<const Case*>& cases) {
    std::vector<unsigned> result;
    for (const Case* c : cases) result.push_back(c->number);
    return result;
}

std::vector<std::string> needed(const Assembly& assembly) {
    std::vector<std::string> names;
    for (const CaseParameter& p : case_parameters(smsr(), assembly))
        if (p.needed) names.push_back(p.name);
    return names;
}

TEST(assembly, holds_all_cases_unless_it_names_some) {
    EXPECT_EQ(held_cases(smsr(), {}), numbered_cases(smsr()));
    EXPECT_THAT(left_out_cases(smsr(), {}), IsEmpty());
    EXPECT_THAT(numbers(held_cases(smsr(), {.cases = {9, 3, 9}})), ElementsAre(9, 3));
    EXPECT_THAT(numbers(left_out_cases(smsr(), {.cases = {9, 3, 12, 1, 2, 4, 5}})),
                ElementsAre(6, 7, 8, 10, 11));
    EXPECT_THAT(held_cases(smsr(), {.cases = {0}}), IsEmpty());
    EXPECT_EQ(left_out_cases(smsr(), {.cases = {0}}).size(), 12u);
}

TEST(assembly, the_document_s_order_is_the_numbers) {
    EXPECT_THAT(numbers(held_cases(smsr(), {.variant = Variant::document_order, .cases = {9, 3, 5}})),
                ElementsAre(3, 5, 9));
    EXPECT_THAT(numbers(held_cases(smsr(), {.variant = Variant::frequency_order, .cases = {9, 3, 5}})),
                ElementsAre(9, 3, 5));
}

TEST(assembly, refuses_numbers_and_families_that_are_not_there) {
    EXPECT_THAT(error_of([] { assembled(smsr(), {.cases = {13}}); }), HasSubstr("no case 13"));
    EXPECT_THAT(error_of([] { generated_sources({{"smrs", {}}}); }), HasSubstr("\"smrs\""));
    EXPECT_THAT(error_of([] { generated_sources({{"nsm", {}}}); }), HasSubstr("\"nsm\""));
}

TEST(assembly, says_which_parameters_a_held_case_takes) {
    EXPECT_THAT(needed({}), ElementsAre("along_x", "along_y", "p", "side_x", "side_y"));
    EXPECT_THAT(needed({.cases = {9, 2}}), ElementsAre("along_x", "p"));
    EXPECT_THAT(needed({.cases = {0}}), IsEmpty());
    const std::string text = assembled(smsr(), {.cases = {9, 2}});
    EXPECT_THAT(text, HasSubstr("const bool smsr_needs_along_x = true;\n"));
    EXPECT_THAT(text, HasSubstr("const bool smsr_needs_side_y = false;\n"));
    // The call stays the same whatever is held.
    EXPECT_THAT(text, HasSubstr("(uint number, Edge edge, float along_x, float along_y, vec2 p, uint side_x, "
                                "uint side_y)"));
}

TEST(assembly, leaves_out_the_text_of_the_others) {
    for (const Variant variant : all_variants()) {
        const std::string text = assembled(smsr(), {.variant = variant, .cases = {9, 12}});
        EXPECT_EQ(count_of(text, "#include \"smsr/"), 2u) << to_string(variant);
        EXPECT_EQ(count_of(text, "smsr_case_09("), 1u) << to_string(variant);
        EXPECT_EQ(count_of(text, "smsr_case_12("), 1u) << to_string(variant);
        EXPECT_EQ(count_of(text, "case_left_out = "), 1u) << to_string(variant);
        EXPECT_THAT(assembled(smsr(), {.variant = variant}), Not(HasSubstr("case_left_out = ")))
            << to_string(variant) << ": a full assembly pays nothing";
    }
}

TEST(assembly, asks_in_the_order_of_its_cases) {
    const std::string text = assembled(smsr(), {.variant = Variant::frequency_order, .cases = {9, 3, 5}});
    EXPECT_LT(text.find("return smsr_case_09"), text.find("return smsr_case_03"));
    EXPECT_LT(text.find("return smsr_case_03"), text.find("return smsr_case_05"));
    EXPECT_THAT(text, HasSubstr("if (" + to_glsl(find_case("smsr/case_09").condition) + ")"));
}

TEST(assembly, counts_conditions_on_request_only) {
    EXPECT_THAT(assembled(smsr(), {.variant = Variant::document_order}), Not(HasSubstr("tested")));
    const std::string text = assembled(smsr(), {.variant = Variant::document_order, .count_tests = true});
    EXPECT_EQ(count_of(text, "if (condition_tested("), 12u);
}

// A case stands in each half that an edge of it can be in, and nothing is asked twice.
TEST(assembly, a_tree_asks_for_a_BOTH_once) {
    const std::string text = assembled(smsr(), {.variant = Variant::branch_tree});
    const std::size_t split = text.find("if (edge.sides.x == BOTH || edge.sides.y == BOTH) {"),
                      otherwise = text.find("} else {");
    ASSERT_NE(split, text.npos);
    ASSERT_NE(otherwise, text.npos);
    const std::string both = text.substr(split, otherwise - split), one = text.substr(otherwise);
    EXPECT_THAT(both,
                AllOf(HasSubstr("smsr_case_01("), HasSubstr("smsr_case_02("), HasSubstr("smsr_case_03("),
                      Not(HasSubstr("smsr_case_09(")), Not(HasSubstr("smsr_case_08("))));
    EXPECT_THAT(one, AllOf(HasSubstr("smsr_case_01("), HasSubstr("smsr_case_02("), HasSubstr("smsr_case_09("),
                           Not(HasSubstr("smsr_case_03(")), Not(HasSubstr("== BOTH"))));
    EXPECT_THAT(text, Not(HasSubstr("if (edge.lit) {"))) << "every case of smsr is lit: nothing to part";
}

} // namespace
} // namespace gnomon
