#include "cli/atlas_page.h"

#include "casegen/atlas/page.h"
#include "runtime/error.h"
#include "runtime/files.h"

namespace gnomon::cli {
namespace {

namespace fs = std::filesystem;

std::string link_to_kernels(const fs::path& folder, const fs::path& kernels) {
    const fs::path target = fs::canonical(kernels);
    const fs::path link = target.lexically_relative(fs::canonical(folder));
    const fs::path from_repository = fs::canonical(folder).lexically_relative(target.parent_path());
    const bool inside = !from_repository.empty() && *from_repository.begin() != "..";
    return inside ? link.generic_string() : std::string();
}

} // namespace

atlas::Options atlas_options(const Common& common) {
    atlas::Options options;
    options.check.kernels = common.kernels;
    options.check.pins = GNOMON_SOURCE_DIR "/fixtures/pins";
    options.check.device = common.device;
    return options;
}

fs::path require_atlas_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Error("{}: cannot be made a folder: {}", folder.string(), error.message());
    fs::path path = folder / "index.html";
    require_writable(path);
    return path;
}

void write_atlas(const fs::path& path, const atlas::Atlas& atlas, const Common& common,
                 const std::string& replay) {
    write_file(path, atlas::page(atlas, link_to_kernels(path.parent_path(), common.kernels), replay));
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
