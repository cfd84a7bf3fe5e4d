// Variants of one quantity that is known through and through.
#include "casegen/measure/bench.h"

#include "casegen/catalogue.h"
#include "casegen/mask_families.h"
#include "casegen/measure/charts.h"
#include "casegen/measure/loop.h"
#include "casegen/measure/pareto.h"
#include "casegen/measure/report.h"
#include "casegen/measure/tables.h"
#include "casegen/sampling.h"
#include "casegen/standalone.h"
#include "runtime/files.h"
#include "tests/support/device.h"
#include "tests/support/environment.h"
#include "tests/support/sine_family.h"
#include "tests/support/text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <numeric>
#include <regex>

namespace gnomon::measure {
namespace {

using ::testing::AllOf;
using testing::count_of;
using ::testing::ElementsAre;
using testing::error_of;
using ::testing::HasSubstr;
using ::testing::Not;
using testing::SineFamily;

BenchOptions options_for(const SineFamily& family) {
    BenchOptions options;
    options.kernels = family.kernels();
    options.samples = 300;
    options.repeats = 6;
    options.rounds = 0;
    options.device = testing::validated();
    return options;
}

Bench measured(const SineFamily& family, const BenchOptions& options) {
    return bench(group(family.pointers(), std::array{Trigonometry::portable}, family.kernels()), options);
}

TEST(bench, groups_kernels_by_their_quantity) {
    const SineFamily family;
    std::vector<const Case*> cases = family.pointers();
    cases.insert(cases.begin(), &find_case("smsr/case_09"));
    Case other = family.cases()[0]; // of the same quantity, with other parameters
    other.name = "wave/other";
    other.reference.parameters.pop_back();
    cases.push_back(&other);
    const std::vector<Group> groups = group(cases, std::array{Trigonometry::portable}, family.kernels());
    ASSERT_EQ(groups.size(), 3u);
    EXPECT_EQ(groups[0].name, "smsr/case_09");
    EXPECT_EQ(groups[1].name, "wave/integral");
    ASSERT_EQ(groups[1].variants.size(), 4u);
    EXPECT_EQ(groups[1].variants[0].label, "printed");
    EXPECT_EQ(groups[1].variants[3].label, "spiked");
    EXPECT_EQ(groups[2].name, "wave/other");
}

TEST(bench, is_asked_for_by_quantity_or_name) {
    const auto names = [](const std::string& patterns) {
        std::vector<std::string> found;
        for (const Case* c : find_variants(patterns)) found.push_back(c->name);
        return found;
    };
    const std::vector<std::string> quantity = names("integral/a0"); // all its forms, and nothing else
    EXPECT_THAT(quantity, AllOf(::testing::Contains("integral/printed/a0"),
                                ::testing::Contains("integral/exact_theta/a0"),
                                ::testing::Each(::testing::EndsWith("/a0"))));
    std::vector<std::string> both = names("integral/a0,smsr/case_09");
    EXPECT_EQ(both.size(), quantity.size() + 1);
    EXPECT_THAT(both, ::testing::Contains("smsr/case_09"));
    EXPECT_EQ(names("").size(), find_cases("").size());
    EXPECT_THROW(names("integral/a0,no such thing"), Error);
}

TEST(bench, inputs_add_up_by_class_locus_and_distance) {
    const SineFamily family;
    const BenchOptions options = options_for(family);
    const Bench made = measured(family, options);
    ASSERT_EQ(made.groups.size(), 1u);
    const GroupResult& result = made.groups[0];
    EXPECT_THAT(result.classes, ElementsAre("ordinary", "k", "cell"));
    EXPECT_EQ(result.left_out, 0u);
    EXPECT_THAT(result.class_counts, ElementsAre(300u, 2 * 13 * 6u, 13 * 6u));
    EXPECT_EQ(result.inputs, 300u + 3 * 13 * 6);
    for (const Accuracy& accuracy : result.accuracy) {
        EXPECT_EQ(accuracy.all.of_scale.count, result.inputs);
        std::size_t classes = 0, loci = 0, non_finite = 0;
        for (std::size_t n = 0; n < result.classes.size(); ++n) {
            EXPECT_EQ(accuracy.classes[n].of_scale.count, result.class_counts[n]);
            classes += accuracy.classes[n].of_scale.count;
            non_finite += accuracy.classes[n].of_scale.non_finite;
        }
        EXPECT_EQ(classes, result.inputs);
        EXPECT_EQ(non_finite, accuracy.all.of_scale.non_finite);
        for (const LocusSummary& locus : accuracy.loci) {
            std::size_t steps = 0;
            for (const Step& step : locus.steps) steps += step.summary.of_scale.count;
            EXPECT_EQ(steps, locus.all.of_scale.count);
            ASSERT_EQ(locus.steps.size(), 13u);
            EXPECT_EQ(locus.steps.front().step, 1);
            EXPECT_EQ(locus.steps.back().step, 0);
            loci += steps;
        }
        EXPECT_EQ(loci, result.inputs - 300);
    }
}

TEST(bench, errors_are_those_that_the_formulas_have) {
    const SineFamily family;
    const GroupResult result = measured(family, options_for(family)).groups[0];
    const Accuracy &printed = result.accuracy[0], &sinc = result.accuracy[1];
    // On k = 0 the textbook's formula is 0/0; near it 1e-7/k.
    const Step& on = printed.loci[0].steps.back();
    EXPECT_EQ(on.summary.of_scale.non_finite, 6u);
    EXPECT_EQ(on.summary.of_scale.median, HUGE_VAL);
    EXPECT_EQ(sinc.loci[0].steps.back().summary.of_scale.non_finite, 0u);
    const Step& far = printed.loci[1].steps[0];
    EXPECT_LT(far.summary.of_scale.median, 1e-6);
    EXPECT_LT(sinc.all.of_limit.p99, 16);
    EXPECT_GT(far.limit, 0x1p-25);
    EXPECT_LT(far.limit, 1e-5);
    EXPECT_GT(printed.all.of_scale.non_finite_share(), 0);
    EXPECT_EQ(sinc.all.of_scale.non_finite, 0u);
}

TEST(bench, everything_but_times_is_the_same_on_any_number_of_jobs) {
    const SineFamily family;
    BenchOptions options = options_for(family);
    options.jobs = 1;
    const std::string one = bench_json(Report{measured(family, options)});
    options.jobs = 3;
    EXPECT_EQ(bench_json(Report{measured(family, options)}), one);
    options.seed = 5;
    EXPECT_NE(bench_json(Report{measured(family, options)}), one);
}

/// What is timed is every call that it says, on the record it says: none left out, none moved out of the
/// loop.
TEST(loop, makes_every_call_and_reads_every_record) {
    gpu::Device& device = testing::shared_device();
    const Case& c = find_case("smsr/case_09");
    const glsl::Sources sources = kernel_sources(testing::kernels_folder());
    const Sampler sampler(c, 5, std::make_shared<const EdgePool>(make_edge_pool(5)));
    const Records drawn = draw_records(c, sampler, sampler.fixed_count(), sampler.fixed_count() + 3000);
    std::vector<std::size_t> chosen(drawn.size());
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    const LoopBuffers buffers = upload_for_loops(device, c, drawn, chosen, 3);

    const auto words = device.read<std::uint32_t>(buffers.records);
    Records timed(c);
    ASSERT_EQ(words.size(), timed_records * timed.stride());
    std::vector<std::uint32_t> read(timed_records);
    for (std::uint32_t i = 0; i < timed_records; ++i) {
        const auto input = std::span(words).subspan(i * timed.stride(), word_count(c));
        timed.add(input, nullptr);
        for (const std::uint32_t word : input) read[i] += word;
    }
    const std::vector<std::uint32_t> called = evaluate(device, sources, c, timed).words;
    EXPECT_GT(std::ranges::count(called, 0u), 300);
    EXPECT_LT(std::ranges::count(called, 0u), timed_records - 300);
    for (const Repeated what : {Repeated::calls, Repeated::reads}) {
        Loop loop = make_loop(device, c, sources, what, buffers, 1e5);
        run_once(device, loop, buffers);
        const auto sums = device.read<std::uint32_t>(buffers.results);
        const std::vector<std::uint32_t>& values = what == Repeated::calls ? called : read;
        for (std::uint32_t thread = 0; thread < loop.threads; ++thread) {
            std::uint32_t sum = 0;
            for (std::uint32_t i = 0; i < evaluations_per_thread; ++i)
                sum += values[(thread + i * repeated_stride) % timed_records];
            ASSERT_EQ(sums[thread], sum)
                << "thread " << thread << (what == Repeated::calls ? "" : ", reading");
        }
    }
}

// How long that takes is no test's: a busy machine would fail it.
TEST(bench, times_are_given_per_class_and_decide_what_is_dominated) {
    const SineFamily family;
    BenchOptions options = options_for(family);
    options.rounds = 3;
    const GroupResult result = measured(family, options).groups[0];
    ASSERT_EQ(result.timings.size(), 2u);
    EXPECT_EQ(result.timings[0].inputs, "ordinary");
    for (const Timings& timings : result.timings) {
        ASSERT_EQ(timings.variants.size(), 4u);
        EXPECT_GT(timings.floor, 0);
        EXPECT_GE(timings.noise(), least_noise);
        for (const Timing& timing : timings.variants) {
            EXPECT_LE(timing.least, timing.median);
            EXPECT_LE(timing.median, timing.most);
        }
    }
    const Timings& last = result.timings.back();
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < 4; ++i)
            points.push_back({last.floor + last.variants[i].median,
                              error_at(result.accuracy[i].all.of_scale, ranks[rank])});
        EXPECT_EQ(result.dominated[rank], dominated_by(points, last.noise()));
    }
}

TEST(bench, the_distance_chart_has_every_variant_and_locus) {
    const SineFamily family;
    const GroupResult result = measured(family, options_for(family)).groups[0];
    const std::string svg = distance_chart(result);
    EXPECT_THAT(svg, AllOf(HasSubstr("k = 0"), HasSubstr("narrow"), HasSubstr("10⁻⁷"), HasSubstr(">on<")));
    for (const Variant& variant : result.group.variants)
        EXPECT_THAT(svg, HasSubstr(">" + variant.label + "<"));
    EXPECT_FALSE(std::regex_search(svg, std::regex("[\", ]-?(inf|nan)[\", ]")));
    // The median of sinc near k = 0: a bold line through 12 distances, in the first chart.
    const std::regex line(
        "<polyline points=\"([^\"]*)\" fill=\"none\" stroke=\"#cc6677\" stroke-width=\"1.9\"/>");
    std::smatch match;
    ASSERT_TRUE(std::regex_search(svg, match, line));
    const std::string points = match[1];
    EXPECT_EQ(count_of(points, ","), 12u);
    // One such line and a dash "on it" for each of three loci.
    EXPECT_EQ(count_of(svg, "stroke=\"#cc6677\" stroke-width=\"1.9\""), 6u);
    EXPECT_EQ(count_of(svg, "<polyline"), count_of(svg, "fill=\"none\""));
}

TEST(bench, the_pareto_chart_has_a_point_per_variant_and_rank) {
    const SineFamily family;
    BenchOptions options = options_for(family);
    EXPECT_EQ(pareto_chart(measured(family, options).groups[0]), "");
    options.rounds = 1;
    const GroupResult result = measured(family, options).groups[0];
    const std::string svg = pareto_chart(result);
    for (const Variant& variant : result.group.variants)
        EXPECT_EQ(count_of(svg, "<title>" + variant.label + ": "), 3u);
    std::size_t dominated = 0;
    for (const auto& of_rank : result.dominated)
        for (const auto& by : of_rank) dominated += by ? 1u : 0u;
    EXPECT_EQ(count_of(svg, ", dominated by "), dominated);
    EXPECT_EQ(count_of(svg, "fill=\"#fff\" stroke="), dominated);
}

TEST(bench, files_hold_what_was_found_and_json_has_no_infinity) {
    const SineFamily family;
    BenchOptions options = options_for(family);
    options.rounds = 1;
    const Bench made = measured(family, options);
    const auto out = family.folder().path() / "out";
    require_report_folder(out);
    write_report(out, Report{made});
    for (const char* name : {"report.html", "wave_integral_distance.svg", "wave_integral_pareto.svg"})
        EXPECT_TRUE(std::filesystem::is_regular_file(out / name)) << name;
    const nlohmann::json json = nlohmann::json::parse(read_file(out / "bench.json"));
    const nlohmann::json& printed = json["groups"][0]["variants"][0];
    EXPECT_EQ(printed["kernel"], "wave/printed");
    EXPECT_TRUE(printed["all"]["error"]["max"].is_null());
    EXPECT_TRUE(printed["loci"][0]["distances"].back()["error"]["median"].is_null());
    EXPECT_EQ(printed["loci"][0]["distances"].back()["distance"], 0);
    EXPECT_TRUE(printed["nanoseconds"]["ordinary"]["median"].is_number());
    EXPECT_THAT(read_file(out / "report.html"), AllOf(HasSubstr("<svg"), Not(HasSubstr("src="))));
    EXPECT_THAT(to_text(made, true), AllOf(HasSubstr("wave/integral, by class"), HasSubstr("inf")));
    EXPECT_THAT(error_of([&] { require_report_folder(out / "bench.json"); }), HasSubstr("bench.json"));
}

// A form that is held to its tolerance on a part of the quantity's domain is measured on all of it.
TEST(bench, runs_every_variant_on_the_domain_of_all) {
    const SineFamily family;
    std::vector<Case> cases = family.cases();
    cases[0].where = [](const Arguments& arguments) { return arguments.numbers[0] > 0.5; };
    const std::vector<const Case*> pointers{&cases[0], &cases[1]};
    const std::vector<Group> groups = group(pointers, std::array{Trigonometry::portable}, family.kernels());
    const GroupResult result = bench(groups, options_for(family)).groups[0];
    EXPECT_EQ(result.left_out, 0u);
    EXPECT_EQ(result.accuracy[0].loci[0].steps.back().summary.of_scale.non_finite, 6u);
}

TEST(bench, a_mode_that_changes_nothing_is_not_measured_twice) {
    const SineFamily family;
    const std::array modes{Trigonometry::portable, Trigonometry::built_in};
    const std::vector<Group> groups = group(family.pointers(), modes, family.kernels());
    ASSERT_EQ(groups.size(), 1u);
    EXPECT_EQ(groups[0].variants.size(), 4u);
}

TEST(bench, refuses_what_it_cannot_measure) {
    const SineFamily family;
    BenchOptions options = options_for(family);
    options.kernels = "/nowhere";
    EXPECT_THAT(error_of([&] { measured(family, options); }), HasSubstr("/nowhere"));
}

} // namespace
} // namespace gnomon::measure
