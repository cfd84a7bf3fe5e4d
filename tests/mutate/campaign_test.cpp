// Mutants before the checks that should notice them: right kernels kill theirs, a check that lets all pass
// kills none, and what the list of equivalents says must be so.
#include "casegen/catalogue.h"
#include "casegen/mutate/campaign.h"
#include "casegen/standalone.h"
#include "tests/support/environment.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace gnomon::mutate {
namespace {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

CampaignOptions options_for(const std::filesystem::path& kernels = testing::kernels_folder()) {
    CampaignOptions options;
    options.examiner.sources = glsl::frozen(kernel_sources(kernels));
    options.examiner.pins = testing::fixtures_folder() / "pins";
    options.examiner.worst = testing::fixtures_folder() / "worst";
    options.jobs = 2;
    return options;
}

CampaignReport run(const std::vector<const Case*>& cases, const CampaignOptions& options) {
    return run_campaign(cases, options);
}

std::string survivors(const CampaignReport& report) {
    std::string text;
    for (const MutantReport& each : report.mutants)
        if (each.fate == Fate::survived)
            text += fmt::format("{} {}: {} -> {} ({})\n", each.mutant.file, each.mutant.mutation.line,
                                each.mutant.before, each.mutant.mutation.after, each.how);
    return text;
}

TEST(mutation_campaign, finds_every_change_of_small_kernels) {
    CampaignOptions options = options_for();
    options.equivalents = load_equivalents(testing::fixtures_folder() / "mutants/equivalent.json");
    const CampaignReport report =
        run({&find_case("smsr/case_09"), &find_case("smsr/case_10"), &find_case("revectorize/edge_type")},
            options);
    EXPECT_EQ(survivors(report), "");
    EXPECT_THAT(report.complaints, IsEmpty());
    ASSERT_EQ(report.kernels.size(), 3u);
    EXPECT_GT(report.kernels[0].killed, 15u);
    for (const KernelCount& count : report.kernels) {
        EXPECT_EQ(count.score(), 1) << count.kernel->name;
        EXPECT_EQ(count.killed + count.survived + count.equivalent + count.tolerated + count.same_code +
                      count.stillborn,
                  count.total());
    }
    EXPECT_EQ(report.all.not_run, 0u);
    EXPECT_FALSE(report.interrupted);
}

TEST(mutation_campaign, asks_nothing_of_what_is_listed_of_kernels_that_are_only_included) {
    CampaignOptions options = options_for();
    options.equivalents = load_equivalents(testing::fixtures_folder() / "mutants/equivalent.json");
    ASSERT_THAT(options.equivalents, Contains(Field(&Equivalent::file, "rsmss/case_04.glsl")));
    options.limit = 1;
    EXPECT_THAT(run({&find_case("rsmss/visibility")}, options).complaints, IsEmpty());
}

/// A kernel of its own in a folder of its own.
class own_kernel : public ::testing::Test {
protected:
    own_kernel() { std::filesystem::create_directories(folder_.path() / "own"); }

    /// Allowed to be `allowed` away.
    const Case& own(const std::string& text, double allowed = 0) {
        folder_.write("own/kernel.glsl", text);
        kernel_ = Case();
        kernel_.name = "own/kernel";
        kernel_.reference = [](double a) { return a < 0.5 ? 0.0 : 1.0; };
        kernel_.parameters = {{"a", {0, 1, {}}, "1", "an input"}};
        kernel_.result = {-1e30, 1e30, "1", "a step"};
        kernel_.tolerance = absolute(allowed);
        return kernel_;
    }
    CampaignOptions options() const {
        CampaignOptions options = options_for(folder_.path());
        options.examiner.samples = 4096;
        return options;
    }
    std::string id_of(const std::string& before, const std::string& after) const {
        const std::vector<const Case*> cases{&kernel_};
        for (const Mutant& mutant : mutants_of(cases, kernel_sources(folder_.path()), all_operators()))
            if (mutant.before == before && mutant.mutation.after == after) return mutant.id;
        ADD_FAILURE() << before << " -> " << after;
        return {};
    }

    testing::TemporaryFolder folder_;
    Case kernel_;
};

constexpr const char* step = "float own_kernel(float a) { return a < 0.5 ? 0.0 : 1.0; }\n";

TEST_F(own_kernel, that_anything_goes_for_kills_nothing_that_is_a_number) {
    const CampaignReport weak = run({&own(step, 1e9)}, options());
    EXPECT_EQ(weak.all.killed, 0u);
    EXPECT_GT(weak.all.survived, 10u);
    EXPECT_EQ(weak.all.score(), 0);
    EXPECT_FALSE(weak.good());
    const CampaignReport strict = run({&own(step)}, options());
    EXPECT_EQ(survivors(strict), "");
    EXPECT_GT(strict.all.killed, 10u);
    EXPECT_TRUE(strict.good());
}

TEST_F(own_kernel, kills_by_name_and_call) {
    const Case& c = own(step);
    CampaignOptions one = options();
    one.only = id_of("<", "<=");
    const CampaignReport report = run({&c}, one);
    ASSERT_EQ(report.mutants.size(), 1u);
    EXPECT_EQ(report.mutants[0].fate, Fate::killed);
    EXPECT_EQ(report.mutants[0].by, &c);
    EXPECT_THAT(report.mutants[0].how, HasSubstr("own_kernel(a = 0x1p-1): got 0x0p+0, want 0x1p+0"));
    one.only = "none";
    EXPECT_THAT(testing::error_of([&] { run({&c}, one); }), HasSubstr("none"));
}

TEST_F(own_kernel, listed_as_equivalent_must_survive_and_be_there) {
    const Case& c = own("float own_kernel(float a) {\n    float b = max(a, a - 1.0);\n"
                        "    return b < 0.5 ? 0.0 : 1.0;\n}\n");
    const std::string same = id_of("max(a, a - 1.0)", "(a)"), wrong = id_of("<", "<=");
    CampaignOptions listed = options();
    const CampaignReport unlisted_report = run({&c}, listed);
    EXPECT_THAT(survivors(unlisted_report),
                HasSubstr("max(a, a - 1.0) -> (a) (own/kernel: the same results"));

    for (const std::string& id : {same, wrong, std::string("0123456789")})
        listed.equivalents.push_back({id, "own/kernel.glsl", "a change", false, "a reason"});
    const CampaignReport report = run({&c}, listed);
    EXPECT_EQ(report.all.equivalent, 1u);
    EXPECT_EQ(report.all.survived + 1, unlisted_report.all.survived);
    EXPECT_THAT(report.complaints,
                ElementsAre(HasSubstr("0123456789 is listed as equivalent, but there is no such mutant"),
                            HasSubstr(wrong + " is not equivalent: it is killed by own/kernel")));
    EXPECT_FALSE(report.good());
}

TEST_F(own_kernel, that_is_wrong_already_is_a_complaint) {
    const CampaignReport report =
        run({&own("float own_kernel(float a) { return a <= 0.5 ? 0.0 : 1.0; }\n")}, options());
    EXPECT_THAT(report.complaints, ElementsAre(HasSubstr("own/kernel fails its check unchanged")));
    EXPECT_EQ(report.all.not_run, report.all.total());
    EXPECT_FALSE(report.good());
}

TEST_F(own_kernel, tells_what_does_not_compile_and_what_compiles_to_the_same) {
    const Case& c =
        own("float own_kernel(float a) {\n    vec2 v = vec2(a, 1.0).xy;\n    float unused = 3.0;\n"
            "    return v.x < 0.5 ? 0.0 : 1.0;\n}\n");
    const CampaignReport report = run({&c}, options());
    std::map<std::string, Fate> fates;
    for (const MutantReport& each : report.mutants)
        fates[each.mutant.before + " -> " + each.mutant.mutation.after] = each.fate;
    EXPECT_EQ(fates.at("3.0 -> 4.0"), Fate::same_code);
    EXPECT_EQ(fates.at("xy -> zw"), Fate::stillborn);
    EXPECT_EQ(fates.at("xy -> yx"), Fate::killed);
    EXPECT_EQ(fates.at("< -> <="), Fate::killed);
    EXPECT_EQ(report.all.not_run, 0u);
}

TEST_F(own_kernel, without_an_end_is_killed_by_the_limit) {
    // Right as it is; counting the other way its outer loop goes on for good.
    const Case& c = own("float own_kernel(float a) {\n    float s = a;\n    int i = 0;\n    while (i < 2) {\n"
                        "        for (int k = 0; k < 100; ++k)\n"
                        "            if (i > 2 || i < 0) s = fract(sin(s) + exp(s) + cos(s));\n"
                        "        ++i;\n    }\n"
                        "    return a < 0.5 ? 0.0 : s == 2.0 ? 0.5 : 1.0;\n}\n");
    CampaignOptions one = options();
    one.only = id_of("++", "--");
    one.examiner.device.time_limit = 0.5;
    const CampaignReport report = run({&c}, one);
    ASSERT_EQ(report.mutants.size(), 1u);
    EXPECT_EQ(report.mutants[0].fate, Fate::killed) << report.mutants[0].how;
    EXPECT_THAT(report.mutants[0].how, HasSubstr("0.5 s"));
}

TEST_F(own_kernel, interrupted_tells_what_was_done) {
    const std::atomic<bool> stop = true;
    CampaignOptions stopped = options();
    stopped.stop = &stop;
    const CampaignReport report = run({&own(step)}, stopped);
    EXPECT_TRUE(report.interrupted);
    EXPECT_EQ(report.all.not_run, report.all.total());
    EXPECT_FALSE(report.good()) << "what was not run may survive";
}

TEST(mutants, of_shared_files_count_for_all_who_include_them) {
    const glsl::Sources sources = kernel_sources(testing::kernels_folder());
    const std::vector<const Case*> cases{&find_case("adjacency/shadowed_0")};
    bool shared = false, stale = false;
    for (const Mutant& mutant : mutants_of(cases, sources, all_operators())) {
        if (mutant.file != "adjacency/polygon.glslh") continue;
        shared = true;
        EXPECT_THAT(mutant.users, ::testing::Contains(&find_case("adjacency/one_ring")));
    }
    const std::vector<const Case*> composed{&find_case("smsr/visibility")};
    for (const Mutant& mutant : mutants_of(composed, sources, all_operators()))
        if (mutant.mutation.by == Operator::stale && mutant.file == "smsr/case_09.glsl") {
            stale = true;
            EXPECT_THAT(mutant.users, ElementsAre(&find_case("smsr/visibility")));
        }
    EXPECT_TRUE(shared);
    EXPECT_TRUE(stale);
}

TEST(mutants, are_chosen_alike_by_a_limit) {
    CampaignOptions options = options_for();
    options.limit = 12;
    options.operators = {Operator::comparison, Operator::result, Operator::stale};
    const std::vector<const Case*> cases{&find_case("smsr/case_08"), &find_case("smsr/decision")};
    const CampaignReport first = run(cases, options);
    options.jobs = 1;
    const CampaignReport second = run(cases, options);
    ASSERT_EQ(first.mutants.size(), 12u);
    for (std::size_t i = 0; i < 12; ++i) {
        EXPECT_EQ(first.mutants[i].mutant.id, second.mutants[i].mutant.id);
        EXPECT_EQ(first.mutants[i].fate, second.mutants[i].fate);
        EXPECT_EQ(first.mutants[i].how, second.mutants[i].how);
    }
}

} // namespace
} // namespace gnomon::mutate
