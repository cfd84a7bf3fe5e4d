#include "runtime/folder_watch.h"

#include "runtime/error.h"

#include <array>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

#include <sys/inotify.h>
#include <unistd.h>

namespace gnomon {
namespace {

namespace fs = std::filesystem;

// A file counts as written once its writer has closed it; IN_CREATE is for links, which nobody closes, and
// for folders.
constexpr std::uint32_t wanted = IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                 IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

std::string join(const std::string& below, const std::string& name) {
    return below.empty() ? name : below + '/' + name;
}

/// Whether the file was whole when it was made: a symbolic link, or another name for one that there is.
bool is_link(const fs::path& path) {
    std::error_code error;
    return fs::is_symlink(path, error) || fs::hard_link_count(path, error) > 1;
}

} // namespace

FolderWatch::FolderWatch(fs::path folder, How how) : folder_(std::move(folder)) {
    if (!fs::is_directory(folder_)) throw Error("{}: no such folder", folder_.string());
    if (how == How::inotify_if_possible) inotify_ = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
    if (inotify_ < 0 || !watch_below({})) poll_from_now_on();
}

FolderWatch::~FolderWatch() {
    if (inotify_ >= 0) ::close(inotify_);
}

void FolderWatch::poll_from_now_on() {
    if (inotify_ >= 0) ::close(inotify_);
    inotify_ = -1;
    watched_.clear();
    seen_ = stamps();
}

/// False if one of the folders cannot be watched although it is there.
bool FolderWatch::watch_below(const std::string& below) {
    const fs::path path = folder_ / below;
    const int number = ::inotify_add_watch(inotify_, path.c_str(), wanted);
    if (number < 0) return errno == ENOENT || errno == ENOTDIR;
    watched_[number] = below;
    std::error_code error;
    for (fs::directory_iterator entry(path, error), end; !error && entry != end; entry.increment(error)) {
        std::error_code ignored;
        if (entry->is_directory(ignored) && !entry->is_symlink(ignored) &&
            !watch_below(join(below, entry->path().filename().string())))
            return false;
    }
    return true;
}

void FolderWatch::forget_below(const std::string& below) {
    for (auto entry = watched_.begin(); entry != watched_.end();) {
        const auto& [number, path] = *entry;
        if (below.empty() || path == below || path.starts_with(below + '/')) {
            ::inotify_rm_watch(inotify_, number);
            entry = watched_.erase(entry);
        } else {
            ++entry;
        }
    }
}

/// False if the system allows no more watches.
bool FolderWatch::read_events(FolderChanges& changes) {
    alignas(inotify_event) std::array<char, 1 << 16> bytes;
    for (;;) {
        const ssize_t count = ::read(inotify_, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return true;
        for (std::size_t at = 0; at < static_cast<std::size_t>(count);) {
            inotify_event event;
            std::memcpy(&event, bytes.data() + at, sizeof event);
            const std::string name = event.len > 0 ? std::string(bytes.data() + at + sizeof event) : "";
            at += sizeof event + event.len;
            if ((event.mask & IN_Q_OVERFLOW) != 0) {
                changes.all = true;
                if (!watch_below({})) return false; // new folders may be among what was lost
                continue;
            }
            const auto found = watched_.find(event.wd);
            if (found == watched_.end()) continue;
            const std::string path = join(found->second, name);
            if ((event.mask & (IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED)) != 0) {
                if (!found->second.empty()) continue; // the folder above says so too
                changes.all = true;
                rooted_ = false;
            } else if ((event.mask & IN_ISDIR) != 0) {
                changes.all = true;
                if ((event.mask & (IN_DELETE | IN_MOVED_FROM)) != 0) forget_below(path);
                if ((event.mask & (IN_CREATE | IN_MOVED_TO)) != 0 && !watch_below(path)) return false;
            } else if ((event.mask & IN_CREATE) == 0 || is_link(folder_ / path)) {
                changes.files.insert(path);
            }
        }
    }
}

std::map<std::string, FolderWatch::Stamp> FolderWatch::stamps() const {
    std::map<std::string, Stamp> stamps;
    std::error_code error;
    for (fs::recursive_directory_iterator entry(folder_, error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code gone; // between the listing and the question
        if (!entry->is_regular_file(gone)) continue;
        const Stamp stamp{entry->last_write_time(gone), entry->file_size(gone)};
        stamps[entry->path().lexically_relative(folder_).generic_string()] = stamp;
    }
    return stamps;
}

FolderChanges FolderWatch::changes() {
    FolderChanges changes;
    if (inotify_ >= 0) {
        std::error_code error;
        bool possible = read_events(changes);
        if (possible && !rooted_ && fs::is_directory(folder_, error)) {
            forget_below({});
            possible = watch_below({});
            rooted_ = !watched_.empty();
            changes.all = true;
        }
        if (!possible) {
            poll_from_now_on();
            changes.all = true;
        }
        return changes;
    }
    std::map<std::string, Stamp> now = stamps();
    for (const auto& [path, stamp] : now) {
        const auto before = seen_.find(path);
        if (before == seen_.end() || before->second != stamp) changes.files.insert(path);
    }
    for (const auto& [path, stamp] : seen_)
        if (!now.contains(path)) changes.files.insert(path);
    seen_ = std::move(now);
    return changes;
}

} // namespace gnomon
