// What a watching session tells, as lines for people and as JSON for editors' plug-ins.
#pragma once

#include "casegen/watch/session.h"

#include <string>

namespace gnomon::cli {

/// Lines with their ends; nothing for what nobody needs to read (a kernel that passes the first check).
/// `folder`: that is watched. `colours`: for a terminal.
std::string watch_text(const watch::Event& event, const std::string& folder, bool colours);

/// One JSON object, without the end of the line. Numbers that JSON has not are null.
std::string watch_json(const watch::Event& event, const std::string& folder);

} // namespace gnomon::cli
