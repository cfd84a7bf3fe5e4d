#include "casegen/watch/timekeeper.h"

#include "casegen/measure/quantiles.h"
#include "casegen/watch/clock.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace gnomon::watch {
namespace {

constexpr unsigned timed_rounds = 12;

} // namespace

Timekeeper::Timekeeper(const Shared& shared, const std::function<void(const Event&)>& tell)
    : shared_(shared), tell_(tell), child_(start_stopwatch(shared)) {}

double Timekeeper::patience() const { return 2 * compile_patience + 16 * shared_.options.device.time_limit; }

void Timekeeper::want(std::size_t edit, TimeRequest request) {
    Timing timing;
    timing.edit = edit;
    timing.request = std::move(request);
    wanted_.push_back(std::move(timing));
}

void Timekeeper::forget(std::size_t kernel) {
    std::erase_if(wanted_, [&](const Timing& timing) { return timing.request.kernel == kernel; });
    if (!now_ || now_->request.kernel != kernel) return;
    if (now_->waits)
        now_.reset();
    else
        now_->outdated = true;
}

void Timekeeper::send(const TimeRequest& request) {
    now_->sent = seconds_now();
    now_->waits = false;
    child_.send(format(request));
}

void Timekeeper::go_on() {
    if (now_) {
        if (!now_->waits) return;
        TimeRequest request;
        request.what = TimeRequest::What::round;
        request.kernel = now_->request.kernel;
        request.round = static_cast<unsigned>(now_->times.a.size());
        send(request);
        return;
    }
    if (wanted_.empty()) return;
    now_ = std::move(wanted_.front());
    wanted_.pop_front();
    send(now_->request);
}

void Timekeeper::hear() {
    const Answer answer = child_.receive(absence);
    if (answer.kind == Answer::Kind::late) return;
    if (answer.kind == Answer::Kind::error) throw Error("{}", answer.text);
    if (answer.kind == Answer::Kind::death) {
        child_ = start_stopwatch(shared_);
        end("the process that timed it died: " + answer.text);
        return;
    }
    const Times times = parse_times(answer.text);
    if (times.device_lost) child_ = start_stopwatch(shared_);
    if (!now_) return;
    if (!times.cannot.empty() || now_->outdated)
        end(times.cannot);
    else
        take(times);
}

void Timekeeper::take(const Times& times) {
    if (!now_->begun) {
        now_->begun = true;
        now_->same_results = times.same_results;
    } else {
        now_->times.a.push_back(times.before);
        now_->times.b.push_back(times.after);
        now_->times.again.push_back(times.again);
        now_->reading.push_back(times.floor);
    }
    if (now_->times.a.size() < timed_rounds) {
        now_->waits = true;
        return;
    }
    try {
        tell_times();
        now_.reset();
    } catch (const Error& error) {
        end(error.what());
    }
}

/// Throws Error if the device's clock stood still.
void Timekeeper::tell_times() {
    measure::PairedTimes& times = now_->times;
    Timed told;
    told.kernel = shared_.cases[now_->request.kernel];
    told.edit = now_->edit;
    told.before = measure::median_of(times.a);
    told.after = measure::median_of(times.b);
    told.reading = measure::median_of(now_->reading);
    times.floor = told.reading;
    told.pace = measure::judge_times(times);
    told.with_reading = told.pace.with_floor;
    told.same_results = now_->same_results;
    tell_(told);
}

void Timekeeper::end(const std::string& why) {
    if (now_ && !now_->outdated) tell_(NotTimed{shared_.cases[now_->request.kernel], now_->edit, why});
    now_.reset();
}

double Timekeeper::deadline() const { return now_ && !now_->waits ? now_->sent + patience() : never; }

void Timekeeper::end_if_overdue(double now) {
    if (now <= deadline()) return;
    child_ = start_stopwatch(shared_);
    end(fmt::format("not timed within {:.0f} s", patience()));
}

} // namespace gnomon::watch
