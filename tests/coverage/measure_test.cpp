// What counters in kernels count: by hand where inputs are few, and on every kernel that there are no other
// results with them than without.
#include "casegen/coverage/measure.h"

#include "casegen/check_inputs.h"
#include "casegen/coverage/report.h"
#include "runtime/files.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/device.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>

namespace gnomon::coverage {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

glsl::Sources sources() { return kernel_sources(testing::kernels_folder()); }

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }
std::uint32_t bits(int value) { return std::bit_cast<std::uint32_t>(value); }

Records records_of(const Case& c, std::initializer_list<std::vector<std::uint32_t>> inputs) {
    Records records(c);
    for (const std::vector<std::uint32_t>& input : inputs) records.add(input, nullptr);
    return records;
}

FileCoverage file_of(const KernelRun& run, const std::string& name) {
    for (FileCoverage& file : merge(sources(), std::span(&run, 1)))
        if (file.name == name) return file;
    ADD_FAILURE() << run.kernel->name << " does not include " << name;
    return {};
}

std::vector<std::uint64_t> counts(const FileCoverage& file, const std::string& condition) {
    std::vector<std::uint64_t> found;
    for (const Branch& branch : file.points.branches)
        if (branch.text == condition)
            for (const Branch::Outcome& outcome : branch.outcomes)
                found.push_back(file.hits[outcome.counter].all());
    return found;
}

// revectorize/edge_type on (1, 1), (1, 0), (0, 1), twice (-1, 0):
//     if (minus && plus) return 1;      minus 2 of 5, then plus 1 of these 2
//     if (!minus && !plus) return -1;   asked of 4: !minus 3, then !plus 2 of these 3
//     return 0;                         the other 2
TEST(coverage_counts, are_what_a_hand_computes) {
    const Case& c = find_case("revectorize/edge_type");
    const Records records = records_of(c, {{bits(1), bits(1)},
                                           {bits(1), bits(0)},
                                           {bits(0), bits(1)},
                                           {bits(-1), bits(0)},
                                           {bits(-1), bits(0)}});
    const KernelRun run = measure_on(testing::shared_device(), sources(), c, records);
    EXPECT_EQ(run.trouble, "");
    EXPECT_EQ(run.fixtures, 5u);
    const FileCoverage file = file_of(run, "revectorize/edge_type.glsl");
    EXPECT_THAT(counts(file, "minus"), ElementsAre(2u, 3u));
    EXPECT_THAT(counts(file, "plus"), ElementsAre(1u, 1u));
    EXPECT_THAT(counts(file, "!minus"), ElementsAre(3u, 1u));
    EXPECT_THAT(counts(file, "!plus"), ElementsAre(2u, 1u));
    ASSERT_EQ(file.points.functions.size(), 1u);
    EXPECT_EQ(file.hits[file.points.functions[0].counter].fixtures, 5u);
    const std::map<int, Hits> lines = line_hits(file);
    std::vector<std::uint64_t> by_line;
    for (const auto& [line, hits] : lines) by_line.push_back(hits.all());
    EXPECT_THAT(by_line, ElementsAre(5u, 5u, 5u, 5u, 4u, 2u)); // signature, minus, plus, if, if, return
    EXPECT_EQ(totals(file).branches.all, 8u);
    EXPECT_TRUE(gaps(file, true).empty());
}

// A run along x, lit above shadow, whose end is shadow too: the walk's first turn finds a texel that shares
// the side, its second one the end.
TEST(coverage_counts, turns_of_a_loop_and_calls_through_the_map) {
    const Case& c = find_case("revectorize/walk");
    Mask mask(3, 2);
    mask.set(2, 0, false);
    for (int x = 0; x < 3; ++x) mask.set(x, 1, false);
    Records records(c);
    const std::vector<std::uint32_t> texel{0, 0}, sides{0, 2}, heading{1, 0};
    std::vector<std::uint32_t> words;
    for (const auto& part : {texel, sides, heading}) words.insert(words.end(), part.begin(), part.end());
    records.add(words, &mask);
    const KernelRun run = measure_on(testing::shared_device(), sources(), c, records);
    EXPECT_EQ(run.trouble, "");
    const FileCoverage file = file_of(run, "revectorize/walk.glsl");
    EXPECT_THAT(counts(file, "k <= LONGEST_WALK"), ElementsAre(1u, 0u)); // both turns of the one input
    EXPECT_THAT(counts(file, "lit(reached) != start"), ElementsAre(1u, 1u));
    EXPECT_THAT(counts(file, "(wanted & MINUS) != 0u"), ElementsAre(0u, 1u));
    EXPECT_THAT(counts(file, "lit(reached - across) != start"), ElementsAre(0u, 0u)); // never asked
    EXPECT_THAT(counts(file, "lit(reached + across) != start"), ElementsAre(1u, 0u));
    EXPECT_THAT(counts(file, "!shares"), ElementsAre(0u, 1u));
    EXPECT_THAT(counts(file, "heading.x != 0"), ElementsAre(1u, 0u));
}

TEST(coverage_counts, name_a_branch_that_is_never_taken) {
    const Case& c = find_case("smsr/case_09"); // 1.0 - p.y < along_x ? 0.0 : 1.0
    const Records records =
        records_of(c, {{bits(0.5f), bits(0.5f), bits(0.25f)}, {bits(0.5f), bits(0.25f), bits(0.5f)}});
    const KernelRun run = measure_on(testing::shared_device(), sources(), c, records);
    const FileCoverage file = file_of(run, "smsr/case_09.glsl");
    EXPECT_THAT(counts(file, "1.0 - p.y < along_x"), ElementsAre(0u, 2u));
    ASSERT_EQ(gaps(file, true).size(), 1u);
    EXPECT_EQ(gaps(file, true)[0].what, "`1.0 - p.y < along_x` was never true");
    EXPECT_EQ(totals(file).branches.all, 1u);
    EXPECT_EQ(totals(file).branches.of, 2u);
    EXPECT_EQ(totals(file).lines.all, totals(file).lines.of);
}

TEST(coverage_counts, say_so_if_counters_change_results) {
    const Case& c = find_case("smsr/case_09");
    const Records records =
        records_of(c, {{bits(0.5f), bits(0.5f), bits(0.25f)}, {bits(0.5f), bits(0.75f), bits(0.5f)}});
    const auto wrong = [](std::string_view text, std::size_t first) {
        Instrumented done = instrument(text, first);
        const std::size_t at = done.text.find("1.0 - p.y < along_x");
        if (at != done.text.npos) done.text.replace(at, 19, "1.0 - p.y > along_x");
        return done;
    };
    const KernelRun run = measure_on(testing::shared_device(), sources(), c, records, wrong);
    EXPECT_THAT(run.trouble, HasSubstr("gives 0x0p+0 with counters and 0x1p+0 without"));
    EXPECT_THAT(run.trouble, HasSubstr("smsr_case_09(p = vec2(0x1p-1, 0x1p-1)"));
    EXPECT_EQ(measure_on(testing::shared_device(), sources(), c, records).trouble, "");
}

TEST(coverage_counts, are_the_same_on_any_number_of_jobs) {
    Options options;
    options.check.kernels = testing::kernels_folder();
    options.check.device = testing::validated();
    options.check.samples = 500;
    const std::vector<const Case*> cases = find_cases("rbsm/filter/");
    options.check.jobs = 1;
    const std::string one = to_json(measure(cases, options));
    options.check.jobs = 3;
    EXPECT_EQ(to_json(measure(cases, options)), one);
    options.only_fixtures = true;
    const Coverage fixtures = measure(cases, options);
    for (const FileCoverage& file : fixtures.files)
        for (const Hits& hits : file.hits) EXPECT_EQ(hits.samples, 0u);
    EXPECT_NE(to_json(fixtures), one);
}

TEST(coverage_counts, go_on_past_a_kernel_that_does_not_compile) {
    const testing::ChangedKernels kernels("smsr/case_09.glsl", "along_x ?", "along_z ?");
    Options options;
    options.check.kernels = kernels.folder();
    options.check.device = testing::validated();
    options.check.jobs = 1;
    options.check.samples = 100;
    const Coverage coverage = measure(find_cases("smsr/case_*"), options);
    for (const KernelRun& run : coverage.kernels) // some include case 9
        EXPECT_EQ(!run.trouble.empty(), run.trouble.find("along_z") != std::string::npos)
            << run.kernel->name << run.trouble;
    EXPECT_GT(coverage.files.size(), 5u);
    EXPECT_THAT(to_text(coverage, false), HasSubstr("FAIL smsr/case_09: kernels/smsr/case_09.glsl:4: "));
}

TEST(coverage_counts, compile_in_every_kernel) {
    const glsl::Sources plain = sources();
    for (const Case* c : find_cases("")) {
        glsl::Sources with = plain;
        std::size_t counters = 0;
        for (const std::string& name : glsl::included_files(plain, standalone_source(*c))) {
            const Instrumented done = instrument(read_file(plain.root / name), counters);
            counters += done.counters + done.counters % 2;
            with.overlaid[name] = done.text;
        }
        EXPECT_GT(counters, 0u) << c->name;
        EXPECT_NO_THROW(compile_standalone(*c, with, counters_around(counters, {0, counters}))) << c->name;
    }
}

// No result changes. The quadratures are left to gnomon coverage, which asks the same of every kernel and
// input: a driver takes seconds for each of them.
TEST(coverage_counts, change_no_kernel) {
    setenv("GALLIVM_PERF", "nopt", 0); // the same bits in half the time
    std::vector<const Case*> cases;
    for (const Case* c : find_cases("")) {
        const bool quick =
            std::ranges::any_of(std::array{"integral/sinc/", "integral/fit/", "integral/elementary/"},
                                [&](const char* family) { return c->name.starts_with(family); });
        if (quick || !c->name.starts_with("integral/")) cases.push_back(c);
    }
    Options options;
    options.check.kernels = testing::kernels_folder();
    options.check.pins = testing::fixtures_folder() / "pins";
    options.check.worst = testing::fixtures_folder() / "worst";
    options.check.device.time_limit = 60;
    options.only_fixtures = true;
    const Coverage coverage = measure(cases, options);
    ASSERT_EQ(coverage.kernels.size(), cases.size());
    for (const KernelRun& run : coverage.kernels) {
        EXPECT_EQ(run.trouble, "") << run.kernel->name;
        EXPECT_EQ(run.left_out, 0u) << run.kernel->name;
        EXPECT_GT(run.fixtures, 0u) << run.kernel->name;
        EXPECT_TRUE(run.hits.contains(run.kernel->name + ".glsl")) << run.kernel->name;
    }
    const Totals sum = totals(coverage);
    EXPECT_GT(sum.branches.of, 500u);
    EXPECT_EQ(sum.lines.fixtures, sum.lines.all);
}

// exact_theta_4/b is rounded otherwise with some counters: they are left out of it, and the others count.
TEST(coverage_counts, leave_out_what_a_driver_rounds_otherwise_for) {
    const Case& c = find_case("integral/exact_theta_4/b");
    const auto pool = std::make_shared<const EdgePool>(make_edge_pool(1));
    const Records records = draw_records(c, make_sampler(c, {}, pool, {}), 0, 2000);
    const KernelRun run = measure_on(testing::shared_device(), sources(), c, records);
    EXPECT_EQ(run.trouble, "");
    EXPECT_LT(run.left_out, 20u);
    EXPECT_EQ(file_of(run, "integral/exact_theta_4/b.glsl").hits[0].fixtures, 2000u);
}

} // namespace
} // namespace gnomon::coverage
