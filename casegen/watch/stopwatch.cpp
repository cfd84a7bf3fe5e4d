#include "casegen/watch/stopwatch.h"

#include "casegen/measure/quantiles.h"
#include "casegen/measure/timing.h"
#include "casegen/standalone.h"

#include <algorithm>

namespace gnomon::watch {
namespace {

using measure::evaluations_per_thread;
using measure::timed_records;

constexpr std::size_t most_kept = 16; // loops
constexpr std::uint32_t least_threads = 1024, most_threads = 1 << 16;
constexpr double wanted_nanoseconds = 4e6; // of one dispatch: long beside its start
constexpr int floor_runs = 5;

struct Constants {
    std::uint32_t count, last, evaluations;
};

} // namespace

double Stopwatch::run(gpu::Kernel& kernel, std::uint32_t threads, bool reads_masks) {
    const Constants constants{threads, timed_records - 1, evaluations_per_thread};
    const gpu::Dispatch dispatch{.threads = {threads, 1, 1}, .constants = gpu::bytes_of(constants)};
    const double nanoseconds =
        reads_masks ? device_.run(kernel, {&inputs_.records, &inputs_.results, &inputs_.masks}, dispatch)
                    : device_.run(kernel, {&inputs_.records, &inputs_.results}, dispatch);
    return nanoseconds / (static_cast<double>(threads) * evaluations_per_thread);
}

/// Random samples: hostile ones may take a kernel's short cuts.
void Stopwatch::upload(const Case& c, const Subject& subject) {
    if (inputs_.kernel == &c) return;
    const Records& all = subject.records();
    const std::size_t begin = subject.random_begin() < all.size() ? subject.random_begin() : 0;
    Records records(c);
    records.reserve(timed_records);
    for (std::size_t i = 0; i < timed_records; ++i) {
        const std::size_t n = begin + i % (all.size() - begin);
        records.add(all.input(n), all.mask(n));
    }
    inputs_.records = device_.upload(records.words());
    inputs_.masks = device_.upload(records.masks());
    inputs_.results = device_.allocate(most_threads * sizeof(std::uint32_t));
    gpu::Kernel reads = device_.kernel(glsl::compile(glsl::Sources{}, repeated_source(c, Repeated::reads),
                                                     standalone_name, glsl::Stage::compute),
                                       c.name);
    run(reads, least_threads, false);
    std::vector<double> floors;
    for (int i = 0; i < floor_runs; ++i) floors.push_back(run(reads, most_threads, false));
    std::ranges::sort(floors);
    inputs_.floor = measure::quantile(floors, 0.5);
    inputs_.kernel = &c;
}

std::shared_ptr<Stopwatch::Loop> Stopwatch::make(const Case& c, const std::string& text) {
    auto loop = std::make_shared<Loop>();
    loop->text = text;
    loop->kernel =
        device_.kernel(glsl::compile_expanded(text, standalone_name, glsl::Stage::compute), c.name);
    run(loop->kernel, least_threads, c.reference.takes_mask); // holds the driver's compiler
    return loop;
}

std::shared_ptr<Stopwatch::Loop> Stopwatch::loop(const Case& c, const std::string& text) {
    const auto found = std::ranges::find(kept_, text, [](const auto& kept) { return kept->text; });
    if (found != kept_.end()) {
        kept_.splice(kept_.begin(), kept_, found);
    } else {
        kept_.push_front(make(c, text));
        if (kept_.size() > most_kept) kept_.pop_back();
    }
    return kept_.front();
}

Times Stopwatch::begin(const Case& c, Subject& subject, const TimeRequest& request,
                       const std::string& folder) {
    Times times;
    if (request.results != 0) {
        gpu::Kernel kernel = device_.kernel(compile_standalone_text(c, request.alone, folder), c.name);
        const Outputs outputs = run_standalone(device_, kernel, c, subject.records());
        times.same_results = hash_of(outputs.words) == request.results;
    }
    upload(c, subject);
    turns_ = {loop(c, request.before), loop(c, request.after), make(c, request.before)};
    double slowest = 0;
    for (const auto& turn : turns_)
        slowest = std::max(slowest,
                           run(turn->kernel, least_threads, c.reference.takes_mask) * evaluations_per_thread);
    const double threads = slowest > 0 ? wanted_nanoseconds / slowest : most_threads;
    threads_ = static_cast<std::uint32_t>(std::clamp<double>(threads, least_threads, most_threads)) /
               least_threads * least_threads;
    times.floor = inputs_.floor;
    return times;
}

Times Stopwatch::round(unsigned number) {
    std::array<double, 3> taken{};
    for (std::size_t i = 0; i < turns_.size(); ++i) {
        const std::size_t turn = (i + number) % turns_.size();
        taken[turn] = run(turns_[turn]->kernel, threads_, inputs_.kernel->reference.takes_mask);
    }
    Times times;
    times.before = taken[0];
    times.after = taken[1];
    times.again = taken[2];
    times.floor = inputs_.floor;
    return times;
}

} // namespace gnomon::watch
