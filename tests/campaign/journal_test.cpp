#include "casegen/fuzz/journal.h"

#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/process.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace gnomon::fuzz {
namespace {

class journal : public ::testing::Test {
protected:
    testing::TemporaryFolder folder_;
    std::filesystem::path path_ = folder_.path() / "a.journal";
};

TEST_F(journal, is_read_again_as_it_was_written) {
    {
        Journal first(path_, "campaign");
        EXPECT_TRUE(first.lines().empty());
        first.add({7, "{\"a\": 1}"});
        first.add({2, ""});
    }
    Journal second(path_, "campaign");
    ASSERT_EQ(second.lines().size(), 2u);
    EXPECT_EQ(second.lines()[0].unit, 7u);
    EXPECT_EQ(second.lines()[0].text, "{\"a\": 1}");
    EXPECT_EQ(second.lines()[1].unit, 2u);
    second.add({3, "more"});
    EXPECT_EQ(Journal(path_, "campaign").lines().size(), 3u);
    second.finish();
    EXPECT_FALSE(std::filesystem::exists(path_));
}

TEST_F(journal, a_line_that_was_cut_short_is_none) {
    {
        Journal first(path_, "campaign");
        first.add({1, "whole"});
    }
    write_file(path_, read_file(path_) + "2 cut sho");
    {
        Journal second(path_, "campaign");
        ASSERT_EQ(second.lines().size(), 1u);
        second.add({2, "again"});
    }
    ASSERT_EQ(Journal(path_, "campaign").lines().size(), 2u);
    EXPECT_EQ(Journal(path_, "campaign").lines()[1].text, "again");
}

TEST_F(journal, other_files_are_refused_and_left_alone) {
    write_file(path_, "dear diary\n");
    EXPECT_THROW((Journal{path_, "campaign"}), Error);
    EXPECT_EQ(read_file(path_), "dear diary\n");
    write_file(path_, "gnomon fuzz journal 2 campaign\nseven units\n");
    EXPECT_THROW((Journal{path_, "campaign"}), Error);
}

TEST_F(journal, of_another_campaign_is_refused_and_left_alone) {
    {
        Journal first(path_, "campaign");
        first.add({1, "done"});
    }
    for (const char* other : {"other", "campaig", "campaign2", ""})
        EXPECT_THROW((Journal{path_, other}), Error) << other;
    EXPECT_EQ(Journal(path_, "campaign").lines().size(), 1u);
}

TEST_F(journal, is_discarded_only_if_it_is_one) {
    { Journal first(path_, "campaign"); }
    Journal::discard(path_);
    EXPECT_FALSE(std::filesystem::exists(path_));
    Journal::discard(path_); // there is none
    write_file(path_, "dear diary\n");
    EXPECT_THROW(Journal::discard(path_), Error);
    EXPECT_EQ(read_file(path_), "dear diary\n");
}

TEST_F(journal, is_written_to_by_one_process) {
    Child writer([&]() -> Child::Serve {
        auto journal = std::make_shared<Journal>(path_, "campaign");
        return [journal](const std::string&) { return std::string(); };
    });
    writer.send("are you there?");
    ASSERT_EQ(writer.receive(60).kind, Answer::Kind::message);
    EXPECT_THROW((Journal{path_, "campaign"}), Error);
    EXPECT_THROW(Journal::discard(path_), Error);
    writer = Child([]() -> Child::Serve { return {}; });
    EXPECT_TRUE(Journal(path_, "campaign").lines().empty());
}

TEST_F(journal, without_a_file_nothing_is_kept) {
    Journal none;
    none.add({1, "x"});
    none.finish();
    EXPECT_TRUE(none.lines().empty());
}

} // namespace
} // namespace gnomon::fuzz
