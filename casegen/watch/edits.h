// What people save: which of the kernels' files are others than they were. Editors write in bursts, and
// rename what they wrote over what was there, so that a file is gone for a moment.
#pragma once

#include "casegen/watch/clock.h"
#include "casegen/watch/texts.h"
#include "runtime/folder_watch.h"

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

#include <poll.h>

namespace gnomon::watch {

struct Touched {
    bool all = false; ///< anything may have changed
    std::set<std::string> files;
    bool empty() const { return !all && files.empty(); }
};

class Edits {
public:
    /// Throws Error if this is no folder.
    Edits(const std::filesystem::path& folder, FolderWatch::How how);

    /// The files as they are now, once take() has seen it.
    const FolderTexts& texts() const { return texts_; }

    /// Reads again what has changed, waiting a moment for what belongs to it. A file that is gone counts once
    /// it has stayed away.
    Touched take();

    /// Something may have to be taken: on poll()'s word about the descriptor, and whenever this says so.
    bool is_due() const { return folder_.must_poll() || waits(); }
    /// For files that may come back.
    bool waits() const { return !gone_.empty() || all_since_ < never; }
    double deadline(double now) const;
    int descriptor() const { return folder_.descriptor(); }
    bool polls() const { return folder_.must_poll(); }

private:
    void collect(double since, std::set<std::string>& touched);

    std::filesystem::path root_;
    FolderWatch folder_; // before the texts: what changes while they are read is told afterwards
    FolderTexts texts_;
    std::map<std::string, double> gone_; ///< files that are no more, since when
    double all_since_ = never;           ///< since when anything may have changed
};

/// poll(2) for so many seconds; negative descriptors are passed over, and a signal ends it.
void wait_for(std::vector<pollfd>& polled, double seconds);

} // namespace gnomon::watch
