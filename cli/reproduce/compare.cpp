#include "cli/reproduce/compare.h"

#include "cli/reproduce/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace gnomon::cli {
namespace {

struct Target {
    const char* technique;
    double share;    ///< of the printed count
    int largest_map; ///< beyond it counts are reported only
};
constexpr std::array targets{Target{"raytraced", 0.002, 4096}, Target{"nsm", 0.002, 4096},
                             Target{"beister", 0.002, 4096}, Target{"crsm", 0.002, 2048},
                             Target{"crsma", 0.005, 2048}};

bool is_printed_view(const std::string& name) {
    const auto& views = thesis_views();
    const auto found = std::ranges::find(views, name, &ThesisView::name);
    return found != views.end() && found->as_printed;
}

std::string size_of(const CountKey& key) {
    std::string text = fmt::format("{}x{}", key.width, key.height);
    if (key.map > 0) text += fmt::format(", map {}", key.map);
    return text;
}

std::string difference_text(const Compared& cell) {
    if (cell.printed.value == 0) return fmt::format("{:+d} pixels", static_cast<std::int64_t>(cell.ours));
    return fmt::format("{:+.3f} %", 100 * cell.difference());
}

std::string line(const Compared& cell) {
    const CountKey& key = cell.printed.key;
    return fmt::format("  {:<20} {:<10} {:<22} {:>9} {:>9}  {:>12}{}\n", size_of(key), key.technique,
                       key.quantity, cell.printed.value, cell.ours, difference_text(cell),
                       cell.holds() ? "" : "  missed");
}

} // namespace

double Compared::difference() const {
    const double apart = static_cast<double>(ours) - static_cast<double>(printed.value);
    return apart / std::max(1.0, static_cast<double>(printed.value));
}

bool Compared::holds() const {
    if (!share) return true;
    const double apart = std::abs(static_cast<double>(ours) - static_cast<double>(printed.value));
    return apart <= *share * static_cast<double>(printed.value) || apart <= few * static_cast<double>(pixels);
}

std::vector<Compared> compare_counts(const std::vector<PrintedCount>& printed, const Counts& ours) {
    std::vector<Compared> result;
    for (const PrintedCount& count : printed) {
        const auto found = ours.find(count.key);
        if (found == ours.end()) continue;
        const CountKey& key = count.key;
        Compared cell{count,
                      found->second,
                      static_cast<std::uint64_t>(key.width) * static_cast<std::uint64_t>(key.height),
                      {}};
        const auto target =
            std::ranges::find_if(targets, [&](const Target& t) { return key.technique == t.technique; });
        if (target != targets.end() && key.map <= target->largest_map && is_printed_view(key.view))
            cell.share = target->share;
        result.push_back(std::move(cell));
    }
    std::ranges::stable_sort(result, {}, [](const Compared& cell) { return cell.printed.table; });
    return result;
}

std::string compared_tables(const std::vector<Compared>& all) {
    std::string text;
    int table = 0;
    for (const Compared& cell : all) {
        if (cell.printed.table != table) {
            table = cell.printed.table;
            text += fmt::format("{}Table {}: {}\n  {:<20} {:<10} {:<22} {:>9} {:>9}  {:>12}\n",
                                text.empty() ? "" : "\n", table, cell.printed.key.view, "", "", "", "thesis",
                                "here", "difference");
        }
        text += line(cell);
    }
    return text;
}

std::string compared_summary(const std::vector<Compared>& all) {
    std::string text;
    for (const Target& target : targets) {
        std::size_t cells = 0, held = 0;
        double worst = 0;
        std::string missed;
        for (const Compared& cell : all) {
            if (!cell.share || cell.printed.key.technique != target.technique) continue;
            ++cells;
            if (cell.holds()) ++held;
            // A few pixels of a small count say nothing.
            if (static_cast<double>(cell.printed.value) > 0.01 * static_cast<double>(cell.pixels))
                worst = std::max(worst, std::abs(cell.difference()));
            if (!cell.holds())
                missed += fmt::format("  table {:>2}, {:<16}", cell.printed.table, cell.printed.key.view) +
                          line(cell);
        }
        text +=
            fmt::format("{:<10} {} of {} counts within {:g} %{}; of counts above 1 % of the image the worst "
                        "is {:.3f} % off\n",
                        target.technique, held, cells, 100 * target.share,
                        target.largest_map < 4096 ? fmt::format(" at maps up to {}", target.largest_map) : "",
                        100 * worst) +
            missed;
    }
    return text;
}

} // namespace gnomon::cli
