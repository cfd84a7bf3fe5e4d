#include "casegen/measure/timing.h"

#include "casegen/measure/quantiles.h"
#include "casegen/measure/yardstick.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <thread>

namespace gnomon::measure {
namespace {

Timings time_on(gpu::Device& device, const Group& group, const LoopBuffers& buffers,
                const TimingOptions& options, const std::function<void()>& done) {
    const std::size_t count = group.variants.size();
    std::vector<Loop> loops; // every variant, the first one again, and the reading
    for (const Variant& variant : group.variants)
        loops.push_back(make_loop(device, *variant.kernel,
                                  kernel_sources(options.kernels, {}, variant.trigonometry), Repeated::calls,
                                  buffers));
    const Variant& first = group.variants.front();
    const glsl::Sources sources = kernel_sources(options.kernels, {}, first.trigonometry);
    loops.push_back(make_loop(device, *first.kernel, sources, Repeated::calls, buffers));
    loops.back().threads = loops.front().threads;
    loops.push_back(make_loop(device, *first.kernel, sources, Repeated::reads, buffers));

    Yardstick yardstick(device);
    std::vector<std::vector<double>> taken(loops.size());
    std::vector<double> yards;
    for (unsigned round = 0; round < options.rounds; ++round) {
        yards.push_back(yardstick.run());
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const std::size_t n = (i + round) % loops.size(); // each has its turn at being the first
            taken[n].push_back(run_once(device, loops[n], buffers));
        }
        if (done) done();
    }
    Timings timings;
    timings.floor = median_of(taken.back());
    timings.yardstick = median_of(yards);
    for (std::size_t n = 0; n < count; ++n) {
        const auto [least, most] = std::ranges::minmax(taken[n]);
        const auto net = [&](double gross) { return std::max(0.0, gross - timings.floor); };
        timings.variants.push_back(
            {net(median_of(taken[n])), net(least), net(most), ratio_of(taken[n], yards)});
    }
    std::vector<double> ratios, distances, spreads;
    for (const std::vector<double>& rounds : taken) {
        const double median = median_of(rounds);
        for (const double one : rounds) spreads.push_back(std::abs(one / median - 1));
    }
    timings.spread = median_of(std::move(spreads));
    for (std::size_t round = 0; round < taken[0].size(); ++round) {
        ratios.push_back(taken[count][round] / taken[0][round]);
        distances.push_back(std::abs(ratios.back() - 1));
    }
    timings.again = median_of(ratios);
    timings.again_spread = median_of(distances);
    return timings;
}

} // namespace

Ratio ratio_of(const std::vector<double>& times, const std::vector<double>& over) {
    std::vector<double> ratios;
    for (std::size_t round = 0; round < times.size(); ++round) ratios.push_back(times[round] / over[round]);
    if (ratios.empty() || !std::ranges::all_of(ratios, [](double r) { return std::isfinite(r); })) {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        return {nan, {nan, nan}};
    }
    return {median_of(ratios), median_interval(ratios, 0.95)};
}

double Timings::noise() const { return std::max({least_noise, std::abs(again - 1), again_spread, spread}); }

std::vector<Timings> time_variants(gpu::Device& device, const Group& group, const Inputs& inputs,
                                   const TimingOptions& options, const std::function<void()>& done) {
    std::vector<std::size_t> ordinary, all;
    for (std::size_t i = 0; i < inputs.records.size(); ++i) {
        all.push_back(i);
        if (!inputs.places[i]) ordinary.push_back(i);
    }
    const Case& c = *group.variants.front().kernel;
    std::vector<Timings> sets;
    const auto add = [&](const char* name, const std::vector<std::size_t>& chosen) {
        sets.push_back(time_on(
            device, group, upload_for_loops(device, c, inputs.records, chosen, options.seed), options, done));
        sets.back().inputs = name;
    };
    if (!ordinary.empty()) add("ordinary", ordinary);
    if (ordinary.size() < all.size()) add("all classes", all);
    return sets;
}

std::string machine(const gpu::Device& device) {
    std::ifstream file("/proc/cpuinfo");
    std::string processor = "unknown processor";
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) {
            processor = line.substr(std::min(line.find(':') + 2, line.size()));
            break;
        }
    return fmt::format("{}, {} threads; {}", processor, std::thread::hardware_concurrency(),
                       device.info().name);
}

} // namespace gnomon::measure
