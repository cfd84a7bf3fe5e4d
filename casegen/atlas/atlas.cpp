#include "casegen/atlas/atlas.h"

#include "casegen/atlas/picture.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

namespace gnomon::atlas {
namespace {

constexpr int points = 64; ///< per side of a witness texel

std::string text_or_nothing(const std::filesystem::path& path) {
    try {
        return read_file(path);
    } catch (const Error&) {
        return {}; // the check has said so
    }
}

/// Runs one kernel after another on a device that is replaced if one of them hangs it.
class Runner {
public:
    explicit Runner(const Options& options)
        : options_(options.check.device), sources_(kernel_sources(options.check.kernels)) {
        options_.isolated = true;
        device_.emplace(options_);
    }
    const gpu::Device& device() const { return *device_; }

    /// Nothing if the kernel cannot be run; then `trouble` says why.
    std::optional<Outputs> run(const Case& c, const Records& records, std::string& trouble) {
        try {
            return evaluate(*device_, sources_, c, records);
        } catch (const KernelTimeout& error) {
            trouble = error.what();
            device_.emplace(options_);
        } catch (const CompileError& error) {
            trouble = error.what();
        }
        return {};
    }

private:
    gpu::DeviceOptions options_;
    glsl::Sources sources_;
    std::optional<gpu::Device> device_;
};

/// It ran once already, and nothing speaks against running it again.
bool runs(const CheckReport& report) {
    return report.verdict != Verdict::compile_error && report.verdict != Verdict::timeout;
}

/// The smallest witness of the case; or, if nothing is to be seen there, of its first way on which something
/// is.
std::optional<Witness> telling_witness(const Entry& entry) {
    const Case& c = *entry.kernel;
    const auto varies = [&](const Witness& witness) {
        const ValueMap map = make_value_map(c, value_records(c, witness, points / 4), points / 4, nullptr);
        return std::ranges::any_of(map.want, [&](double v) { return v != map.want.front(); });
    };
    std::optional<Witness> smallest = smallest_witness(c);
    if (!smallest || varies(*smallest)) return smallest;
    for (const Way& way : entry.ways)
        if (varies(way.witness)) return way.witness;
    return smallest;
}

void add_values(Entry& entry, Runner& runner) {
    const Case& c = *entry.kernel;
    const Records records = value_records(c, *entry.witness, points);
    std::optional<Outputs> outputs;
    if (runs(entry.report)) outputs = runner.run(c, records, entry.trouble);
    entry.values = make_value_map(c, records, points, outputs ? &*outputs : nullptr);
}

/// All witnesses of a family by one dispatch of its assembled kernel.
void add_revectorized(FamilyEntries& family, const std::vector<CheckReport>& reports, Runner& runner) {
    const auto is_visibility = [&](const CheckReport& report) {
        return report.kernel->name == family.family->name + "/visibility";
    };
    const auto report = std::ranges::find_if(reports, is_visibility);
    if (report == reports.end()) return;
    const Case& visibility = *report->kernel;
    if (!runs(*report)) {
        family.trouble = report->message;
        return;
    }
    struct Picture {
        const Mask* mask;
        int scale;
        std::optional<Image>* image;
    };
    std::vector<Picture> pictures;
    for (Entry& entry : family.cases) {
        if (entry.witness) pictures.push_back({&entry.witness->mask, texel_pixels, &entry.revectorized});
        for (Way& way : entry.ways) pictures.push_back({&way.witness.mask, way_pixels, &way.revectorized});
    }
    if (pictures.empty()) return;
    Records records(visibility);
    std::vector<std::size_t> first;
    for (const Picture& picture : pictures) {
        first.push_back(records.size());
        add_mask_records(records, visibility, *picture.mask, picture.scale);
    }
    const std::optional<Outputs> outputs = runner.run(visibility, records, family.trouble);
    for (std::size_t i = 0; outputs && i < pictures.size(); ++i)
        *pictures[i].image = mask_image(visibility, *pictures[i].mask, pictures[i].scale, *outputs, first[i]);
}

void add_coverage(Entry& entry, const coverage::Coverage& coverage) {
    const std::string name = entry.kernel->name + ".glsl";
    for (const coverage::FileCoverage& file : coverage.files)
        if (file.name == name) entry.coverage = file;
    for (const coverage::KernelRun& run : coverage.kernels)
        if (run.kernel->name == entry.kernel->name && !run.trouble.empty() && runs(entry.report))
            entry.trouble = "With counters it " + run.trouble;
}

/// Found for the whole family at once.
void add_ways(FamilyEntries& family) {
    for (BranchWitness& found : branch_witnesses(*family.family)) {
        const auto entry = std::ranges::find(family.cases, found.branch.kernel, &Entry::kernel);
        if (entry == family.cases.end()) continue;
        std::vector<std::string> facts;
        for (const auto& [name, value] : found.branch.facts)
            facts.push_back(fmt::format("{}={}", name, value));
        entry->ways.push_back({fmt::format("{}", fmt::join(facts, " ")), std::move(found.witness), {}});
    }
}

} // namespace

bool Atlas::passes() const {
    const auto pass = [](const CheckReport& report) { return is_good(report.verdict); };
    return std::ranges::all_of(families, [&](const FamilyEntries& family) {
        return std::ranges::all_of(family.kernels, pass) &&
               std::ranges::all_of(family.cases, pass, &Entry::report);
    });
}

Atlas make_atlas(const std::vector<Family>& families, const Options& options,
                 const std::function<void(std::size_t)>& done) {
    std::vector<const Case*> kernels;
    for (const Family& family : families)
        for (const Case& c : family.cases) kernels.push_back(&c);
    const std::vector<CheckReport> reports = check(kernels, options.check, done);
    std::map<const Case*, const CheckReport*> report_of;
    for (const CheckReport& report : reports) report_of[report.kernel] = &report;

    Runner runner(options);
    Atlas atlas;
    atlas.device = runner.device().info().name;
    atlas.samples = options.check.samples;
    atlas.own_seeds = !options.check.seed;
    atlas.masks_seed = options.check.seed.value_or(default_seed("masks"));
    atlas.censuses = options.censuses;
    if (options.coverage) atlas.coverage = coverage::totals(*options.coverage);
    const EdgePool pool = make_edge_pool(atlas.masks_seed);
    atlas.masks = pool.masks.size();
    atlas.edge_texels = pool.entries.size();
    for (const Family& family : families) {
        FamilyEntries entries;
        entries.family = &family;
        for (const Case& c : family.cases) {
            if (c.number == 0) {
                entries.kernels.push_back(*report_of[&c]);
                continue;
            }
            Entry entry;
            entry.kernel = &c;
            entry.report = *report_of[&c];
            entry.text = text_or_nothing(options.check.kernels / (c.name + ".glsl"));
            entry.comment = leading_comment(entry.text);
            entry.share = corpus_share(c, pool);
            if (options.coverage) add_coverage(entry, *options.coverage);
            entries.cases.push_back(std::move(entry));
        }
        std::ranges::stable_sort(entries.cases, {}, [](const Entry& e) { return e.kernel->number; });
        if (!entries.cases.empty()) add_ways(entries);
        for (Entry& entry : entries.cases) {
            entry.witness = telling_witness(entry);
            if (entry.witness) add_values(entry, runner);
        }
        add_revectorized(entries, entries.kernels, runner);
        atlas.families.push_back(std::move(entries));
    }
    return atlas;
}

} // namespace gnomon::atlas
