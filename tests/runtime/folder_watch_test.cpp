// What a folder's watch tells of, by inotify and by polling.
#include "runtime/files.h"
#include "runtime/folder_watch.h"
#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

namespace gnomon {
namespace {

namespace fs = std::filesystem;
using ::testing::Contains;
using ::testing::HasSubstr;

using testing::TemporaryFolder;

class folder_watch : public ::testing::TestWithParam<FolderWatch::How> {
protected:
    void SetUp() override {
        fs::create_directories(folder_ / "inner/most");
        write_file(folder_ / "inner/old", "1");
        watch_ = std::make_unique<FolderWatch>(folder_, GetParam());
        EXPECT_EQ(watch_->must_poll(), GetParam() == FolderWatch::How::polling);
    }
    TemporaryFolder temporary_;
    fs::path folder_ = temporary_.path() / "watched";
    std::unique_ptr<FolderWatch> watch_;
};

TEST_P(folder_watch, is_silent_while_nothing_changes) {
    EXPECT_TRUE(watch_->changes().empty());
    EXPECT_EQ(read_file(folder_ / "inner/old"), "1"); // reading is no change
    EXPECT_TRUE(watch_->changes().empty());
}

TEST_P(folder_watch, tells_of_files_that_are_written_replaced_renamed_and_removed) {
    temporary_.write("watched/inner/old", "longer");
    EXPECT_THAT(watch_->changes().files, Contains("inner/old"));
    write_file(folder_ / "inner/old", "by renaming");
    EXPECT_THAT(watch_->changes().files, Contains("inner/old"));
    fs::rename(folder_ / "inner/old", folder_ / "inner/most/new");
    const FolderChanges renamed = watch_->changes();
    EXPECT_THAT(renamed.files, Contains("inner/old"));
    EXPECT_THAT(renamed.files, Contains("inner/most/new"));
    fs::remove(folder_ / "inner/most/new");
    EXPECT_THAT(watch_->changes().files, Contains("inner/most/new"));
    EXPECT_TRUE(watch_->changes().empty());
}

TEST_P(folder_watch, tells_of_files_in_folders_that_came_later) {
    fs::create_directories(folder_ / "later/below");
    watch_->changes();
    write_file(folder_ / "later/below/file", "1");
    EXPECT_THAT(watch_->changes().files, Contains("later/below/file"));
    fs::rename(folder_ / "later", folder_ / "latest");
    const FolderChanges renamed = watch_->changes();
    EXPECT_TRUE(renamed.all || renamed.files.contains("latest/below/file"));
    temporary_.write("watched/latest/below/file", "longer");
    EXPECT_THAT(watch_->changes().files, Contains("latest/below/file"));
}

TEST_P(folder_watch, goes_on_when_the_folder_itself_comes_back) {
    fs::rename(folder_, temporary_.path() / "aside");
    EXPECT_FALSE(watch_->changes().empty());
    EXPECT_TRUE(watch_->must_poll());
    fs::rename(temporary_.path() / "aside", folder_);
    EXPECT_FALSE(watch_->changes().empty());
    temporary_.write("watched/inner/old", "longer");
    EXPECT_THAT(watch_->changes().files, Contains("inner/old"));
}

INSTANTIATE_TEST_SUITE_P(how, folder_watch,
                         ::testing::Values(FolderWatch::How::inotify_if_possible, FolderWatch::How::polling),
                         [](const auto& how) {
                             return how.param == FolderWatch::How::polling ? "polling" : "inotify";
                         });

TEST(folder_watch_of_nothing, is_refused) {
    EXPECT_THAT(testing::error_of([] { FolderWatch("/nowhere"); }), HasSubstr("/nowhere: no such folder"));
}

} // namespace
} // namespace gnomon
