// Which files below a folder change, as they do.
//
//     FolderWatch watch("kernels");
//     poll(watch.descriptor() …);                     // or, where it polls, wait poll_seconds
//     for (const std::string& file : watch.changes().files) …
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace gnomon {

/// What has changed: written to its end, renamed, made or gone.
struct FolderChanges {
    std::set<std::string> files; ///< paths below the folder, with /
    bool all = false; ///< besides, anything may have: a folder came or went, or the system lost count
    bool empty() const { return files.empty() && !all; }
};

/// Watches a folder and the folders below it, new ones included, by inotify; where that is refused (or not
/// wanted: it knows nothing of what other machines write), by looking at every file's size and time. Folders
/// behind symbolic links are not entered. The folder itself may vanish and come back.
class FolderWatch {
public:
    enum class How { inotify_if_possible, polling };

    /// Throws Error if this is no folder.
    explicit FolderWatch(std::filesystem::path folder, How how = How::inotify_if_possible);
    ~FolderWatch();
    FolderWatch(const FolderWatch&) = delete;
    FolderWatch& operator=(const FolderWatch&) = delete;

    /// Readable when something may have changed; -1 if nothing ever is.
    int descriptor() const { return inotify_; }
    /// Whether changes() must be asked every so often: it polls, or waits for the folder to come back.
    bool must_poll() const { return inotify_ < 0 || !rooted_; }
    static constexpr double poll_seconds = 0.1;

    /// Since the last call, or since this was made. Does not wait.
    FolderChanges changes();

private:
    struct Stamp {
        std::filesystem::file_time_type time;
        std::uintmax_t size = 0;
        friend bool operator==(const Stamp&, const Stamp&) = default;
    };
    bool watch_below(const std::string& below);
    void forget_below(const std::string& below);
    bool read_events(FolderChanges& changes);
    void poll_from_now_on();
    std::map<std::string, Stamp> stamps() const;

    std::filesystem::path folder_;
    int inotify_ = -1;
    bool rooted_ = true;
    std::map<int, std::string> watched_; ///< inotify's number to a folder's path below ours: "", "smsr"
    std::map<std::string, Stamp> seen_;  ///< where it polls
};

} // namespace gnomon
