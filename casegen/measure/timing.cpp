#include "casegen/measure/timing.h"

#include "casegen/measure/quantiles.h"
#include "casegen/standalone.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <thread>

namespace gnomon::measure {
namespace {

constexpr std::uint32_t least_threads = 1024, most_threads = 1 << 16;
constexpr double wanted_nanoseconds = 8e6; // of one dispatch: long beside its start, short beside a hiccup

struct Constants {
    std::uint32_t count, last, evaluations;
};

/// A kernel in a loop, and what it reads and writes.
struct Loop {
    gpu::Kernel kernel;
    bool reads_masks = false;
    std::uint32_t threads = least_threads;
};

struct Buffers {
    gpu::Buffer records, masks, results;
};

double run_once(gpu::Device& device, Loop& loop, const Buffers& buffers) {
    const Constants constants{loop.threads, timed_records - 1, evaluations_per_thread};
    const gpu::Dispatch dispatch{.threads = {loop.threads, 1, 1}, .constants = gpu::bytes_of(constants)};
    const double nanoseconds =
        loop.reads_masks
            ? device.run(loop.kernel, {&buffers.records, &buffers.results, &buffers.masks}, dispatch)
            : device.run(loop.kernel, {&buffers.records, &buffers.results}, dispatch);
    return nanoseconds / (static_cast<double>(loop.threads) * evaluations_per_thread);
}

/// Compiles; runs once for the driver's compiler, and once more to see how many threads make a dispatch long
/// enough.
Loop make_loop(gpu::Device& device, const Variant& variant, const glsl::Sources& sources, Repeated what,
               const Buffers& buffers) {
    const Case& c = *variant.kernel;
    Loop loop{
        device.kernel(glsl::compile(sources, repeated_source(c, what), standalone_name, glsl::Stage::compute),
                      c.name),
        what == Repeated::calls && c.reference.takes_mask, least_threads};
    run_once(device, loop, buffers);
    const double one = run_once(device, loop, buffers) * evaluations_per_thread;
    const double threads = one > 0 ? wanted_nanoseconds / one : most_threads;
    loop.threads = static_cast<std::uint32_t>(std::clamp<double>(threads, least_threads, most_threads)) /
                   least_threads * least_threads;
    return loop;
}

/// `timed_records` of the chosen inputs, drawn anew each: a few of many, or many times a few.
Buffers upload(gpu::Device& device, const Case& c, const Inputs& inputs,
               const std::vector<std::size_t>& chosen, std::uint64_t seed) {
    Records records(c);
    records.reserve(timed_records);
    Random random(seed);
    for (std::uint32_t i = 0; i < timed_records; ++i) {
        const std::size_t n = chosen[random.below(static_cast<std::uint32_t>(chosen.size()))];
        records.add(inputs.records.input(n), inputs.records.mask(n));
    }
    return {device.upload(records.words()), device.upload(records.masks()),
            device.allocate(most_threads * sizeof(std::uint32_t))};
}

double median_of(std::vector<double> values) {
    std::ranges::sort(values);
    return quantile(values, 0.5);
}

Timings time_on(gpu::Device& device, const Group& group, const Buffers& buffers, const TimingOptions& options,
                const std::function<void()>& done) {
    const std::size_t count = group.variants.size();
    std::vector<Loop> loops; // every variant, the first one again, and the reading
    for (const Variant& variant : group.variants)
        loops.push_back(make_loop(device, variant, kernel_sources(options.kernels, {}, variant.trigonometry),
                                  Repeated::calls, buffers));
    const Variant& first = group.variants.front();
    const glsl::Sources sources = kernel_sources(options.kernels, {}, first.trigonometry);
    loops.push_back(make_loop(device, first, sources, Repeated::calls, buffers));
    loops.back().threads = loops.front().threads;
    loops.push_back(make_loop(device, first, sources, Repeated::reads, buffers));

    std::vector<std::vector<double>> taken(loops.size());
    for (unsigned round = 0; round < options.rounds; ++round) {
        for (std::size_t i = 0; i < loops.size(); ++i) {
            const std::size_t n = (i + round) % loops.size(); // each has its turn at being the first
            taken[n].push_back(run_once(device, loops[n], buffers));
        }
        if (done) done();
    }
    Timings timings;
    timings.floor = median_of(taken.back());
    for (std::size_t n = 0; n < count; ++n) {
        const auto [least, most] = std::ranges::minmax(taken[n]);
        const auto net = [&](double gross) { return std::max(0.0, gross - timings.floor); };
        timings.variants.push_back({net(median_of(taken[n])), net(least), net(most)});
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
        sets.push_back(
            time_on(device, group, upload(device, c, inputs, chosen, options.seed), options, done));
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
