// The list of equivalent mutants: what it may look like.
#include "casegen/mutate/equivalent.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace gnomon::mutate {
namespace {

using ::testing::HasSubstr;

std::string refusal(const std::string& text) {
    return testing::error_of([&] { parse_equivalents(text, "list.json"); });
}

TEST(equivalents, are_groups_that_share_a_reason) {
    const std::vector<Equivalent> all = parse_equivalents(
        R"([{"file": "a.glsl", "reason": "never reached", "mutants": {"01": "x -> y", "02": "y -> x"}},
            {"file": "b.glsl", "reason": "rounding", "tolerated": true, "mutants": {"03": "1.0 -> 2.0"}}])",
        "list.json");
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[1].id, "02");
    EXPECT_EQ(all[1].file, "a.glsl");
    EXPECT_EQ(all[1].mutation, "y -> x");
    EXPECT_EQ(all[1].reason, "never reached");
    EXPECT_FALSE(all[1].tolerated);
    EXPECT_TRUE(all[2].tolerated);
}

TEST(equivalents, must_give_a_reason_and_be_well_formed) {
    EXPECT_THAT(refusal("{"), HasSubstr("list.json: not JSON"));
    EXPECT_THAT(refusal("{}"), HasSubstr("not a list"));
    EXPECT_THAT(refusal("[1]"), HasSubstr("group 1 is not an object"));
    EXPECT_THAT(refusal(R"([{"file": "a", "mutants": {"1": ""}}])"), HasSubstr("group 1: \"reason\""));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "", "mutants": {"1": ""}}])"), HasSubstr("\"reason\""));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "r", "mutants": {}}])"), HasSubstr("\"mutants\""));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "r", "mutants": {"1": 2}}])"), HasSubstr("mutant 1"));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "r", "why": "", "mutants": {"1": ""}}])"),
                HasSubstr("why"));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "r", "tolerated": 1, "mutants": {"1": ""}}])"),
                HasSubstr("tolerated"));
    EXPECT_THAT(refusal(R"([{"file": "a", "reason": "r", "mutants": {"1": ""}},
                            {"file": "a", "reason": "s", "mutants": {"1": ""}}])"),
                HasSubstr("listed twice"));
}

TEST(equivalents, of_the_kernels_can_be_read) {
    EXPECT_NO_THROW(load_equivalents(testing::fixtures_folder() / "mutants/equivalent.json"));
    EXPECT_THROW(load_equivalents("no such file"), Error);
}

} // namespace
} // namespace gnomon::mutate
