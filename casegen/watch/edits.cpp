#include "casegen/watch/edits.h"

#include "runtime/error.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace gnomon::watch {

Edits::Edits(const std::filesystem::path& folder, FolderWatch::How how)
    : root_(folder), folder_(folder, how), texts_(folder) {}

/// What has changed until nothing does for a moment.
void Edits::collect(double since, std::set<std::string>& touched) {
    for (double now = since; now < since + longest_settling; now = seconds_now()) {
        const FolderChanges changes = folder_.changes();
        for (const std::string& file : changes.files) {
            std::error_code error;
            if (std::filesystem::is_regular_file(root_ / file, error)) {
                gone_.erase(file);
                touched.insert(file);
            } else {
                gone_.try_emplace(file, since);
            }
        }
        if (changes.all && all_since_ == never) all_since_ = since;
        if (changes.empty() || folder_.must_poll()) break;
        std::vector<pollfd> polled{{folder_.descriptor(), POLLIN, 0}};
        wait_for(polled, quiet);
        if (polled[0].revents == 0) break;
    }
}

Touched Edits::take() {
    const double since = seconds_now();
    Touched touched;
    collect(since, touched.files);
    if (since >= all_since_ + absence) {
        touched.all = true;
        all_since_ = never;
        gone_.clear();
        texts_.read_all();
        return touched;
    }
    std::erase_if(gone_, [&](const auto& gone) {
        if (since < gone.second + absence) return false;
        touched.files.insert(gone.first);
        return true;
    });
    for (const std::string& file : touched.files) texts_.read(file);
    return touched;
}

double Edits::deadline(double now) const {
    double deadline = folder_.must_poll() ? now + FolderWatch::poll_seconds : never;
    for (const auto& [file, since] : gone_) deadline = std::min(deadline, since + absence);
    return std::min(deadline, all_since_ + absence);
}

void wait_for(std::vector<pollfd>& polled, double seconds) {
    const int milliseconds = seconds > 1e5 ? -1 : static_cast<int>(std::max(seconds, 0.0) * 1000 + 0.999);
    if (::poll(polled.data(), polled.size(), milliseconds) < 0) {
        if (errno != EINTR) throw Error("waiting for changes failed: {}", std::strerror(errno));
        for (pollfd& entry : polled) entry.revents = 0;
    }
}

} // namespace gnomon::watch
