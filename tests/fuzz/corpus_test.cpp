// Every file of fixtures/corpus, by the target that it belongs to: what fuzzing found stays mended.
#include "tests/fuzz/target.h"
#include "tests/support/environment.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>

namespace gnomon::fuzzing {
namespace {

std::filesystem::path corpus() { return testing::fixtures_folder() / "corpus"; }

class Corpus : public ::testing::TestWithParam<std::string> {};

TEST_P(Corpus, IsAnswered) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus() / GetParam())) {
        SCOPED_TRACE(entry.path().filename().string());
        const std::string bytes = read_file(entry.path());
        EXPECT_EQ(targets().at(GetParam())(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()),
                  0);
        ++files;
    }
    EXPECT_GT(files, 3u);
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const auto& [name, target] : targets()) all.push_back(name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Corpus, ::testing::ValuesIn(names()),
                         [](const auto& test) { return test.param; });

TEST(CorpusFolders, BelongToATargetEach) {
    std::set<std::string> folders;
    for (const auto& entry : std::filesystem::directory_iterator(corpus()))
        if (entry.is_directory()) folders.insert(entry.path().filename().string());
    const std::vector<std::string> known = names();
    EXPECT_EQ(folders, std::set<std::string>(known.begin(), known.end()));
}

TEST(FuzzTarget, TellsAnAnswerFromAnything) {
    EXPECT_TRUE(is_read([] {}));
    EXPECT_FALSE(is_read([] { throw Error("one line"); }));
    EXPECT_THROW(is_read([] { throw std::out_of_range("at"); }), std::out_of_range);
    EXPECT_DEATH(is_read([] { throw Error("two\nlines"); }), "not true");
    EXPECT_DEATH(is_read([] { throw Error(std::string()); }), "not true");
    EXPECT_DEATH(REQUIRE(1 + 1 == 3), "not true: 1 \\+ 1 == 3");
}

} // namespace
} // namespace gnomon::fuzzing
