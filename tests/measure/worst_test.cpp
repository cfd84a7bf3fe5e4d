// The search for the worst inputs, on a kernel whose worst input is known.
#include "casegen/worst/file.h"

#include "casegen/check.h"
#include "casegen/csv.h"
#include "casegen/worst/change.h"
#include "runtime/files.h"
#include "tests/support/broken_kernels.h"
#include "tests/support/device.h"
#include "tests/support/sine_family.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>

namespace gnomon::worst {
namespace {

using testing::error_of;
using ::testing::HasSubstr;
using testing::SineFamily;

// On sinc's formula, but 1 % off.
constexpr const char* planted = "k,a,b\n0x1.000cp+2,-0x1.8p+0,0x1.4p+0\n";

SearchOptions options_for(const SineFamily& family, std::size_t evaluations) {
    SearchOptions options;
    options.kernels = family.kernels();
    options.evaluations = evaluations;
    options.device = testing::validated();
    return options;
}

float number(const Row& row, std::size_t word) { return std::bit_cast<float>(row.words[word]); }

TEST(worst, finds_the_one_place_where_a_kernel_is_wrong) {
    const SineFamily family;
    const Found found = search(family.named("wave/spiked"), options_for(family, 40000));
    EXPECT_EQ(found.evaluations, 40000u);
    ASSERT_FALSE(found.rows.empty());
    const Row& row = found.rows.front();
    EXPECT_FALSE(row.passes);
    EXPECT_GT(row.error, 1e4);
    EXPECT_GT(number(row, 0), 4.0f);
    EXPECT_LT(number(row, 0), 4.001f);
}

TEST(worst, climbs_beyond_what_random_inputs_show) {
    const SineFamily family;
    const Case& c = family.named("wave/sinc");
    CheckOptions check_options;
    check_options.kernels = family.kernels();
    check_options.samples = 8000;
    check_options.device = testing::validated();
    const CheckReport report = check(std::array{&c}, check_options).at(0);
    const Found found = search(c, options_for(family, 8000));
    ASSERT_TRUE(report.worst && !found.rows.empty());
    EXPECT_GT(found.rows.front().error, report.worst->error);
}

TEST(worst, is_the_same_on_any_number_of_jobs) {
    const SineFamily family;
    const Case& c = family.named("wave/spiked");
    SearchOptions options = options_for(family, 3000);
    options.jobs = 1;
    const std::string one = csv_of(c, search(c, options).rows);
    options.jobs = 3;
    EXPECT_EQ(csv_of(c, search(c, options).rows), one);
    options.seed = 9;
    EXPECT_NE(csv_of(c, search(c, options).rows), one);
}

TEST(worst, a_planted_input_survives_and_is_told_of) {
    const SineFamily family;
    const Case& c = family.named("wave/spiked");
    SearchOptions options = options_for(family, 200);
    options.worst = family.folder().write("spiked.csv", planted);
    const Found found = search(c, options);
    ASSERT_EQ(found.before.size(), 1u);
    EXPECT_GT(found.before[0].error, 1e4);
    ASSERT_FALSE(found.rows.empty());
    EXPECT_GE(found.rows[0].error, found.before[0].error);
    write_worst(options.worst, c, found);
    // Again, from what was written: nothing is lost, and nothing gets better.
    const Found again = search(c, options);
    ASSERT_EQ(again.before.size(), merged(found).size());
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        EXPECT_EQ(again.before[i].words, found.rows[i].words);
        EXPECT_EQ(again.before[i].error, found.rows[i].error);
        EXPECT_GE(again.rows[i].error, found.rows[i].error);
    }
}

TEST(worst, keeps_rows_that_a_mended_kernel_gets_right) {
    Found found;
    Row right;
    right.words = {1, 2, 3};
    found.before = {right};
    for (std::uint32_t i = 0; i < 4; ++i) found.rows.push_back({{i << 23, 0, 0}, nullptr, 9.0 - i, true});
    ASSERT_EQ(merged(found).size(), 5u);
    EXPECT_EQ(merged(found).back().words, right.words);
    found.before.push_back(found.rows[0]); // no row twice
    EXPECT_EQ(merged(found).size(), 5u);
    found.rows.resize(most_rows, found.rows[0]);
    EXPECT_EQ(merged(found).size(), most_rows);
}

TEST(worst, rows_are_of_different_octaves_in_an_order_of_their_own) {
    const SineFamily family;
    std::vector<Row> rows;
    Random random(3);
    for (int i = 0; i < 500; ++i) {
        const float k = std::ldexp(1.0f + static_cast<float>(random.unit()), random.between(-40, 2));
        rows.push_back({{std::bit_cast<std::uint32_t>(k), 0, 0}, nullptr, random.unit(), true});
    }
    Worst forwards(family.cases()[0]), backwards(family.cases()[0]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        forwards.add(rows[i]);
        backwards.add(rows[rows.size() - 1 - i]);
    }
    ASSERT_EQ(forwards.rows().size(), most_rows);
    std::set<std::uint32_t> octaves;
    for (std::size_t i = 0; i < most_rows; ++i) {
        EXPECT_EQ(forwards.rows()[i].words, backwards.rows()[i].words);
        if (i > 0) EXPECT_LE(forwards.rows()[i].error, forwards.rows()[i - 1].error);
        octaves.insert(forwards.rows()[i].words[0] >> 23);
    }
    EXPECT_EQ(octaves.size(), most_rows);
    Worst none(family.cases()[0]);
    none.add({{0, 0, 0}, nullptr, 0, true});
    EXPECT_TRUE(none.rows().empty());
}

TEST(worst, a_kernel_that_is_not_defended_is_searched_in_its_domain_only) {
    const SineFamily family;
    const Case& c = family.named("wave/printed");
    const Found found = search(c, options_for(family, 4000));
    ASSERT_FALSE(found.rows.empty());
    EXPECT_EQ(found.rows[0].error, HUGE_VAL); // 0/0 is on the locus k = 0
    for (const Row& row : found.rows) EXPECT_TRUE(in_domain(c, arguments(c, row.words, nullptr)));
}

TEST(worst, a_check_replays_the_file_before_all_others) {
    const SineFamily family;
    const Case& c = family.named("wave/spiked");
    const auto folder = family.folder().path() / "worst";
    std::filesystem::create_directories(folder / "wave");
    write_file(folder / "wave/spiked.csv", planted);
    CheckOptions options;
    options.kernels = family.kernels();
    options.samples = 1;
    options.device = testing::validated();
    EXPECT_EQ(check(std::array{&c}, options).at(0).verdict, Verdict::pass);
    options.worst = folder;
    const CheckReport report = check(std::array{&c}, options).at(0);
    EXPECT_EQ(report.verdict, Verdict::wrong);
    EXPECT_EQ(report.failures, 1u);
    ASSERT_TRUE(report.worst);
    EXPECT_EQ(report.worst->index, 0u);

    const auto pool = std::make_shared<const EdgePool>();
    const auto pins = family.folder().write("pins.csv", "k,a,b\n1,2,3\n");
    const Sampler both(c, 1, pool, pins, folder / "wave/spiked.csv"), none(c, 1, pool);
    EXPECT_EQ(both.pinned_count(), 2u);
    EXPECT_EQ(both.draw(0).words[0], std::bit_cast<std::uint32_t>(0x1.000cp+2f));
    EXPECT_EQ(both.draw(1).words[0], std::bit_cast<std::uint32_t>(1.0f));
    for (std::size_t i = 0; i < none.fixed_count() + 200; ++i) // what follows is what it was
        ASSERT_EQ(both.draw(i + 2).words, none.draw(i).words) << i;
}

TEST(worst, a_malformed_file_is_one_clear_line) {
    const SineFamily family;
    SearchOptions options = options_for(family, 1);
    const Case& c = family.named("wave/sinc");
    options.worst = family.folder().write("bad.csv", "k,a\n1,2\n");
    EXPECT_THAT(error_of([&] { search(c, options); }), AllOf(HasSubstr("bad.csv"), HasSubstr("\"b\"")));
    options.worst = family.folder().write("bad.csv", "k,a,b\n1,2,x\n");
    EXPECT_THAT(error_of([&] { search(c, options); }), HasSubstr("bad.csv: row 1, column b"));
    EXPECT_THAT(error_of([&] { require_worst_file(family.folder().path() / "bad.csv" / "x.csv"); }),
                HasSubstr("bad.csv"));
}

TEST(worst, a_broken_kernel_over_masks_is_found_and_its_file_read_again) {
    const testing::BrokenKernels broken("off_by_one");
    const Case& c = find_case("revectorize/walk");
    SearchOptions options;
    options.kernels = broken.folder();
    options.evaluations = 2000;
    options.device = testing::validated();
    const Found found = search(c, options);
    ASSERT_FALSE(found.rows.empty());
    EXPECT_FALSE(found.rows[0].passes);
    const std::vector<CsvInput> inputs = read_inputs(c, parse_csv(csv_of(c, found.rows), "rows"));
    ASSERT_EQ(inputs.size(), found.rows.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        EXPECT_EQ(inputs[i].words, found.rows[i].words);
        EXPECT_TRUE(inputs[i].mask == *found.rows[i].mask);
    }
}

TEST(worst, changes_are_small_ones_and_the_same_for_the_same_numbers) {
    const SineFamily family;
    const Case& c = family.cases()[0];
    const std::vector<std::uint32_t> start{std::bit_cast<std::uint32_t>(1.5f),
                                           std::bit_cast<std::uint32_t>(-2.0f),
                                           std::bit_cast<std::uint32_t>(2.5f)};
    const std::vector<std::uint32_t> other{0, 0, 0};
    int changed = 0, near = 0, inside = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
        std::vector<std::uint32_t> a = start, b = start;
        Random one(1, i), two(1, i);
        change(c, one, a, other);
        change(c, two, b, other);
        ASSERT_EQ(a, b);
        if (a == start) continue;
        ++changed;
        near += std::abs(std::bit_cast<float>(a[0]) - 1.5f) < 0.01f ? 1 : 0;
        inside += in_domain(c, arguments(c, a, nullptr)) ? 1 : 0;
    }
    EXPECT_GT(changed, 3500);
    EXPECT_GT(near, 1500);
    EXPECT_GT(inside, 1500);
}

} // namespace
} // namespace gnomon::worst
