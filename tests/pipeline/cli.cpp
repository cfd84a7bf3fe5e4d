#include "tests/pipeline/cli.h"

#include "runtime/files.h"

#include <fmt/ranges.h>
#include <gmock/gmock.h>

#include <algorithm>

namespace gnomon::testing {

Ran run_well(const Arguments& arguments) {
    Ran ran = run_gnomon(arguments);
    EXPECT_EQ(ran.exit_code, 0) << fmt::format("{}", fmt::join(arguments, " "));
    EXPECT_EQ(ran.err, "") << fmt::format("{}", fmt::join(arguments, " "));
    return ran;
}

void expect_refused(const TemporaryFolder& folder, const Arguments& arguments, const std::string& what) {
    const std::size_t entries = folder.entries();
    const Ran ran = run_gnomon(arguments);
    const std::string call = fmt::format("{}", fmt::join(arguments, " "));
    EXPECT_EQ(ran.exit_code, 2) << call << '\n' << ran.err;
    EXPECT_FALSE(ran.timed_out) << call;
    EXPECT_EQ(ran.out, "") << call;
    EXPECT_THAT(ran.err, ::testing::StartsWith("gnomon: ")) << call;
    EXPECT_THAT(ran.err, ::testing::HasSubstr(what)) << call;
    EXPECT_EQ(std::ranges::count(ran.err, '\n'), 1) << call << '\n' << ran.err;
    EXPECT_EQ(folder.entries(), entries) << call << " left a file behind";
}

nlohmann::json read_json(const std::filesystem::path& path) { return nlohmann::json::parse(read_file(path)); }

} // namespace gnomon::testing
