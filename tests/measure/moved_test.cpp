// What moved between two benches that are made up here, number by number.
#include "casegen/measure/moved.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::measure {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::SizeIs;
constexpr double infinity = std::numeric_limits<double>::infinity();

KernelRecord kernel(const std::string& name) {
    KernelRecord made;
    made.name = name;
    made.unit = "absolute";
    made.inputs = 1000;
    made.error.median = 1e-8;
    made.error.p99 = 1e-7;
    made.error.most = 1e-6;
    made.instructions = 100;
    made.time = TimeRecord{{2, {1.98, 2.02}}, 0.03};
    made.step = 1e-6;
    return made;
}

TechniqueRecord technique(const std::string& name) {
    TechniqueRecord made;
    made.name = name;
    made.wrong_lit = 30;
    made.wrong_shadowed = 20;
    made.rmse = 0.05;
    made.time = TimeRecord{{1.5, {1.45, 1.55}}, 0.03};
    return made;
}

Baseline baseline() {
    Baseline made;
    made.machine = "a machine";
    made.driver = "a driver";
    made.compiler = "a compiler";
    made.samples = 1024;
    made.repeats = 16;
    made.rounds = 9;
    made.yardstick = 7;
    made.kernels = {kernel("a"), kernel("b"), kernel("c")};
    SceneRecord scene;
    scene.scene = "demo";
    scene.width = 48;
    scene.height = 36;
    scene.shadow_map = 16;
    scene.facing = 900;
    scene.yardstick = "nsm";
    scene.techniques = {technique("nsm"), technique("smsr")};
    made.scenes = {scene};
    return made;
}

/// The only thing that moved.
Move the_move(const Baseline& before, const Baseline& now) {
    const Moved all = moved(before, now, true);
    EXPECT_THAT(all.moves, SizeIs(1)) << to_text(all, "it");
    return all.moves.empty() ? Move{} : all.moves.front();
}

TEST(moved, nothing_moves_from_a_baseline_to_itself) {
    const Moved all = moved(baseline(), baseline(), true);
    EXPECT_THAT(all.moves, SizeIs(0));
    EXPECT_THAT(all.notes, SizeIs(0));
    EXPECT_EQ(all.kernels, 3u);
    EXPECT_EQ(all.techniques, 2u);
    EXPECT_EQ(all.times, 5u);
    const std::string text = to_text(all, "it.json");
    EXPECT_THAT(text, AllOf(HasSubstr("nothing moved"), HasSubstr("3 kernels"), HasSubstr("it.json")));
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1);
}

TEST(moved, any_bit_of_an_error_is_told_and_is_worse_beyond_the_tolerance_s_unit) {
    Baseline now = baseline();
    double& most = now.kernels[1].error.most;
    most = std::nextafter(1e-6, 1);
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
    EXPECT_EQ(the_move(baseline(), now).name, "b");
    EXPECT_THAT(the_move(baseline(), now).what,
                AllOf(HasSubstr("-> 1.0000000000000002e-06"), Not(HasSubstr("median"))));
    most = 1.9e-6;
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
    most = 2.1e-6;
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
    most = 0.9e-6;
    EXPECT_EQ(the_move(baseline(), now).change, Change::better);
    now.kernels[1].error.median = 2e-8; // one up, one down
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
}

TEST(moved, an_exact_kernel_has_no_unit_to_spare) {
    Baseline before = baseline(), now = baseline();
    before.kernels[0].error = now.kernels[0].error = {};
    before.kernels[0].step = now.kernels[0].step = 0;
    EXPECT_THAT(moved(before, now, true).moves, SizeIs(0));
    now.kernels[0].error.most = 1e-30;
    EXPECT_EQ(the_move(before, now).change, Change::worse);
    EXPECT_EQ(the_move(now, before).change, Change::better);
}

TEST(moved, an_error_in_units_of_the_limit_decides_where_there_is_one) {
    Baseline before = baseline(), now = baseline();
    for (Baseline* each : {&before, &now}) {
        each->kernels[2].step = 1;
        each->kernels[2].over_limit = Quantiles{};
        each->kernels[2].over_limit->most = 2;
    }
    now.kernels[2].error.most = 1; // a million times as much, where the limit is as large
    now.kernels[2].over_limit->most = 2.9;
    EXPECT_EQ(the_move(before, now).change, Change::changed);
    now.kernels[2].over_limit->most = 3.1;
    EXPECT_EQ(the_move(before, now).change, Change::worse);
    EXPECT_THAT(the_move(before, now).what, HasSubstr("max/κu 2 -> 3.1"));
}

TEST(moved, what_is_not_finite_is_larger_than_everything) {
    Baseline now = baseline();
    for (const double value : {infinity, std::nan("")}) {
        now.kernels[0].error.most = value;
        EXPECT_EQ(the_move(baseline(), now).change, Change::worse) << value;
        EXPECT_EQ(the_move(now, baseline()).change, Change::better) << value;
        EXPECT_THAT(moved(now, now, true).moves, SizeIs(0)) << value;
    }
    now = baseline();
    now.kernels[0].error.non_finite = 1;
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
    EXPECT_EQ(the_move(now, baseline()).change, Change::better);
    now = baseline();
    now.scenes[0].techniques[1].rmse = std::nan("");
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
    EXPECT_EQ(the_move(now, baseline()).change, Change::better);
}

TEST(moved, every_instruction_is_told_and_none_is_worse) {
    Baseline now = baseline();
    now.kernels[0].instructions = 101;
    const Move move = the_move(baseline(), now);
    EXPECT_EQ(move.change, Change::changed);
    EXPECT_EQ(move.what, "instructions 100 -> 101");
    now.compiler = "another";
    const Moved all = moved(baseline(), now, true);
    EXPECT_THAT(all.moves, SizeIs(0));
    EXPECT_THAT(all.notes, ::testing::ElementsAre(HasSubstr("other compilers")));
}

TEST(moved, a_time_moves_only_where_the_whole_interval_lies_beyond_the_noise) {
    Baseline now = baseline();
    Ratio& ratio = now.kernels[1].time->ratio;
    ratio = {2.6, {2.5, 2.7}};
    const Move slower = the_move(baseline(), now);
    EXPECT_EQ(slower.change, Change::slower);
    EXPECT_TRUE(slower.time);
    EXPECT_THAT(slower.what, HasSubstr("time 1.30 of the baseline's"));
    ratio = {1.5, {1.45, 1.55}};
    EXPECT_EQ(the_move(baseline(), now).change, Change::faster);
    ratio = {2.6, {2.1, 2.9}}; // may be within
    EXPECT_THAT(moved(baseline(), now, true).moves, SizeIs(0));
    ratio = {2.15, {2.14, 2.16}}; // is within
    EXPECT_THAT(moved(baseline(), now, true).moves, SizeIs(0));
    ratio = {2.6, {2.5, 2.7}};
    now.kernels[1].time->noise = 0.4;
    EXPECT_THAT(moved(baseline(), now, true).moves, SizeIs(0));
}

TEST(moved, of_a_time_that_is_missing_or_none_nothing_is_said) {
    Baseline now = baseline();
    const double nan = std::nan("");
    for (const std::optional<TimeRecord>& time :
         {std::optional<TimeRecord>{}, std::optional(TimeRecord{{nan, {nan, nan}}, 0.03}),
          std::optional(TimeRecord{{5, {-infinity, infinity}}, 0.03}),
          std::optional(TimeRecord{{infinity, {infinity, infinity}}, 0.03}),
          std::optional(TimeRecord{{0, {0, 0}}, 0.03})}) {
        now.kernels[0].time = time;
        EXPECT_THAT(moved(baseline(), now, true).moves, SizeIs(0));
        EXPECT_THAT(moved(now, baseline(), true).moves, SizeIs(0));
    }
}

TEST(moved, too_few_rounds_say_nothing_and_that_is_said) {
    Baseline now = baseline();
    now.rounds = 5;
    for (KernelRecord& each : now.kernels) each.time->ratio = {9, {-infinity, infinity}};
    const Moved all = moved(baseline(), now, true);
    EXPECT_THAT(all.moves, SizeIs(0));
    EXPECT_THAT(all.notes, ::testing::ElementsAre(HasSubstr("fewer than 6 rounds")));
}

TEST(moved, times_of_another_machine_or_yardstick_decide_nothing) {
    Baseline now = baseline();
    now.kernels[1].time->ratio = {2.6, {2.5, 2.7}};
    now.machine = "another";
    Moved all = moved(baseline(), now, true);
    EXPECT_THAT(all.moves, SizeIs(0));
    EXPECT_THAT(all.notes, ::testing::ElementsAre(HasSubstr("another machine")));
    now.kernels[1].time->ratio = {8, {7.9, 8.1}};
    EXPECT_EQ(the_move(baseline(), now).change, Change::uncertain);
    EXPECT_FALSE(is_bad(Change::uncertain));
    now.yardstick = 8;
    all = moved(baseline(), now, true);
    EXPECT_THAT(all.moves, SizeIs(0));
}

TEST(moved, errors_of_another_driver_are_compared_loosely) {
    Baseline now = baseline();
    now.driver = "another";
    now.kernels[0].error.most = 1.1e-6;
    const Moved all = moved(baseline(), now, true);
    EXPECT_THAT(all.moves, SizeIs(0));
    EXPECT_THAT(all.notes, ::testing::ElementsAre(HasSubstr("another driver")));
    now.kernels[0].error.most = 3e-6;
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
}

TEST(moved, kernels_and_techniques_come_and_go) {
    Baseline fewer = baseline();
    fewer.kernels.pop_back();
    EXPECT_EQ(the_move(baseline(), fewer).change, Change::removed);
    EXPECT_EQ(the_move(fewer, baseline()).change, Change::added);
    EXPECT_EQ(the_move(fewer, baseline()).name, "c");
    EXPECT_THAT(moved(baseline(), fewer, false).moves, SizeIs(0)); // it was not asked about
    fewer = baseline();
    fewer.scenes[0].techniques.pop_back();
    EXPECT_EQ(the_move(baseline(), fewer).change, Change::removed);
    EXPECT_EQ(the_move(fewer, baseline()).name, "demo: smsr");
    Baseline none = baseline();
    none.scenes.clear();
    EXPECT_EQ(the_move(none, baseline()).change, Change::added);
    EXPECT_THAT(moved(baseline(), none, true).moves, SizeIs(0));
}

TEST(moved, what_was_measured_otherwise_is_not_compared) {
    Baseline now = baseline();
    now.kernels[0].inputs = 999;
    now.kernels[0].error.most = 1;
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
    EXPECT_THAT(the_move(baseline(), now).what, HasSubstr("cannot be compared"));
    now = baseline();
    now.scenes[0].facing = 901;
    now.scenes[0].techniques[0].wrong_lit = 800;
    EXPECT_THAT(the_move(baseline(), now).what, HasSubstr("cannot be compared"));
}

TEST(moved, more_wrong_pixels_are_worse) {
    Baseline now = baseline();
    std::size_t& lit = now.scenes[0].techniques[1].wrong_lit;
    lit = 31;
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
    EXPECT_THAT(the_move(baseline(), now).what, HasSubstr("wrong pixels 50 -> 51"));
    lit = 29;
    EXPECT_EQ(the_move(baseline(), now).change, Change::better);
    now.scenes[0].techniques[1].wrong_shadowed = 21; // others, as many
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
    now = baseline();
    now.scenes[0].techniques[1].rmse = 0.0502;
    EXPECT_EQ(the_move(baseline(), now).change, Change::worse);
    now.scenes[0].techniques[1].rmse = 0.05 + 1e-6;
    EXPECT_EQ(the_move(baseline(), now).change, Change::changed);
}

TEST(moved, the_bad_stands_first) {
    Baseline now = baseline();
    now.kernels[0].instructions = 90;
    now.kernels[2].error.most = 1;
    const Moved all = moved(baseline(), now, true);
    ASSERT_THAT(all.moves, SizeIs(2));
    EXPECT_EQ(all.moves[0].change, Change::worse);
    EXPECT_THAT(to_text(all, "it.json"), HasSubstr("2 moved, 1 of them for the worse"));
}

TEST(moved, only_a_second_look_confirms_a_time) {
    Baseline now = baseline();
    now.kernels[0].time->ratio = {2.6, {2.5, 2.7}};
    now.kernels[1].time->ratio = {1.5, {1.45, 1.55}};
    now.kernels[2].error.most = 1;
    const Moved first = moved(baseline(), now, true);
    ASSERT_THAT(first.moves, SizeIs(3));
    EXPECT_THAT(confirmed(first, first).moves, SizeIs(3));
    Baseline again = now;
    again.kernels[1].time->ratio = {2.6, {2.5, 2.7}}; // the other way this time
    again.kernels.pop_back();                         // an error needs no second look
    const Moved kept = confirmed(first, moved(baseline(), again, false));
    ASSERT_THAT(kept.moves, SizeIs(2));
    EXPECT_EQ(kept.moves[0].name, "a");
    EXPECT_EQ(kept.moves[1].name, "c");
}

} // namespace
} // namespace gnomon::measure
