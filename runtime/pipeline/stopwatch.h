// Times of a frame's steps over several frames.
#pragma once

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>
#include <vector>

namespace gnomon {

struct Step {
    std::string name;
    double milliseconds = 0; ///< median over frames, the first one discarded
};

/// 0 of none.
inline double median(std::vector<double> times) {
    std::ranges::sort(times);
    const std::size_t n = times.size();
    return n == 0 ? 0 : n % 2 == 1 ? times[n / 2] : 0.5 * (times[n / 2 - 1] + times[n / 2]);
}

/// Without the first of several, which holds compilation.
inline double median_of_later(std::vector<double> times) {
    if (times.size() > 1) times.erase(times.begin());
    return median(std::move(times));
}

/// Step times of several frames, in the order in which steps first happened.
class Stopwatch {
public:
    using Clock = std::chrono::steady_clock;

    void add(const std::string& step, double milliseconds) {
        const auto known = std::ranges::find(steps_, step, &Samples::name);
        (known == steps_.end() ? steps_.emplace_back(Samples{step, {}}) : *known)
            .milliseconds.push_back(milliseconds);
    }

    /// Runs it and adds what the clock on the wall says: for steps that host and device share.
    template <typename Work>
    void time(const std::string& step, Work&& work) {
        const Clock::time_point start = Clock::now();
        work();
        add(step, std::chrono::duration<double, std::milli>(Clock::now() - start).count());
    }

    std::vector<Step> medians() const { return each(median_of_later); }
    /// Of a watch that saw no first frame.
    std::vector<Step> medians_of_all() const { return each(median); }

private:
    struct Samples {
        std::string name;
        std::vector<double> milliseconds;
    };
    std::vector<Samples> steps_;

    template <typename Of>
    std::vector<Step> each(Of&& of) const {
        std::vector<Step> result;
        for (const Samples& step : steps_) result.push_back({step.name, of(step.milliseconds)});
        return result;
    }
};

} // namespace gnomon
