#include "casegen/watch/stopwatch.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace gnomon::watch {
namespace {

constexpr std::size_t most_kept = 16;
constexpr double wanted_nanoseconds = 4e6; // of one dispatch

} // namespace

void Stopwatch::upload(const Case& c, const Subject& subject) {
    if (kernel_ == &c) return;
    // Random samples: hostile ones may take a kernel's short cuts.
    const std::size_t count = subject.records().size();
    const std::size_t begin = subject.random_begin() < count ? subject.random_begin() : 0;
    std::vector<std::size_t> chosen(count - begin);
    std::iota(chosen.begin(), chosen.end(), begin);
    buffers_ = measure::upload_for_loops(device_, c, subject.records(), chosen, default_seed(c));
    reads_ = measure::make_loop(device_, c, glsl::Sources{}, Repeated::reads, buffers_, wanted_nanoseconds);
    kernel_ = &c;
}

std::shared_ptr<Stopwatch::Kept> Stopwatch::make(const Case& c, const std::string& text) {
    auto kept = std::make_shared<Kept>();
    kept->text = text;
    kept->loop =
        measure::make_loop(device_, c, glsl::compile_expanded(text, standalone_name, glsl::Stage::compute),
                           Repeated::calls, buffers_, wanted_nanoseconds);
    kept->threads = kept->loop.threads;
    return kept;
}

std::shared_ptr<Stopwatch::Kept> Stopwatch::find(const Case& c, const std::string& text) {
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
        times.same_results = hash_of(c, outputs.words) == request.results;
    }
    upload(c, subject);
    turns_ = {find(c, request.before), find(c, request.after), make(c, request.before)};
    // All of one size: the start of a dispatch is part of its time.
    const auto threads = [](const auto& turn) { return turn->threads; };
    const std::uint32_t fewest = threads(*std::ranges::min_element(turns_, {}, threads));
    for (const auto& turn : turns_) turn->loop.threads = fewest;
    reads_.threads = fewest;
    return times;
}

Times Stopwatch::round(unsigned number) {
    const std::array<measure::Loop*, 4> loops{&turns_[0]->loop, &turns_[1]->loop, &turns_[2]->loop, &reads_};
    std::array<double, 4> taken{};
    for (std::size_t i = 0; i < loops.size(); ++i) {
        const std::size_t turn = (i + number) % loops.size();
        taken[turn] = measure::run_once(device_, *loops[turn], buffers_);
    }
    Times times;
    times.before = taken[0];
    times.after = taken[1];
    times.again = taken[2];
    times.floor = taken[3];
    return times;
}

} // namespace gnomon::watch
