#include "casegen/atlas/frequency.h"

#include "casegen/mask_families.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/one_line.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace gnomon::atlas {
namespace {

const Family* family_named(const std::string& name) {
    const auto found = std::ranges::find(catalogue(), name, &Family::name);
    return found == catalogue().end() ? nullptr : &*found;
}

/// The number that a key is, if the family has a case of it.
unsigned number_of(const Family& family, const std::string& key, const std::string& file) {
    unsigned number = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (error != std::errc{} || end != key.data() + key.size() || number == 0 ||
        std::ranges::count(family.cases, number, &Case::number) == 0)
        throw Error("'{}': \"{}\" has no case \"{}\"", file, family.name, one_line(key));
    return number;
}

} // namespace

CorpusShare corpus_share(const Case& c, const EdgePool& pool) {
    std::vector<double> edges(pool.masks.size()), applied(pool.masks.size());
    for (const EdgePool::Entry& entry : pool.entries) {
        edges[entry.mask] += 1;
        if (applies(c, entry.edge())) applied[entry.mask] += 1;
    }
    CorpusShare share;
    const std::size_t families = mask_families().size(), members = pool.masks.size() / families;
    double all_edges = 0, all_applied = 0, sum = 0, squares = 0, masks = 0;
    for (std::size_t family = 0; family < families; ++family) {
        double family_sum = 0, family_masks = 0;
        for (std::size_t mask = family * members; mask < (family + 1) * members; ++mask) {
            if (edges[mask] == 0) continue;
            const double of_mask = applied[mask] / edges[mask];
            family_sum += of_mask;
            family_masks += 1;
            squares += of_mask * of_mask;
            all_edges += edges[mask];
            all_applied += applied[mask];
        }
        share.by_family.push_back(family_masks > 0 ? family_sum / family_masks : 0);
        sum += family_sum;
        masks += family_masks;
    }
    if (masks == 0) return share;
    share.overall = all_applied / all_edges;
    share.mean = sum / masks;
    if (masks > 1) // the sample's, as everywhere
        share.deviation = std::sqrt(std::max(0.0, (squares - masks * share.mean * share.mean) / (masks - 1)));
    return share;
}

Census read_census(const std::filesystem::path& path) {
    const std::string file = path.string();
    nlohmann::json json = nlohmann::json::parse(read_file(path), nullptr, false);
    if (json.is_object() && json.contains("shares")) json = nlohmann::json(json["shares"]);
    if (!json.is_object())
        throw Error("'{}' is not a census: {{ \"FAMILY\": {{ \"NUMBER\": SHARE }} }} is needed", file);
    Census census{path.stem().string(), {}};
    for (const auto& [name, numbers] : json.items()) {
        const Family* family = family_named(name);
        if (!family || !numbers.is_object())
            throw Error("'{}': no family \"{}\" with numbers", file, one_line(name));
        for (const auto& [key, value] : numbers.items()) {
            const double share = value.is_number() ? value.get<double>() : -1;
            if (!(share >= 0 && share <= 1))
                throw Error("'{}': the share of {} {} is not a number from 0 to 1", file, name,
                            one_line(key));
            census.shares[name][number_of(*family, key, file)] = share;
        }
    }
    return census;
}

} // namespace gnomon::atlas
