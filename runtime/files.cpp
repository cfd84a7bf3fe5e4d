#include "runtime/files.h"

#include "runtime/error.h"

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <optional>
#include <system_error>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

struct CloseFile {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, CloseFile>;

std::string reason(int error) { return std::generic_category().message(error); }

/// Where the bytes end up: the file behind any symbolic links. Throws if it could not be replaced.
struct Target {
    fs::path path;
    bool in_place = false; // a device or pipe: there is nothing to rename over
};

Target resolve_target(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    if (path.empty() || status.type() == fs::file_type::none)
        throw Error("cannot write '{}': {}", path.string(),
                    path.empty() ? "the name is empty" : error.message());
    if (fs::is_directory(status))
        throw Error("cannot write '{}': it is a folder; name a file", path.string());
    if (!fs::exists(status) && !path.has_filename())
        throw Error("cannot write '{}': it names a folder; name a file", path.string());
    // Renaming needs no permission on the file itself, but its owner made it read-only for a reason.
    if (fs::exists(status) && faccessat(AT_FDCWD, path.c_str(), W_OK, AT_EACCESS) != 0)
        throw Error("cannot write '{}': {}", path.string(), reason(errno));
    if (fs::exists(status) && !fs::is_regular_file(status)) return {path, true};

    fs::path resolved = fs::weakly_canonical(fs::absolute(path), error);
    if (error) throw Error("cannot write '{}': {}", path.string(), error.message());
    if (!fs::is_directory(resolved.parent_path(), error))
        throw Error("cannot write '{}': there is no folder '{}'; make it first", path.string(),
                    resolved.parent_path().string());
    return {std::move(resolved), false};
}

/// A new file beside `target` that goes away unless it is renamed.
class TemporaryFile {
public:
    explicit TemporaryFile(const fs::path& target) {
        static std::atomic<unsigned> counter{0};
        do {
            path_ = target.parent_path() / fmt::format(".gnomon-{}-{}.tmp", getpid(), counter++);
            file_.reset(std::fopen(path_.c_str(), "wbx"));
        } while (!file_ && errno == EEXIST);
        if (!file_) throw Error("cannot write '{}': {}", target.string(), reason(errno));
    }
    ~TemporaryFile() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove(path_, ignored);
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    File& file() { return file_; }

    void rename_to(const fs::path& target) {
        std::error_code error;
        fs::rename(path_, target, error);
        if (error) throw Error("cannot write '{}': {}", target.string(), error.message());
        path_.clear();
    }

private:
    fs::path path_;
    File file_;
};

void write_and_close(File file, std::string_view bytes, const fs::path& path) {
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    const int write_error = errno;
    // Buffered bytes reach the disk here, so this is where a full one shows.
    const bool closed = std::fclose(file.release()) == 0;
    if (!written || !closed)
        throw Error("cannot write '{}': {}", path.string(), reason(written ? errno : write_error));
}

std::optional<fs::path> environment_path(const char* variable) {
    const char* value = std::getenv(variable);
    if (value == nullptr || *value == '\0') return std::nullopt;
    return fs::path(value);
}

bool usable_directory(const fs::path& path) {
    std::error_code error;
    fs::create_directories(path, error);
    return fs::is_directory(path, error) && faccessat(AT_FDCWD, path.c_str(), W_OK | X_OK, AT_EACCESS) == 0;
}

/// Anyone may create names in the temporary folder: a cache somebody else made there is not to be trusted.
bool usable_private_directory(const fs::path& path) {
    mkdir(path.c_str(), 0700);
    struct stat status {};
    return lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode) && status.st_uid == geteuid() &&
           (status.st_mode & 0777) == 0700;
}

} // namespace

std::string read_file(const fs::path& path) {
    std::error_code error;
    if (fs::is_directory(path, error))
        throw Error("cannot read '{}': it is a folder; name a file", path.string());
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) throw Error("cannot read '{}': {}", path.string(), reason(errno));

    std::string bytes;
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error) bytes.reserve(static_cast<std::size_t>(size));
    char block[1 << 16];
    while (const std::size_t count = std::fread(block, 1, sizeof block, file.get()))
        bytes.append(block, count);
    if (std::ferror(file.get()) != 0) throw Error("cannot read '{}': {}", path.string(), reason(errno));
    return bytes;
}

void write_file(const fs::path& path, std::string_view bytes) {
    const Target target = resolve_target(path);
    if (target.in_place) {
        File file(std::fopen(target.path.c_str(), "wb"));
        if (!file) throw Error("cannot write '{}': {}", path.string(), reason(errno));
        write_and_close(std::move(file), bytes, path);
        return;
    }
    TemporaryFile temporary(target.path);
    write_and_close(std::move(temporary.file()), bytes, path);
    temporary.rename_to(target.path);
}

void require_writable(const fs::path& path) {
    const Target target = resolve_target(path);
    if (!target.in_place) TemporaryFile{target.path};
}

std::string in_quotes(std::string_view text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'')
            quoted += "'\\''";
        else
            quoted += c;
    }
    return quoted + "'";
}

fs::path cache_directory() {
    if (const auto named = environment_path("GNOMON_CACHE")) {
        if (usable_directory(*named)) return *named;
        throw Error(
            "cannot use the cache folder '{}': set GNOMON_CACHE to a folder that can be made and written",
            named->string());
    }
    // The XDG specification has relative paths ignored.
    if (const auto base = environment_path("XDG_CACHE_HOME"); base && base->is_absolute())
        if (fs::path path = *base / "gnomon"; usable_directory(path)) return path;
    if (const auto home = environment_path("HOME"); home && home->is_absolute())
        if (fs::path path = *home / ".cache" / "gnomon"; usable_directory(path)) return path;

    std::error_code error;
    const fs::path temporary = fs::temp_directory_path(error);
    fs::path path = temporary / fmt::format("gnomon-{}", geteuid());
    if (!error && usable_private_directory(path)) return path;
    throw Error("cannot make a cache folder in the home or the temporary folder: set GNOMON_CACHE to one");
}

} // namespace gnomon
