#include "casegen/readings.h"

#include "casegen/reference/rsmss.h"
#include "runtime/error.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

namespace gnomon {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

std::string error_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

TEST(readings, are_named_and_the_first_value_is_the_default) {
    EXPECT_EQ(parse_readings({}), Readings{});
    for (const Reading& reading : readings()) {
        ASSERT_EQ(reading.values.size(), reading.bits.size()) << reading.name;
        EXPECT_EQ(reading.bits.front(), Readings{}) << reading.name;
        for (std::size_t i = 0; i < reading.values.size(); ++i) {
            const std::string setting = std::string(reading.name) + "=" + reading.values[i];
            EXPECT_EQ(parse_readings({setting}), reading.bits[i]) << setting;
            EXPECT_EQ(to_string(parse_readings({setting})), i == 0 ? "" : setting);
        }
    }
}

TEST(readings, add_up_and_the_last_of_a_name_wins) {
    using namespace reference;
    EXPECT_EQ(parse_readings({"bar=ramp", "slot-end=printed", "isolated=flipped"}),
              (Readings{ramped_bar | printed_end, true}));
    EXPECT_EQ(parse_readings({"breach-tie=first", "breach-tie=opposite"}).rsmss, unsigned{opposite_breach});
    EXPECT_EQ(parse_readings({"bar=ramp", "bar=dark", "isolated=flipped", "isolated=edge"}), Readings{});
}

TEST(readings, that_there_are_not_are_named_in_the_error) {
    EXPECT_THAT(error_of([] { parse_readings({"bars=ramp"}); }),
                AllOf(HasSubstr("bars=ramp"), HasSubstr("far-breach")));
    EXPECT_THAT(error_of([] { parse_readings({"bar"}); }), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(error_of([] { parse_readings({"bar=bright"}); }),
                AllOf(HasSubstr("dark, ramp"), HasSubstr("bar=bright")));
    EXPECT_THAT(error_of([] { parse_readings({"=ramp"}); }), HasSubstr("NAME=VALUE"));
    EXPECT_THAT(error_of([] { readings_for("smsr", {"bar=ramp"}); }),
                AllOf(HasSubstr("rsmss"), HasSubstr("smsr")));
    EXPECT_TRUE(readings_for("smsr", {"isolated=flipped"}).flip_isolated);
}

TEST(readings, become_texts_that_kernels_include) {
    const auto sources = reading_sources({.rsmss = 16, .flip_isolated = true});
    EXPECT_THAT(sources.at("rsmss/options"), HasSubstr("RSMSS_OPTIONS = 16u"));
    EXPECT_THAT(sources.at("pipeline/options"), HasSubstr("FLIP_ISOLATED 1"));
    EXPECT_THAT(reading_sources({}).at("pipeline/options"), HasSubstr("FLIP_ISOLATED 0"));
}

} // namespace
} // namespace gnomon
