#include "casegen/measure/hybrid/bench.h"

#include "runtime/error.h"
#include "runtime/pipeline/judge.h"

#include <algorithm>

namespace gnomon::measure {
namespace {

Technique technique_called(const std::string& name) {
    if (name == auto_name) return {.kind = Technique::Kind::automatic, .name = name};
    return {.kind = Technique::Kind::hybrid,
            .name = name == raytraced_name ? hybrid_techniques().front().name : name};
}

bool is_exact(const std::string& name) {
    const HybridTechnique* known = find_hybrid(name);
    return known == nullptr || known->sound; // raytraced and auto are
}

/// raytraced, and what was asked for in the order of the list, auto last.
std::vector<std::string> names_of(const HybridBenchOptions& options) {
    std::vector<std::string> names{raytraced_name};
    const auto wanted = [&](const std::string& name) {
        return options.techniques.empty() ||
               std::ranges::find(options.techniques, name) != options.techniques.end();
    };
    for (const HybridTechnique& technique : hybrid_techniques())
        if (&technique != &hybrid_techniques().front() && wanted(technique.name))
            names.push_back(technique.name);
    if (wanted(auto_name)) names.emplace_back(auto_name);
    return names;
}

double milliseconds_of(const std::vector<gnomon::Step>& steps, const char* name) {
    const auto found = std::ranges::find(steps, name, &gnomon::Step::name);
    return found == steps.end() ? 0 : found->milliseconds;
}

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

} // namespace

FrameCost HybridRow::cost() const {
    return {times.milliseconds, milliseconds_of(times.steps, "trace"), times.frame.rays};
}

double HybridRow::uncertain_share() const { return share(times.frame.rays, times.frame.facing); }
double HybridRow::wrong_share() const { return share(wrong, times.frame.facing); }

const HybridRow& HybridCombination::best_exact() const {
    const HybridRow* best = &rows.front();
    for (const HybridRow& row : rows)
        if (row.exact && row.technique != auto_name && row.times.milliseconds < best->times.milliseconds)
            best = &row;
    return *best;
}

const HybridRow* HybridCombination::automatic() const {
    const auto found = std::ranges::find(rows, auto_name, &HybridRow::technique);
    return found == rows.end() ? nullptr : &*found;
}

std::string shown_name(const std::string& technique) {
    return technique == hybrid_techniques().front().name ? raytraced_name : technique;
}

void require_hybrids(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (name == raytraced_name || name == auto_name || find_hybrid(name) != nullptr) continue;
        std::string known = raytraced_name;
        for (const HybridTechnique& technique : hybrid_techniques()) known += ", " + technique.name;
        throw Error("\"{}\" is no hybrid technique; there are {}, {}", name, known, auto_name);
    }
}

HybridCombination measure_combination(Renderer& renderer, const HybridBenchOptions& options) {
    require_hybrids(options.techniques);
    const Rendering truth = renderer.render({Technique::Kind::raytraced, raytraced_name}, 1);
    const std::vector<std::string> names = names_of(options);
    HybridCombination result;
    result.bvh = milliseconds_of(truth.steps, "build BVH");
    const bool automatic = names.back() == auto_name;
    if (automatic) result.choice = renderer.choice();
    std::vector<Technique> techniques;
    for (const std::string& name : names) techniques.push_back(technique_called(name));
    std::vector<TechniqueTimes> times = renderer.time_techniques(techniques, options.rounds);
    for (std::size_t i = 0; i < names.size(); ++i) {
        HybridRow row{.technique = names[i], .exact = is_exact(names[i]), .times = std::move(times[i])};
        row.wrong = count_differing(row.times.visibility, truth.visibility);
        row.times.visibility = {}; // judged: a bench of many combinations keeps no images
        result.rows.push_back(std::move(row));
    }
    for (HybridRow& row : result.rows)
        row.break_even = break_even_nanoseconds(row.cost(), result.rows[0].cost());
    result.facing = result.rows.front().times.frame.facing;
    return result;
}

std::vector<std::string> broken_promises(const HybridBench& bench) {
    std::vector<std::string> lines;
    for (const HybridCombination& c : bench.combinations)
        for (const HybridRow& row : c.rows)
            if (row.exact && row.wrong > 0)
                lines.push_back(fmt::format("WRONG: {} promises the ray tracer's image; at {}x{} with shadow "
                                            "map {}, {} pixels differ",
                                            row.technique, c.width, c.height, c.shadow_map, row.wrong));
    return lines;
}

} // namespace gnomon::measure
