#include "casegen/measure/paired.h"

#include "casegen/measure/loop.h"
#include "casegen/measure/quantiles.h"
#include "runtime/clock.h"
#include "runtime/error.h"

#include <algorithm>
#include <array>

namespace gnomon::measure {
namespace {

constexpr double dispatch_nanoseconds = 4e6; // many short rounds, so that a hiccup costs few of them
constexpr std::size_t floor_rounds = 16;     // reading is only taken off: it needs no more

/// A, B, A again, in one of their six orders.
std::array<std::size_t, 3> order_of(std::uint64_t seed, std::size_t round) {
    std::array<std::size_t, 3> order{0, 1, 2};
    for (std::uint32_t n = Random(seed, round).below(6); n > 0; --n) std::ranges::next_permutation(order);
    return order;
}

} // namespace

Pairing time_pair(gpu::Device& device, const Contestant& a, const Contestant& b, const Records& records,
                  std::span<const std::size_t> chosen, const PairingOptions& options) {
    if (chosen.empty()) throw Error("{}: no input in its domain to time it on", a.kernel->name);
    const LoopBuffers buffers = upload_for_loops(device, *a.kernel, records, chosen, options.seed);
    std::vector<Loop> loops;
    const auto add = [&](const Contestant& side, Repeated what) {
        loops.push_back(make_loop(device, *side.kernel, side.sources, what, buffers, dispatch_nanoseconds));
    };
    add(a, Repeated::calls);
    add(b, Repeated::calls);
    add(a, Repeated::calls);
    add(a, Repeated::reads);
    // The start of a dispatch is shared by its evaluations: as many for each.
    const std::uint32_t threads = std::min({loops[0].threads, loops[1].threads, loops[2].threads});
    for (Loop& loop : loops) loop.threads = threads;
    for (Loop& loop : loops) run_once(device, loop, buffers); // pages, caches

    PairedTimes times;
    const std::array<std::vector<double>*, 3> taken{&times.a, &times.b, &times.again};
    std::vector<double> floors;
    Pairing pairing;
    PaceOptions pace = options.pace;
    const double begin = seconds_now();
    const auto spent = [&] {
        return options.rounds ? times.a.size() >= *options.rounds : seconds_now() - begin >= options.seconds;
    };
    for (bool ended = false; !ended;) {
        for (const std::size_t n : order_of(options.seed, times.a.size()))
            taken[n]->push_back(run_once(device, loops[n], buffers));
        if (floors.size() < floor_rounds) floors.push_back(run_once(device, loops[3], buffers));
        ended = spent();
        if (!ended && (options.rounds || times.a.size() < rounds_at(pairing.looks + 1))) continue;
        pace.look = options.rounds ? 0 : ++pairing.looks;
        times.floor = median_of(floors);
        pairing.verdict = judge_times(times, pace);
        ended = ended || settled(pairing.verdict, pace);
    }
    pairing.seconds = seconds_now() - begin;
    pairing.floor = times.floor;
    pairing.a = std::max(0.0, median_of(times.a) - times.floor);
    pairing.b = std::max(0.0, median_of(times.b) - times.floor);
    return pairing;
}

} // namespace gnomon::measure
