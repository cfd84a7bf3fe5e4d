// Compiled kernels on disk: found again, never stale, never believed when damaged.
#include "runtime/files.h"
#include "runtime/glsl/compiler.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace gnomon {
namespace {

using testing::TemporaryFolder;
namespace fs = std::filesystem;

/// A cache of the test's own, for as long as it lives.
class OwnCache {
public:
    explicit OwnCache(const fs::path& folder) : before_(std::getenv("GNOMON_CACHE")) {
        setenv("GNOMON_CACHE", folder.c_str(), 1);
    }
    ~OwnCache() { setenv("GNOMON_CACHE", before_.c_str(), 1); }
    OwnCache(const OwnCache&) = delete;
    OwnCache& operator=(const OwnCache&) = delete;

private:
    std::string before_;
};

constexpr const char* text = "#include \"a.glsl\"\nlayout(local_size_x = 1) in;\nvoid main() { a(); }\n";

class spirv_cache : public ::testing::Test {
protected:
    void SetUp() override { folder.write("a.glsl", "float a() { return 1.0; }\n"); }

    glsl::Spirv compile() const { return glsl::compile(sources, text, "m", glsl::Stage::compute); }
    glsl::Spirv cached() const {
        return glsl::find_cached(glsl::expand(sources, text, "m"), glsl::Stage::compute);
    }
    std::vector<fs::path> files() const {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(folder.path() / "cache/spirv"))
            found.push_back(entry.path());
        return found;
    }

    TemporaryFolder folder;
    OwnCache cache{folder.path() / "cache"};
    glsl::Sources sources{folder.path(), {}};
};

TEST_F(spirv_cache, holds_what_was_compiled) {
    EXPECT_TRUE(cached().empty());
    const glsl::Spirv words = compile();
    EXPECT_EQ(cached(), words);
    EXPECT_EQ(compile(), words);
    EXPECT_EQ(files().size(), 1u);
}

TEST_F(spirv_cache, knows_an_edited_include) {
    const glsl::Spirv before = compile();
    folder.write("a.glsl", "float a() { return 2.0; }\n");
    EXPECT_TRUE(cached().empty());
    EXPECT_NE(compile(), before);
}

TEST_F(spirv_cache, keeps_stages_apart) {
    compile();
    EXPECT_TRUE(glsl::find_cached(glsl::expand(sources, text, "m"), glsl::Stage::vertex).empty());
}

TEST_F(spirv_cache, does_not_believe_a_damaged_file) {
    const glsl::Spirv words = compile();
    const fs::path file = files().at(0);
    const std::string good = read_file(file);
    std::vector<std::string> damaged{"", "short", good.substr(0, good.size() - 4), good + "tail"};
    for (const std::size_t at : {std::size_t{0}, std::size_t{20}, good.size() - 12, good.size() - 1}) {
        damaged.push_back(good);
        damaged.back()[at] = static_cast<char>(damaged.back()[at] ^ 1);
    }
    for (const std::string& bytes : damaged) {
        folder.write(fs::relative(file, folder.path()).string(), bytes);
        EXPECT_TRUE(cached().empty()) << "a file of " << bytes.size() << " bytes was believed";
        EXPECT_EQ(compile(), words);
        EXPECT_EQ(cached(), words); // and mended
    }
}

TEST_F(spirv_cache, says_that_the_folder_it_was_given_cannot_be_made) {
    folder.write("file", "in the way");
    const OwnCache blocked(folder.path() / "file/cache");
    EXPECT_NE(testing::error_of([&] { compile(); }).find("file/cache"), std::string::npos);
}

} // namespace
} // namespace gnomon
