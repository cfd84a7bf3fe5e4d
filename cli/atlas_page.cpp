#include "cli/atlas_page.h"

#include "casegen/atlas/page.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon::cli {

namespace fs = std::filesystem;
atlas::Options atlas_options(const Common& common) {
    atlas::Options options;
    options.check.kernels = common.kernels;
    options.check.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    options.check.worst = GNOMON_SOURCE_DIR "/fixtures/worst";
    options.check.device = common.device;
    return options;
}

fs::path require_atlas_folder(const fs::path& folder, const Common& common) {
    require_kernels(common.kernels);
    const gpu::Device device(common.device);
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    fs::path path = folder / "index.html";
    require_writable(path);
    return path;
}

void write_atlas(const fs::path& path, const atlas::Atlas& atlas, const Common& common,
                 const std::string& replay) {
    write_file(path, atlas::page(atlas, atlas::link_to_kernels(path.parent_path(), common.kernels), replay));
}

std::string atlas_summary(const atlas::Atlas& atlas, const fs::path& path) {
    std::size_t cases = 0;
    for (const atlas::FamilyEntries& family : atlas.families) cases += family.cases.size();
    const auto failed = std::ranges::count_if(
        reports_of(atlas), [](const CheckReport& report) { return !is_good(report.verdict); });
    return fmt::format("{} cases are in {}; {} kernels fail\n", cases, path.string(), failed);
}

std::vector<CheckReport> reports_of(const atlas::Atlas& atlas) {
    std::vector<CheckReport> reports;
    for (const atlas::FamilyEntries& family : atlas.families) {
        for (const Case& c : family.family->cases) {
            const auto is_c = [&](const CheckReport& report) { return report.kernel->name == c.name; };
            for (const atlas::Entry& entry : family.cases)
                if (is_c(entry.report)) reports.push_back(entry.report);
            for (const CheckReport& report : family.kernels)
                if (is_c(report)) reports.push_back(report);
        }
    }
    return reports;
}

} // namespace gnomon::cli
