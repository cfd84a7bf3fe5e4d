#include "runtime/files.h"

#include "tests/support/temporary_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <optional>
#include <string>

#include <sys/resource.h>
#include <sys/stat.h>

namespace gnomon {
namespace {

/// Root may read and write everything: for its lifetime the process acts as nobody, if it is root.
class AsOrdinaryUser {
public:
    AsOrdinaryUser() {
        if (geteuid() == 0) was_root_ = seteuid(nobody) == 0;
    }
    ~AsOrdinaryUser() {
        if (was_root_ && seteuid(0) != 0) ADD_FAILURE() << "cannot become root again";
    }
    AsOrdinaryUser(const AsOrdinaryUser&) = delete;
    AsOrdinaryUser& operator=(const AsOrdinaryUser&) = delete;

private:
    static constexpr uid_t nobody = 65534;
    bool was_root_ = false;
};

namespace fs = std::filesystem;
using testing::error_of;
using ::testing::HasSubstr;
using testing::TemporaryFolder;

/// Sets (or unsets) an environment variable for as long as it lives.
class Environment {
public:
    Environment(const char* name, const std::optional<std::string>& value) : name_(name) {
        if (const char* old = std::getenv(name)) old_ = old;
        set(value);
    }
    ~Environment() { set(old_); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    void set(const std::optional<std::string>& value) {
        if (value)
            setenv(name_, value->c_str(), 1);
        else
            unsetenv(name_);
    }
    const char* name_;
    std::optional<std::string> old_;
};

TEST(Files, WhatIsWrittenIsRead) {
    const TemporaryFolder folder;
    std::string bytes = "line\r\n";
    for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
    write_file(folder.path() / "bytes", bytes);
    EXPECT_EQ(read_file(folder.path() / "bytes"), bytes);
    write_file(folder.path() / "bytes", "");
    EXPECT_EQ(read_file(folder.path() / "bytes"), "");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Files, ReadNamesWhatItCannotRead) {
    const TemporaryFolder folder;
    EXPECT_THAT(error_of([&] { read_file(folder.path() / "absent.txt"); }),
                AllOf(HasSubstr("absent.txt"), HasSubstr("No such file")));
    EXPECT_THAT(error_of([&] { read_file(folder.path()); }),
                AllOf(HasSubstr(folder.path().string()), HasSubstr("folder")));
    const fs::path below_a_file = folder.write("file", "x") / "name";
    EXPECT_THAT(error_of([&] { read_file(below_a_file); }), HasSubstr("file/name"));
}

TEST(Files, UnreadableFile) {
    const AsOrdinaryUser user;
    const TemporaryFolder folder;
    const fs::path secret = folder.write("secret", "x");
    fs::permissions(secret, fs::perms::none);
    EXPECT_THAT(error_of([&] { read_file(secret); }), HasSubstr("secret"));
}

TEST(Files, WriteAndItsRehearsalRefuseTheSame) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "x");
    const fs::path bad[] = {"",
                            folder.path(),
                            folder.path() / "missing" / "name",
                            file / "name",
                            folder.path() / "new" / "",
                            folder.path() / std::string(300, 'n')};
    for (const fs::path& path : bad) {
        EXPECT_THAT(error_of([&] { write_file(path, "bytes"); }), HasSubstr(path.string()));
        EXPECT_THAT(error_of([&] { require_writable(path); }), HasSubstr(path.string()));
    }
    EXPECT_EQ(folder.entries(), 1u);
    EXPECT_EQ(read_file(file), "x");
}

TEST(Files, ReadOnlyFileAndFolderAreRefused) {
    const AsOrdinaryUser user;
    const TemporaryFolder folder;
    const fs::path file = folder.write("kept", "x");
    fs::permissions(file, fs::perms::owner_read);
    EXPECT_THAT(error_of([&] { write_file(file, "y"); }), HasSubstr("kept"));
    EXPECT_THAT(error_of([&] { require_writable(file); }), HasSubstr("kept"));
    EXPECT_EQ(read_file(file), "x");

    fs::permissions(folder.path(), fs::perms::owner_read | fs::perms::owner_exec);
    EXPECT_THAT(error_of([&] { write_file(folder.path() / "new", "y"); }), HasSubstr("new"));
    EXPECT_THAT(error_of([&] { require_writable(folder.path() / "new"); }), HasSubstr("new"));
    fs::permissions(folder.path(), fs::perms::owner_all);
}

TEST(Files, RequireWritableLeavesEverythingAsItWas) {
    const TemporaryFolder folder;
    require_writable(folder.path() / "new");
    EXPECT_EQ(folder.entries(), 0u);
    const fs::path old = folder.write("old", "x");
    require_writable(old);
    EXPECT_EQ(read_file(old), "x");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Files, FailedWriteKeepsTheOldBytesAndLeavesNothingBehind) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "old");
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    const rlimit small{100000, before.rlim_max};
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    setrlimit(RLIMIT_FSIZE, &small);
    const std::string message = error_of([&] { write_file(file, std::string(1000000, 'n')); });
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);

    EXPECT_THAT(message, AllOf(HasSubstr(file.string()), HasSubstr("too large")));
    EXPECT_EQ(read_file(file), "old");
    EXPECT_EQ(folder.entries(), 1u);
}

TEST(Files, WriteGoesThroughASymbolicLink) {
    const TemporaryFolder folder;
    const fs::path file = folder.write("file", "old");
    fs::create_symlink(file, folder.path() / "link");
    write_file(folder.path() / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder.path() / "link"));
    EXPECT_EQ(read_file(file), "new");
}

TEST(Files, DevicesAreWrittenToAndNotReplaced) {
    const TemporaryFolder folder;
    const fs::path pipe = folder.path() / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> reader(std::fopen(pipe.c_str(), "r+"), std::fclose);
    write_file(pipe, "through");
    char bytes[8] = {};
    EXPECT_EQ(std::fread(bytes, 1, 7, reader.get()), 7u);
    EXPECT_STREQ(bytes, "through");
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(Files, RelativeNamesAreUnderTheCurrentFolder) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    write_file("plain", "bytes");
    require_writable("other");
    EXPECT_EQ(read_file("plain"), "bytes");
    fs::current_path(before);
    EXPECT_EQ(read_file(folder.path() / "plain"), "bytes");
}

TEST(Files, CacheDirectoryFollowsTheEnvironment) {
    const TemporaryFolder folder;
    const std::string root = folder.path().string();
    const Environment home("HOME", root + "/home"), temporary("TMPDIR", root);
    {
        const Environment named("GNOMON_CACHE", root + "/a/b"), xdg("XDG_CACHE_HOME", root + "/xdg");
        EXPECT_EQ(cache_directory(), fs::path(root + "/a/b"));
        EXPECT_TRUE(fs::is_directory(root + "/a/b"));
    }
    const Environment unnamed("GNOMON_CACHE", std::nullopt);
    {
        const Environment xdg("XDG_CACHE_HOME", root + "/xdg");
        EXPECT_EQ(cache_directory(), fs::path(root + "/xdg/gnomon"));
        EXPECT_TRUE(fs::is_directory(root + "/xdg/gnomon"));
    }
    const Environment relative("XDG_CACHE_HOME", "relative");
    EXPECT_EQ(cache_directory(), fs::path(root + "/home/.cache/gnomon"));
    EXPECT_TRUE(fs::is_directory(root + "/home/.cache/gnomon"));
}

TEST(Files, CacheDirectoryWithoutAHomeIsPrivate) {
    const TemporaryFolder folder;
    const Environment unnamed("GNOMON_CACHE", ""), xdg("XDG_CACHE_HOME", ""), home("HOME", std::nullopt),
        temporary("TMPDIR", folder.path().string());
    const fs::path cache = cache_directory();
    EXPECT_EQ(cache.parent_path(), folder.path());
    EXPECT_EQ(fs::status(cache).permissions(), fs::perms::owner_all);
    EXPECT_EQ(cache_directory(), cache);

    fs::permissions(cache, fs::perms::all);
    EXPECT_THAT(error_of([] { cache_directory(); }), HasSubstr("GNOMON_CACHE"));
}

TEST(Files, CacheDirectoryThatCannotBeMade) {
    const TemporaryFolder folder;
    const std::string below_a_file = folder.write("file", "x") / "cache";
    const Environment named("GNOMON_CACHE", below_a_file);
    EXPECT_THAT(error_of([] { cache_directory(); }),
                AllOf(HasSubstr(below_a_file), HasSubstr("GNOMON_CACHE")));
}

TEST(Files, HashIsFnv1a) {
    static_assert(hash("") == 0xcbf29ce484222325ull);
    EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cull);
    EXPECT_EQ(hash("foobar"), 0x85944171f73967e8ull);
    EXPECT_EQ(hash("bar", hash("foo")), hash("foobar"));
    EXPECT_EQ(hash("\xff"), 0xaf64724c8602eb6eull);
}

} // namespace
} // namespace gnomon
