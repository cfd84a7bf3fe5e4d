// An atlas as one HTML page that needs no network: style, script and pictures are part of it.
#pragma once

#include "casegen/atlas/atlas.h"

#include <filesystem>
#include <string>

namespace gnomon::atlas {

/// Same atlas, same page. `kernels` leads from the page to the folder of the kernels' files, for links; empty
/// if it cannot. `replay`: see replay_command.
std::string page(const Atlas& atlas, const std::string& kernels, const std::string& replay = {});

/// From a page in `folder` to the kernels, if both lie in the folder that holds the kernels': else a link
/// would lead nowhere on another machine, and is empty. Both must exist.
std::string link_to_kernels(const std::filesystem::path& folder, const std::filesystem::path& kernels);

} // namespace gnomon::atlas
