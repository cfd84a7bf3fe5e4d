// gnomon census.
#include "casegen/catalogue.h"
#include "casegen/mask_families.h"
#include "casegen/reference/revectorize.h"
#include "runtime/files.h"
#include "tests/pipeline/cli.h"
#include "tests/support/environment.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace gnomon::testing {
namespace {

using ::testing::HasSubstr;

const Arguments small{"--size", "160x120"};

double sum_of(const nlohmann::json& shares) {
    double sum = 0;
    for (const auto& [number, share] : shares.items()) sum += share.get<double>();
    return sum;
}

class Census : public ::testing::TestWithParam<std::string> {};

TEST_P(Census, OfAMaskCountsEveryTexel) {
    const TemporaryFolder folder;
    const std::string json = folder.path() / "c.json";
    const Family& family = technique_family(GetParam());
    const Case& number = *find_kernel(family, "number");
    Arguments masks;
    std::vector<std::map<std::string, std::uint64_t>> expected;
    for (const NamedMask& named : mask_corpus(5, 1, 24)) {
        Mask mask = named.mask;
        mask.outside = Outside::shadow;
        const auto& counts = expected.emplace_back();
        for (int y = 0; y < mask.height; ++y)
            for (int x = 0; x < mask.width; ++x) {
                gnomon::Arguments with;
                with.mask = &mask;
                with.numbers[0] = x;
                with.numbers[1] = y;
                ++expected.back()[std::to_string(static_cast<int>(number.reference.call(with)[0]))];
            }
        EXPECT_FALSE(counts.empty());
        masks.push_back(folder.write(fmt::format("m{}.txt", expected.size()), format_mask(mask, '\n')));
    }
    run_well(Arguments{"census", "--technique", GetParam(), "--outside", "shadow", "--json", json} + masks);
    const nlohmann::json found = read_json(json);
    ASSERT_EQ(found["censuses"].size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
        EXPECT_EQ(found["censuses"][i]["counts"], nlohmann::json(expected[i])) << i;
    EXPECT_EQ(found["shares"][family.name].size(), numbered_cases(family).size());
    EXPECT_NEAR(sum_of(found["shares"][family.name]), 1, 1e-9);

    // Mean and deviation of one case, worked out here.
    const std::string first = std::to_string(numbered_cases(family).front()->number);
    std::vector<double> shares;
    for (const auto& counts : expected) {
        double all = 0;
        for (const auto& [n, count] : counts) all += n == "0" ? 0 : static_cast<double>(count);
        const auto of_first = counts.find(first);
        if (all > 0)
            shares.push_back((of_first == counts.end() ? 0 : static_cast<double>(of_first->second)) / all);
    }
    double mean = 0, squares = 0;
    for (const double share : shares) mean += share / static_cast<double>(shares.size());
    for (const double share : shares) squares += (share - mean) * (share - mean);
    EXPECT_NEAR(found["shares"][family.name][first].get<double>(), mean, 1e-12);
    EXPECT_NEAR(found["cases"][0]["deviation"].get<double>(),
                std::sqrt(squares / static_cast<double>(shares.size() - 1)), 1e-12);
}

TEST_P(Census, OfAViewIsTheSameEachTime) {
    const TemporaryFolder folder;
    const std::string first = folder.path() / "1.json", second = folder.path() / "2.json";
    for (const std::string& json : {first, second})
        run_well(Arguments{"census", "--technique", GetParam(), "--shadow-map", "64,256", "--lights", "3",
                           "--json", json} +
                 small);
    const nlohmann::json found = read_json(first);
    EXPECT_EQ(found, read_json(second));
    EXPECT_EQ(found["technique"], GetParam());
    ASSERT_EQ(found["censuses"].size(), 6u);
    EXPECT_EQ(found["censuses"][0]["shadow_map"], 64);
    EXPECT_EQ(found["censuses"][5]["shadow_map"], 256);
    EXPECT_NE(found["censuses"][0]["light"], found["censuses"][1]["light"]);
    EXPECT_EQ(found["censuses"][0]["light"], found["censuses"][3]["light"]);
    EXPECT_NEAR(sum_of(found["shares"][technique_family(GetParam()).name]), 1, 1e-9);
    for (const auto& c : found["cases"]) EXPECT_GE(c["deviation"].get<double>(), 0);
}

INSTANTIATE_TEST_SUITE_P(Of, Census, ::testing::ValuesIn(numbered_techniques()));

TEST(CensusTable, ShowsEveryCase) {
    const Ran ran = run_well(Arguments{"census"} + small);
    EXPECT_THAT(ran.out, HasSubstr("smsr/case_12"));
    EXPECT_THAT(ran.out, HasSubstr("share"));
    EXPECT_THAT(ran.out, ::testing::Not(HasSubstr("deviation"))) << "of one view there is none";
    EXPECT_THAT(ran.out, HasSubstr("pixels are of a case"));
}

TEST(CensusTable, OfAnEmptyMaskIsNought) {
    const TemporaryFolder folder;
    const Ran ran = run_well({"census", folder.write("m.txt", "...\n...\n")});
    EXPECT_THAT(ran.out, HasSubstr("0 of 6 texels are of a case"));
    EXPECT_THAT(ran.out, HasSubstr("0.000%"));
}

TEST(CensusOptions, AreRefusedWhenBad) {
    const TemporaryFolder folder;
    const std::string json = folder.path() / "c.json", mask = folder.write("m.txt", "..\n.#\n");
    const std::vector<std::pair<Arguments, std::string>> all{
        {{"--technique", "nsm"}, "--technique"},
        {{"--technique", "wrong"}, "--technique"},
        {{folder.path() / "absent.png"}, "absent.png"},
        {{folder.path() / "absent.obj"}, "absent.obj"},
        {{folder.write("bad.txt", "..\n.x\n")}, "bad.txt"},
        {{folder.write("noise.png", "noise")}, "noise.png"},
        {{folder.write("m.xyz", "..\n")}, "unknown kind"},
        {{""}, "empty"},
        {{mask, "--lights", "2"}, "--lights"},
        {{mask, "--outside", "dark"}, "--outside"},
        {{"--lights", "0"}, "--lights"},
        {{"--lights", "many"}, "--lights"},
        {{"--lights", "2", "--light-direction", "0,-1,0"}, "--light"},
        {{"--shadow-map", "0"}, "--shadow-map"},
        {{"--shadow-map", "64,x"}, "--shadow-map"},
        {{"--shadow-map", "64,99999"}, "--shadow-map"},
        {{"--size", "0x5"}, "--size"},
        {{"--json", folder.path()}, "folder"},
        {{"--json", folder.path() / "absent" / "c.json"}, "absent"},
        {{"--json", ""}, "--json"},
    };
    for (const auto& [options, what] : all) {
        const bool has_json = std::ranges::find(options, "--json") != options.end();
        expect_refused(folder,
                       Arguments{"census"} + (has_json ? Arguments{} : Arguments{"--json", json}) + options,
                       what);
    }
}

TEST(CensusAtlas, ShowsTheSharesAtEveryCase) {
    const TemporaryFolder folder;
    const std::string mask = folder.write("mask.txt", "....\n.##.\n.##.\n....\n");
    run_well({"census", mask, "--technique", "rsmss", "--atlas", folder.path() / "atlas"});
    const std::string page = read_file(folder.path() / "atlas" / "index.html");
    EXPECT_THAT(page, ::testing::HasSubstr("this census"));
    EXPECT_THAT(page, ::testing::HasSubstr("rsmss/case_27"));
    expect_refused(folder, {"census", mask, "--atlas", folder.write("taken", "")}, "taken");
}

TEST(CensusAtlas, SaysWhenAKernelFails) {
    const TemporaryFolder folder;
    std::filesystem::copy(kernels_folder(), folder.path() / "kernels",
                          std::filesystem::copy_options::recursive);
    folder.write("kernels/smsr/case_09.glsl", "float smsr_case_09(vec2 p, float along_x) { return 0.5; }\n");
    const std::string mask = folder.write("mask.txt", ".#\n");
    const Ran ran = run_gnomon({"census", mask, "--kernels", folder.path() / "kernels", "--technique",
                                "rsmss", "--atlas", folder.path() / "atlas"});
    EXPECT_EQ(ran.exit_code, 1);
    EXPECT_THAT(ran.out, ::testing::HasSubstr("kernels fail"));
    EXPECT_THAT(read_file(folder.path() / "atlas" / "index.html"), ::testing::HasSubstr("--kernels"));
}

TEST(CensusOptions, OfViewsAreRefusedForMasks) {
    const TemporaryFolder folder;
    const std::string mask = folder.write("mask.TXT", ".#\n");
    run_well({"census", mask});
    for (const Arguments& option :
         {Arguments{"--shadow-map", "256"}, {"--camera-position", "1,2,3"}, {"--size", "64x64"}})
        expect_refused(folder, Arguments{"census", mask} + option, option[0]);
}

} // namespace
} // namespace gnomon::testing
