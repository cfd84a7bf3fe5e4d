#include "casegen/measure/moved.h"

#include "casegen/measure/pareto.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace gnomon::measure {
namespace {

/// How strictly two baselines may be compared.
struct Rules {
    bool same_machine = true, same_driver = true, same_compiler = true, same_yardstick = true;
};

std::string shown(double value) {
    return std::isinf(value) ? "inf" : value == 0 ? "0" : fmt::format("{:.3g}", value);
}

/// Digits enough to tell both apart.
std::string from_to(double before, double now) {
    for (int digits = 3; digits <= 17 && std::isfinite(before) && std::isfinite(now); ++digits) {
        std::string a = fmt::format("{:.{}g}", before, digits), b = fmt::format("{:.{}g}", now, digits);
        if (a != b) return a + " -> " + b;
    }
    return shown(before) + " -> " + shown(now);
}

/// NaN is larger than everything; it does not come from a file or a bench, but must not pass either.
double at_worst(double value) { return std::isnan(value) ? HUGE_VAL : value; }

bool is_another(double before, double now, const Rules& rules) {
    before = at_worst(before);
    now = at_worst(now);
    if (before == now) return false;
    return rules.same_driver || now > same_error * before || before > same_error * now;
}

void add_errors(std::vector<Move>& moves, const KernelRecord& before, const KernelRecord& now,
                const Rules& rules) {
    std::vector<std::string> parts;
    bool larger = false, worse = false, in_scale = false;
    const auto compare = [&](const char* name, double a, double b, bool counts) {
        if (!is_another(a, b, rules)) return;
        parts.push_back(fmt::format("{} {}", name, from_to(a, b)));
        a = at_worst(a);
        b = at_worst(b);
        if (b <= a) return;
        larger = true;
        if (counts && (std::isinf(b) || b - a > now.step)) worse = true;
    };
    const bool by_limit = before.over_limit && now.over_limit;
    compare("median error", before.error.median, now.error.median, !by_limit);
    compare("99 % error", before.error.p99, now.error.p99, !by_limit);
    compare("max error", before.error.most, now.error.most, !by_limit);
    in_scale = !parts.empty();
    if (by_limit) {
        const std::size_t told = parts.size();
        compare("median/κu", before.over_limit->median, now.over_limit->median, true);
        compare("99 %/κu", before.over_limit->p99, now.over_limit->p99, true);
        compare("max/κu", before.over_limit->most, now.over_limit->most, true);
        // Errors of one distribution by two measures: the second one is told where it decides, or alone.
        if (in_scale && !worse) parts.resize(told);
    }
    if (before.error.non_finite != now.error.non_finite) {
        parts.push_back(
            fmt::format("results not finite {} -> {}", before.error.non_finite, now.error.non_finite));
        if (now.error.non_finite > before.error.non_finite) larger = worse = true;
    }
    if (parts.empty()) return;
    const Change change = worse ? Change::worse : larger ? Change::changed : Change::better;
    moves.push_back({change, now.name, fmt::format("{}", fmt::join(parts, ", ")), false});
}

void add_time(std::vector<Move>& moves, std::size_t& times, const std::string& name,
              const std::optional<TimeRecord>& before, const std::optional<TimeRecord>& now,
              const Rules& rules) {
    if (!before || !now) return;
    ++times;
    const double low = before->ratio.interval.lower, high = before->ratio.interval.upper;
    const double ratio = now->ratio.median / before->ratio.median;
    // Of a time that is 0 or missing nothing can be said.
    if (!(low > 0) || !std::isfinite(high) || !std::isfinite(ratio) || !(ratio > 0)) return;
    const Interval interval{now->ratio.interval.lower / high, now->ratio.interval.upper / low};
    const double margin =
        std::max({rules.same_machine ? least_time_move : foreign_time_move, before->noise, now->noise});
    const Pace pace = pace_of(interval, margin, margin);
    if (pace != Pace::faster && pace != Pace::slower) return;
    const Change change = !rules.same_machine    ? Change::uncertain
                          : pace == Pace::slower ? Change::slower
                                                 : Change::faster;
    moves.push_back({change, name,
                     fmt::format("time {:.2f} of the baseline's ({:.2f} to {:.2f}), noise {:.0f} %", ratio,
                                 interval.lower, interval.upper, 100 * margin),
                     true});
}

void compare_kernels(Moved& result, const Baseline& before, const Baseline& now, const Rules& rules,
                     bool whole) {
    std::map<std::string, const KernelRecord*> known;
    for (const KernelRecord& kernel : before.kernels) known[kernel.name] = &kernel;
    for (const KernelRecord& kernel : now.kernels) {
        const auto found = known.find(kernel.name);
        if (found == known.end()) {
            result.moves.push_back({Change::added, kernel.name,
                                    fmt::format("is not in the baseline: max error {} {}, {} instructions",
                                                shown(kernel.error.most), kernel.unit, kernel.instructions),
                                    false});
            continue;
        }
        const KernelRecord& old = *found->second;
        known.erase(found);
        ++result.kernels;
        if (old.unit != kernel.unit || old.inputs != kernel.inputs) {
            result.moves.push_back({Change::changed, kernel.name,
                                    fmt::format("is measured on {} inputs in {}, was on {} in {}: its errors "
                                                "cannot be compared",
                                                kernel.inputs, kernel.unit, old.inputs, old.unit),
                                    false});
        } else {
            add_errors(result.moves, old, kernel, rules);
        }
        if (rules.same_compiler && old.instructions != kernel.instructions)
            result.moves.push_back(
                {Change::changed, kernel.name,
                 fmt::format("instructions {} -> {}", old.instructions, kernel.instructions), false});
        if (rules.same_yardstick)
            add_time(result.moves, result.times, kernel.name, old.time, kernel.time, rules);
    }
    if (whole)
        for (const KernelRecord& kernel : before.kernels)
            if (known.contains(kernel.name))
                result.moves.push_back({Change::removed, kernel.name, "is in the baseline alone", false});
}

void compare_technique(Moved& result, const std::string& name, const TechniqueRecord& before,
                       const TechniqueRecord& now, const Rules& rules) {
    constexpr double least_rmse = 1e-4; // below this no eye and no sum tells them apart
    const std::size_t was = before.wrong_lit + before.wrong_shadowed;
    const std::size_t is = now.wrong_lit + now.wrong_shadowed;
    std::vector<std::string> parts;
    if (before.wrong_lit != now.wrong_lit || before.wrong_shadowed != now.wrong_shadowed)
        parts.push_back(fmt::format("wrong pixels {} -> {} (lit {} -> {}, shadowed {} -> {})", was, is,
                                    before.wrong_lit, now.wrong_lit, before.wrong_shadowed,
                                    now.wrong_shadowed));
    const double rmse_was = at_worst(before.rmse), rmse_is = at_worst(now.rmse);
    if (is_another(rmse_was, rmse_is, rules)) parts.push_back("RMSE " + from_to(rmse_was, rmse_is));
    if (parts.empty()) return;
    const bool soft_worse = std::isinf(rmse_is) ? !std::isinf(rmse_was) : rmse_is > rmse_was + least_rmse;
    const bool soft_better = std::isinf(rmse_was) ? !std::isinf(rmse_is) : rmse_was > rmse_is + least_rmse;
    const Change change = is > was || (is == was && soft_worse)    ? Change::worse
                          : is < was || (is == was && soft_better) ? Change::better
                                                                   : Change::changed;
    result.moves.push_back({change, name, fmt::format("{}", fmt::join(parts, ", ")), false});
}

void compare_scenes(Moved& result, const Baseline& before, const Baseline& now, const Rules& rules,
                    bool whole) {
    for (const SceneRecord& scene : now.scenes) {
        const auto old = std::ranges::find(before.scenes, scene.scene, &SceneRecord::scene);
        if (old == before.scenes.end()) {
            result.moves.push_back({Change::added, scene.scene, "is a scene that the baseline lacks", false});
            continue;
        }
        if (old->width != scene.width || old->height != scene.height || old->shadow_map != scene.shadow_map ||
            old->facing != scene.facing) {
            result.moves.push_back(
                {Change::changed, scene.scene,
                 fmt::format("{}x{} pixels, shadow map {}, {} of them face the light; was {}x{}, {}, {}: its "
                             "techniques cannot be compared",
                             scene.width, scene.height, scene.shadow_map, scene.facing, old->width,
                             old->height, old->shadow_map, old->facing),
                 false});
            continue;
        }
        std::map<std::string, const TechniqueRecord*> known;
        for (const TechniqueRecord& technique : old->techniques) known[technique.name] = &technique;
        for (const TechniqueRecord& technique : scene.techniques) {
            const std::string name = scene.scene + ": " + technique.name;
            const auto found = known.find(technique.name);
            if (found == known.end()) {
                result.moves.push_back({Change::added, name, "is not in the baseline", false});
                continue;
            }
            ++result.techniques;
            compare_technique(result, name, *found->second, technique, rules);
            if (scene.yardstick == old->yardstick)
                add_time(result.moves, result.times, name, found->second->time, technique.time, rules);
            known.erase(found);
        }
        if (!whole) continue;
        for (const TechniqueRecord& technique : old->techniques)
            if (known.contains(technique.name))
                result.moves.push_back({Change::removed, scene.scene + ": " + technique.name,
                                        "is in the baseline alone", false});
    }
}

} // namespace

const char* to_string(Change change) {
    switch (change) {
    case Change::worse:
        return "WORSE";
    case Change::slower:
        return "SLOWER";
    case Change::uncertain:
        return "UNCERTAIN";
    case Change::better:
        return "BETTER";
    case Change::faster:
        return "FASTER";
    case Change::added:
        return "ADDED";
    case Change::removed:
        return "REMOVED";
    case Change::changed:
        break;
    }
    return "CHANGED";
}

bool is_bad(Change change) { return change == Change::worse || change == Change::slower; }

Moved moved(const Baseline& before, const Baseline& now, bool whole) {
    const Rules rules{before.machine == now.machine, before.driver == now.driver,
                      before.compiler == now.compiler, before.yardstick == now.yardstick};
    Moved result;
    compare_kernels(result, before, now, rules, whole);
    compare_scenes(result, before, now, rules, whole);
    if (!rules.same_driver)
        result.notes.push_back(fmt::format("the baseline is of another driver ({}; here {}): errors within a "
                                           "factor of {:g} count as equal",
                                           before.driver, now.driver, same_error));
    if (!rules.same_compiler)
        result.notes.push_back(fmt::format("the baseline is of other compilers ({}; here {}): instruction "
                                           "counts are not compared",
                                           before.compiler, now.compiler));
    if (result.times > 0 && !rules.same_machine)
        result.notes.push_back(
            fmt::format("the baseline is of another machine ({}; here {}): only times that "
                        "moved by more than {:.0f} % are told, and none decides",
                        before.machine, now.machine, 100 * foreign_time_move));
    constexpr unsigned least_rounds = 6; // fewer leave an interval of everything: see median_interval
    if (result.times > 0 && std::min(before.rounds, now.rounds) < least_rounds)
        result.notes.push_back(
            fmt::format("fewer than {} rounds (the baseline {}, now {}): no time can be told "
                        "from another",
                        least_rounds, before.rounds, now.rounds));
    if (!rules.same_yardstick && now.rounds > 0)
        result.notes.emplace_back("the baseline's times are over another yardstick: they are not compared");
    std::stable_partition(result.moves.begin(), result.moves.end(),
                          [](const Move& move) { return is_bad(move.change); });
    return result;
}

Moved confirmed(Moved first, const Moved& again) {
    std::erase_if(first.moves, [&](const Move& move) {
        return move.time && std::ranges::none_of(again.moves, [&](const Move& other) {
                   return other.time && other.name == move.name && other.change == move.change;
               });
    });
    return first;
}

std::string to_text(const Moved& moved, const std::string& name) {
    std::string text;
    for (const std::string& note : moved.notes) text += note + "\n";
    const std::string what =
        fmt::format("{} kernels{}{} against {}", moved.kernels,
                    moved.techniques > 0 ? fmt::format(" and {} techniques on scenes", moved.techniques) : "",
                    moved.times > 0 ? ", errors and times," : "", name);
    if (moved.moves.empty()) return text + fmt::format("nothing moved: {}\n", what);
    std::size_t width = 0;
    for (const Move& move : moved.moves) width = std::max(width, move.name.size());
    std::size_t bad = 0;
    for (const Move& move : moved.moves) {
        text += fmt::format("{:<9}  {:<{}}  {}\n", to_string(move.change), move.name, width, move.what);
        if (is_bad(move.change)) ++bad;
    }
    return text + fmt::format("{} moved, {} of them for the worse: {}\n", moved.moves.size(), bad, what);
}

} // namespace gnomon::measure
