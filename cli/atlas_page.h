// The atlas as a file, for the verbs that write it.
#pragma once

#include "casegen/atlas/atlas.h"
#include "cli/commands.h"

#include <filesystem>
#include <string>
#include <vector>

namespace gnomon::cli {

/// Every kernel, with 65,536 samples and the repository's pins.
atlas::Options atlas_options(const Common& common);

/// Makes the folder and returns the page's path in it. Throws Error if either cannot be written; before it
/// makes anything, if there is no such device or folder of kernels.
std::filesystem::path require_atlas_folder(const std::filesystem::path& folder, const Common& common);

/// `replay`: see replay_command.
void write_atlas(const std::filesystem::path& path, const atlas::Atlas& atlas, const Common& common,
                 const std::string& replay);

/// "52 cases are in out/atlas/index.html; 0 kernels fail".
std::string atlas_summary(const atlas::Atlas& atlas, const std::filesystem::path& path);

/// Every kernel's report, numbered or not, in the catalogue's order.
std::vector<CheckReport> reports_of(const atlas::Atlas& atlas);

} // namespace gnomon::cli
