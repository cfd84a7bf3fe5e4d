// Coverage as text and as LCOV's tracefile, from counts made up here.
#include "casegen/coverage/report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <sstream>

namespace gnomon::coverage {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

FileCoverage file(const std::string& name, const std::string& text, const std::vector<Hits>& hits) {
    FileCoverage file;
    file.name = name;
    file.text = text;
    file.points = instrument(text);
    file.hits = hits;
    EXPECT_EQ(file.points.counters, hits.size());
    return file;
}

// Counters: 0 f, 1 what follows, 2 and 3 `x < 3`, 4 g, 6 and 7 `a`, 8 and 9 `b`.
const char* const text = "int f(int x) {\n"
                         "    if (x < 3)\n"
                         "        return 1;\n"
                         "    return 2;\n"
                         "}\n"
                         "bool g() {\n"
                         "    return a || b;\n"
                         "}\n";

std::vector<std::string> gaps_of(const FileCoverage& file, bool with_samples) {
    std::vector<std::string> all;
    for (const Gap& gap : gaps(file, with_samples)) all.push_back(std::to_string(gap.line) + ": " + gap.what);
    return all;
}

TEST(coverage_report, names_what_was_never_reached_and_what_only_samples_reached) {
    const FileCoverage some = file(
        "a/b.glsl", text, {{5, 1}, {5, 0}, {0, 1}, {5, 0}, {2, 0}, {0, 0}, {2, 0}, {0, 0}, {0, 0}, {0, 0}});
    EXPECT_THAT(gaps_of(some, true), ElementsAre("2: `x < 3` was true only in random samples",
                                                 "3: was reached only by random samples: `return 1;`",
                                                 "7: `a` was never false", "7: `b` was never asked"));
    EXPECT_THAT(gaps_of(some, false),
                ElementsAre("2: `x < 3` was never true", "3: was never reached: `return 1;`",
                            "7: `a` was never false", "7: `b` was never asked"));
}

TEST(coverage_report, says_nothing_more_within_a_function_that_nobody_entered) {
    const FileCoverage some = file(
        "a/b.glsl", text, {{5, 1}, {4, 0}, {1, 1}, {4, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}, {0, 0}});
    EXPECT_THAT(gaps_of(some, true), ElementsAre("6: `g` was never entered"));
    EXPECT_EQ(totals(some).functions.all, 1u);
    EXPECT_EQ(totals(some).functions.of, 2u);
}

TEST(coverage_report, counts_lines_branches_and_functions_by_fixtures_and_with_samples) {
    Coverage coverage;
    coverage.files.push_back(file(
        "a/b.glsl", text, {{5, 1}, {5, 0}, {0, 1}, {5, 0}, {2, 0}, {0, 0}, {2, 0}, {0, 0}, {0, 0}, {0, 0}}));
    const std::string all = to_text(coverage, true);
    EXPECT_THAT(all, HasSubstr("5/6       6/6        2/6       3/6"));
    EXPECT_THAT(all, HasSubstr("a/b.glsl:7: `a` was never false\n"));
    EXPECT_THAT(to_text(coverage, false), Not(HasSubstr("never")));
    coverage.only_fixtures = true;
    EXPECT_THAT(to_text(coverage, true), HasSubstr("a/b.glsl:2: `x < 3` was never true\n"));
}

/// A tracefile as its readers take it apart.
struct Record {
    std::map<int, std::uint64_t> lines;
    std::map<std::string, int> functions;
    std::map<std::string, std::uint64_t> entered;
    std::vector<std::string> branches;
    std::map<std::string, std::uint64_t> sums;
};

std::map<std::string, Record> parse_lcov(const std::string& tracefile) {
    std::map<std::string, Record> records;
    std::istringstream in(tracefile);
    std::string line;
    std::getline(in, line);
    EXPECT_EQ(line, "TN:");
    Record* record = nullptr;
    while (std::getline(in, line)) {
        const std::string key = line.substr(0, line.find(':'));
        const std::string value = line.size() > key.size() ? line.substr(key.size() + 1) : "";
        const std::size_t comma = value.find(',');
        if (key == "SF") {
            EXPECT_EQ(record, nullptr);
            record = &records[value];
        } else if (key == "end_of_record") {
            record = nullptr;
        } else if (!record) {
            ADD_FAILURE() << line;
        } else if (key == "DA") {
            EXPECT_TRUE(record->lines.emplace(std::stoi(value), std::stoull(value.substr(comma + 1))).second);
        } else if (key == "FN") {
            EXPECT_TRUE(record->functions.emplace(value.substr(comma + 1), std::stoi(value)).second);
        } else if (key == "FNDA") {
            record->entered[value.substr(comma + 1)] = std::stoull(value);
        } else if (key == "BRDA") {
            record->branches.push_back(value);
        } else {
            record->sums[key] = std::stoull(value);
        }
    }
    EXPECT_EQ(record, nullptr);
    return records;
}

TEST(coverage_report, lcov_says_the_same_and_adds_up) {
    Coverage coverage;
    coverage.files.push_back(file(
        "a/b.glsl", text, {{5, 1}, {5, 0}, {0, 1}, {5, 0}, {2, 0}, {0, 0}, {2, 0}, {0, 0}, {0, 0}, {0, 0}}));
    coverage.files.push_back(file("a/c.glsl", "const int N = 3;\n", {}));
    coverage.files.push_back(file("<a/cases>", "void h() {}\n", {{1, 1}}));
    const std::map<std::string, Record> records = parse_lcov(to_lcov(coverage, "/k/kernels"));
    ASSERT_EQ(records.size(), 2u); // what is generated is no file
    const Record& record = records.at("/k/kernels/a/b.glsl");
    EXPECT_THAT(record.lines, ElementsAre(std::pair{1, 6u}, std::pair{2, 6u}, std::pair{3, 1u},
                                          std::pair{4, 5u}, std::pair{6, 2u}, std::pair{7, 2u}));
    EXPECT_THAT(record.functions, ElementsAre(std::pair{"f", 1}, std::pair{"g", 6}));
    EXPECT_THAT(record.entered, ElementsAre(std::pair{"f", 6u}, std::pair{"g", 2u}));
    EXPECT_THAT(record.branches,
                ElementsAre("2,0,0,1", "2,0,1,5", "7,1,0,2", "7,1,1,0", "7,2,0,-", "7,2,1,-"));
    EXPECT_THAT(record.sums, ElementsAre(std::pair{"BRF", 6u}, std::pair{"BRH", 3u}, std::pair{"FNF", 2u},
                                         std::pair{"FNH", 2u}, std::pair{"LF", 6u}, std::pair{"LH", 6u}));
    EXPECT_EQ(records.at("/k/kernels/a/c.glsl").sums.at("LF"), 0u);
}

} // namespace
} // namespace gnomon::coverage
