// Every kernel of the catalogue on the device, against its reference.
#include "casegen/check.h"

#include "tests/support/device.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace gnomon {
namespace {

CheckOptions modest() {
    CheckOptions options;
    options.kernels = testing::kernels_folder();
    options.pins = testing::fixtures_folder() / "pins";
    options.samples = 20000;
    options.device = testing::validated();
    options.jobs = 1;
    return options;
}

std::string explain(const CheckReport& report) {
    std::string text = fmt::format("{}: {}", to_string(report.verdict), report.message);
    if (report.worst)
        text += fmt::format("\n{}\ngot {}, want {}\n{}",
                            format_call(*report.kernel, report.worst->input,
                                        report.worst->mask ? &*report.worst->mask : nullptr),
                            format_result(*report.kernel, report.worst->got),
                            format_result(*report.kernel, report.worst->want),
                            replay_command(*report.kernel, *report.worst));
    return text;
}

class every_kernel : public ::testing::TestWithParam<const Case*> {};

TEST_P(every_kernel, agrees_with_its_reference) {
    CheckOptions options = modest();
    if (GetParam()->reference.truth) options.samples = default_samples(*GetParam()); // truths are slow
    const std::vector<CheckReport> reports = check(std::array{GetParam()}, options);
    ASSERT_EQ(reports.size(), 1u);
    EXPECT_EQ(reports[0].kernel, GetParam());
    EXPECT_GE(reports[0].samples, *options.samples);
    ASSERT_TRUE(reports[0].worst); // the slack is shown on a pass too
    if (!GetParam()->fails.empty()) {
        EXPECT_EQ(reports[0].verdict, Verdict::expected) << explain(reports[0]);
        return;
    }
    EXPECT_EQ(to_string(reports[0].verdict), std::string("pass")) << explain(reports[0]);
    EXPECT_EQ(reports[0].failures, 0u);
    EXPECT_LE(reports[0].worst->error, GetParam()->tolerance.amount);
    EXPECT_GT(reports[0].nanoseconds, 0);
}

TEST_P(every_kernel, gives_the_same_bits_in_every_run) {
    const Case& c = *GetParam();
    if (!c.fails.empty()) return; // what a division by zero gives need not be the same twice
    const auto pool = std::make_shared<const EdgePool>(make_edge_pool(1));
    const Sampler sampler(c, 1, pool);
    Records records(c), reversed(c);
    constexpr std::size_t count = 3000;
    for (std::size_t i = 0; i < count; ++i) {
        const Sampler::Sample sample = sampler.draw(i), last = sampler.draw(count - 1 - i);
        records.add(sample.words, sample.mask);
        reversed.add(last.words, last.mask);
    }
    const std::vector<std::uint32_t> once = testing::run_kernel(c.name, records);
    EXPECT_EQ(testing::run_kernel(c.name, records), once);
    // Nor does a sample's result depend on which others run beside it.
    const std::vector<std::uint32_t> backwards = testing::run_kernel(c.name, reversed);
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    for (std::size_t i = 0; i < count; ++i)
        ASSERT_TRUE(std::equal(once.begin() + static_cast<std::ptrdiff_t>(i * components),
                               once.begin() + static_cast<std::ptrdiff_t>((i + 1) * components),
                               backwards.begin() + static_cast<std::ptrdiff_t>((count - 1 - i) * components)))
            << c.name << " sample " << i;
}

INSTANTIATE_TEST_SUITE_P(catalogue, every_kernel, ::testing::ValuesIn(find_cases("")),
                         [](const auto& instance) { return function_name(*instance.param); });

bool same(const Finding& a, const Finding& b) {
    return a.index == b.index && a.input == b.input && a.mask == b.mask && a.got == b.got &&
           a.want == b.want && a.in_domain == b.in_domain && a.error == b.error;
}

/// All but the time.
bool same(const CheckReport& a, const CheckReport& b) {
    return a.kernel == b.kernel && a.verdict == b.verdict && a.seed == b.seed && a.samples == b.samples &&
           a.failures == b.failures && a.message == b.message && a.worst.has_value() == b.worst.has_value() &&
           (!a.worst || same(*a.worst, *b.worst));
}

TEST(check, reports_do_not_depend_on_the_number_of_jobs) {
    CheckOptions options = modest();
    options.samples = 3000;
    const std::vector<const Case*> cases = find_cases("");
    const std::vector<CheckReport> alone = check(cases, options);
    ASSERT_EQ(alone.size(), cases.size());
    for (const unsigned jobs : {1u, 3u, 0u}) {
        options.jobs = jobs;
        const std::vector<CheckReport> reports = check(cases, options);
        ASSERT_EQ(reports.size(), cases.size());
        for (std::size_t i = 0; i < cases.size(); ++i) {
            EXPECT_EQ(reports[i].kernel, cases[i]) << "not in the order of the cases";
            EXPECT_TRUE(same(reports[i], alone[i])) << jobs << " jobs\n"
                                                    << explain(reports[i]) << "\n"
                                                    << explain(alone[i]);
        }
    }
}

TEST(check, tells_how_many_samples_are_done) {
    CheckOptions options = modest();
    options.jobs = 2;
    std::vector<std::size_t> calls;
    const std::vector<const Case*> cases = find_cases("smsr/case_0?");
    std::size_t samples = 0;
    for (const CheckReport& report : check(cases, options, [&](std::size_t done) { calls.push_back(done); }))
        samples += report.samples;
    EXPECT_GE(calls.size(), cases.size());
    EXPECT_TRUE(std::ranges::is_sorted(calls));
    ASSERT_FALSE(calls.empty());
    EXPECT_EQ(calls.back(), samples);
}

TEST(check, a_seed_is_the_name_s_hash_unless_given) {
    CheckOptions options = modest();
    options.samples = 1;
    const std::array cases{&find_case("smsr/case_09")};
    EXPECT_EQ(check(cases, options)[0].seed, hash("smsr/case_09"));
    options.seed = 17;
    EXPECT_EQ(check(cases, options)[0].seed, 17u);
}

TEST(check, hostile_values_run_even_if_fewer_samples_are_asked_for) {
    CheckOptions options = modest();
    options.samples = 1;
    const std::array cases{&find_case("smsr/case_09")};
    EXPECT_GT(check(cases, options)[0].samples, 1000u);
}

TEST(check, more_samples_than_one_dispatch_takes) {
    CheckOptions options = modest();
    options.samples = (std::size_t{1} << 18) + 1000;
    const CheckReport report = check(std::array{&find_case("smsr/case_12")}, options)[0];
    EXPECT_EQ(report.verdict, Verdict::pass) << explain(report);
    EXPECT_EQ(report.samples, *options.samples);
}

} // namespace
} // namespace gnomon
