// What edits cost: the states before and after one, timed in turns by a process of their own, one edit at a
// time.
#pragma once

#include "casegen/measure/verdict.h"
#include "casegen/watch/event.h"
#include "casegen/watch/workers.h"

#include <deque>
#include <functional>
#include <optional>
#include <vector>

namespace gnomon::watch {

class Timekeeper {
public:
    /// Both outlive it.
    Timekeeper(const Shared& shared, const std::function<void(const Event&)>& tell);

    /// Asks for the times of an edit, after those that are asked for already.
    void want(std::size_t edit, TimeRequest request);
    /// What is known or asked of a kernel is of a state that is no more.
    void forget(std::size_t kernel);
    /// The next round of what is being timed, or else the next edit: called while no verdict is due, so that
    /// neither disturbs the other.
    void go_on();
    bool is_idle() const { return !now_ && wanted_.empty(); }

    /// Readable when hear() has something to hear.
    int descriptor() const { return child_.descriptor(); }
    /// Tells of an edit's times when there are enough. Throws Error if its process cannot even start.
    void hear();
    double deadline() const;
    void end_if_overdue(double now);

private:
    struct Timing {
        std::size_t edit = 0;
        TimeRequest request;
        bool begun = false, outdated = false, waits = false; ///< `waits`: its process does, for a round
        double sent = 0;
        measure::PairedTimes times;
        std::vector<double> reading;
        bool same_results = true;
    };
    double patience() const;
    void send(const TimeRequest& request);
    void take(const Times& times);
    void tell_times();
    void end(const std::string& why);

    const Shared& shared_;
    const std::function<void(const Event&)>& tell_;
    Child child_;
    std::deque<Timing> wanted_;
    std::optional<Timing> now_;
};

} // namespace gnomon::watch
