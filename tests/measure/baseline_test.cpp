#include "casegen/measure/baseline.h"

#include "casegen/measure/moved.h"
#include "runtime/error.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"
#include "tests/support/sine_family.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <functional>

namespace gnomon::measure {
namespace {

using ::testing::AllOf;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;

Bench measured(const testing::SineFamily& family, unsigned rounds) {
    BenchOptions options;
    options.kernels = family.kernels();
    options.samples = 200;
    options.repeats = 2;
    options.rounds = rounds;
    options.device = testing::validated();
    return bench(group(family.pointers(), std::array{Trigonometry::portable}, family.kernels()), options);
}

SceneResult scene() {
    SceneResult made;
    made.view.scene = "a \"scene\"\n";
    made.view.settings.width = 48;
    made.view.settings.height = 36;
    made.yardstick = "nsm";
    made.noise = 0.04;
    FrameRow row;
    row.technique = "nsm";
    row.counts.facing = 100;
    row.counts.wrong_lit = 3;
    row.rmse = 1.0 / 3;
    row.times.rounds = {1, 2, 3};
    row.over_yardstick = {
        1, {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}};
    made.rows = {row};
    return made;
}

TEST(baseline, a_file_holds_every_bit_of_what_was_measured) {
    const testing::SineFamily family;
    const Baseline made = baseline_of(measured(family, 6), std::array{scene()});
    const std::string text = to_json(made);
    const Baseline read = parse_baseline(text, "it");
    EXPECT_EQ(to_json(read), text);
    ASSERT_THAT(read.kernels, SizeIs(4));
    for (std::size_t i = 0; i < read.kernels.size(); ++i) {
        EXPECT_EQ(read.kernels[i].error.median, made.kernels[i].error.median);
        EXPECT_EQ(read.kernels[i].error.most, made.kernels[i].error.most);
        EXPECT_EQ(read.kernels[i].over_limit->p99, made.kernels[i].over_limit->p99);
        EXPECT_GT(read.kernels[i].instructions, 10u);
        EXPECT_GT(read.kernels[i].time->ratio.median, 0);
    }
    EXPECT_TRUE(std::isinf(read.kernels[0].error.most)); // "printed" divides 0 by 0
    EXPECT_GT(read.kernels[0].error.non_finite, 0u);
    EXPECT_GT(read.kernels[2].instructions, read.kernels[1].instructions); // the same 16 times over
    EXPECT_EQ(read.scenes[0].techniques[0].rmse, 1.0 / 3);
    EXPECT_LT(read.scenes[0].techniques[0].time->ratio.interval.lower, 0);
    EXPECT_EQ(read.scenes[0].scene, "a \"scene\"\n");
    EXPECT_THAT(moved(read, made, true).moves, SizeIs(0));
    // What can be compared by eye: a line per kernel.
    EXPECT_THAT(text, HasSubstr("\n    {\"kernel\":\"wave/sinc\""));
}

TEST(baseline, the_same_is_measured_again_and_a_kernel_that_is_off_is_found) {
    const testing::SineFamily family;
    const Baseline before = baseline_of(measured(family, 0), {});
    EXPECT_THAT(moved(before, baseline_of(measured(family, 0), {}), true).moves, SizeIs(0));
    EXPECT_FALSE(before.kernels[0].time);
    // "sinc" as what "spiked" is: 1 % off in a sliver.
    Baseline now = before;
    now.kernels[1].error = now.kernels[3].error;
    now.kernels[1].over_limit = now.kernels[3].over_limit;
    EXPECT_EQ(moved(before, now, true).moves.empty(),
              before.kernels[1].error.most == before.kernels[3].error.most);
}

TEST(baseline, what_is_no_baseline_is_refused_with_where_it_is_wrong) {
    using Json = nlohmann::json;
    const testing::SineFamily family;
    const Json good = Json::parse(to_json(baseline_of(measured(family, 0), std::array{scene()})));
    const auto refused = [&](const std::function<void(Json&)>& damage) {
        Json bad = good;
        damage(bad);
        const std::string message = error_of([&] { parse_baseline(bad.dump(), "b.json"); });
        EXPECT_THAT(message, AllOf(HasSubstr("b.json"), Not(HasSubstr("\n"))));
        return message;
    };
    EXPECT_THAT(refused([](Json& j) { j.erase("driver"); }), HasSubstr("no \"driver\""));
    EXPECT_THAT(refused([](Json& j) { j["format"] = 2; }), HasSubstr("format 2"));
    EXPECT_THAT(refused([](Json& j) { j["format"] = "1"; }), HasSubstr("--save"));
    EXPECT_THAT(refused([](Json& j) { j = Json::array(); }), HasSubstr("not a baseline"));
    EXPECT_THAT(refused([](Json& j) { j["samples"] = -1; }), HasSubstr("\"samples\" is not a count"));
    EXPECT_THAT(refused([](Json& j) { j["kernels"] = 3; }), HasSubstr("\"kernels\" is not a list"));
    EXPECT_THAT(refused([](Json& j) { j["kernels"][1] = 3; }), HasSubstr("object"));
    EXPECT_THAT(refused([](Json& j) { j["kernels"][1]["error"]["max"] = -1; }),
                AllOf(HasSubstr("wave/sinc"), HasSubstr("\"max\"")));
    EXPECT_THAT(refused([](Json& j) { j["kernels"][1]["error"]["max"] = "small"; }), HasSubstr("\"max\""));
    EXPECT_THAT(refused([](Json& j) { j["kernels"][1] = j["kernels"][0]; }), HasSubstr("twice"));
    EXPECT_THAT(refused([](Json& j) { j["scenes"][0]["techniques"][0].erase("rmse"); }),
                AllOf(HasSubstr("technique nsm"), HasSubstr("rmse")));
    EXPECT_THAT(refused([](Json& j) { j["scenes"][0]["techniques"][0]["time"].erase("noise"); }),
                HasSubstr("noise"));
    EXPECT_THAT(error_of([] { parse_baseline("{\"format\": 1,", "b.json"); }),
                HasSubstr("b.json: is not JSON"));
    EXPECT_THAT(error_of([] { parse_baseline("", "b.json"); }), HasSubstr("b.json: is not JSON"));
}

} // namespace
} // namespace gnomon::measure
