#include "casegen/watch/session.h"

#include "casegen/fuzz/regression.h"
#include "casegen/measure/quantiles.h"
#include "casegen/watch/texts.h"
#include "casegen/watch/workers.h"
#include "runtime/error.h"
#include "runtime/folder_watch.h"
#include "runtime/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <deque>
#include <filesystem>
#include <limits>
#include <map>
#include <set>
#include <thread>
#include <utility>
#include <vector>

#include <poll.h>

namespace gnomon::watch {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Seconds.
constexpr double quiet = 0.002; ///< after a change, until what belongs to it has come too
constexpr double longest_settling = 0.05;
constexpr double absence = 0.1;         ///< a file that is gone for so long is gone: editors rename
constexpr double overdue = 0.5;         ///< a worker that is busy with an outdated state for so long is ended
constexpr double stealing = 0.25;       ///< so long a kernel waits for its own worker
constexpr double first_patience = 300;  ///< truths may have to be computed
constexpr double compile_patience = 20; ///< besides what dispatches may take

constexpr unsigned timed_rounds = 12;

double seconds_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Waits for one of the descriptors (negative ones are passed over), or so many seconds.
void wait_for(std::vector<pollfd>& polled, double seconds) {
    const int milliseconds = seconds > 1e5 ? -1 : static_cast<int>(std::max(seconds, 0.0) * 1000 + 0.999);
    if (::poll(polled.data(), polled.size(), milliseconds) < 0) {
        if (errno != EINTR) throw Error("waiting for changes failed: {}", std::strerror(errno));
        for (pollfd& entry : polled) entry.revents = 0;
    }
}

/// A kernel, and what is known of it.
struct Watched {
    const Case* kernel = nullptr;
    Texts now;
    bool due = false; ///< `now` waits for a worker
    double since = 0; ///< when it changed
    std::size_t edit = 0;
    std::optional<std::size_t> home; ///< the worker that holds its samples

    bool known = false, good = false;
    Texts ran; ///< the last state that ran to its end and was told; none ran if its texts are empty
    std::optional<Judgement> of_ran;
    bool tells_of_ran = false; ///< what was told last is of that state
};

struct Worker {
    Child child;
    std::optional<std::size_t> kernel; ///< at which it is
    Texts texts;                       ///< of it
    double sent = 0;
};

/// A kernel whose time is to be taken, or being taken.
struct Timing {
    std::size_t kernel = 0, edit = 0;
    TimeRequest request;
    bool begun = false, outdated = false;
    double sent = 0;
    measure::PairedTimes times;
    std::vector<double> reading;
    bool same_results = true;
};

class Session {
public:
    Session(std::span<const Case* const> cases, const SessionOptions& options,
            const std::function<void(const Event&)>& tell)
        : options_(options), tell_(tell),
          folder_(options.check.kernels,
                  options.poll ? FolderWatch::How::polling : FolderWatch::How::inotify_if_possible),
          texts_(options.check.kernels) {
        shared_.cases.assign(cases.begin(), cases.end());
        shared_.options = options.check;
        shared_.options.device.isolated = false; // a process each
        shared_.folder = texts_.name();
        shared_.replay = options.replay;
        for (const Case* c : cases) shared_.regressions[c->name];
        for (const auto& [name, all] : fuzz::load_regressions(options.check.regressions))
            for (const fuzz::Regression& regression : all)
                shared_.regressions[name].push_back(regression.input);
        shared_.pool = std::make_shared<const EdgePool>(
            make_edge_pool(options.check.seed.value_or(default_seed("masks"))));
        kernels_.resize(cases.size());
        for (std::size_t k = 0; k < cases.size(); ++k) kernels_[k].kernel = cases[k];
    }

    std::size_t run() {
        const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
        const std::size_t jobs =
            std::min<std::size_t>(options_.check.jobs > 0 ? options_.check.jobs : cores, kernels_.size());
        for (std::size_t i = 0; i < jobs; ++i) {
            Worker worker{start_judge(shared_), {}, {}, 0};
            workers_.push_back(std::move(worker));
        }
        if (options_.times) stopwatch_.emplace(start_stopwatch(shared_));
        tell_(Began{kernels_.size(), static_cast<unsigned>(jobs), folder_.must_poll()});
        edit_since_ = seconds_now();
        for (Watched& watched : kernels_) {
            watched.now = texts_.of(*watched.kernel);
            enqueue(watched, edit_since_);
        }
        for (;;) {
            give_work();
            settle_if_done();
            if (options_.edits && edit_ >= *options_.edits && is_idle()) break;
            if (wait()) break;
        }
        return static_cast<std::size_t>(std::ranges::count_if(
            kernels_, [](const Watched& watched) { return !watched.known || !watched.good || watched.due; }));
    }

private:
    // --- Changes of files

    void enqueue(Watched& watched, double since) {
        watched.edit = edit_;
        watched.since = since;
        watched.due = watched.now.error.empty();
        if (watched.due) return;
        Judgement judgement;
        judgement.verdict = to_string(Verdict::compile_error);
        judgement.message = watched.now.error;
        judgement.explanation = {watched.now.error};
        tell_judgement(watched, std::move(judgement), watched.now);
    }

    /// Reads what changed, and finds the kernels whose text is another now.
    void take_changes() {
        const double since = seconds_now();
        std::set<std::string> touched;
        bool all = false;
        for (double now = since; now < since + longest_settling; now = seconds_now()) {
            const FolderChanges changes = folder_.changes();
            for (const std::string& file : changes.files) {
                std::error_code error;
                if (std::filesystem::is_regular_file(options_.check.kernels / file, error)) {
                    gone_.erase(file);
                    touched.insert(file);
                } else {
                    gone_.try_emplace(file, since);
                }
            }
            if (changes.all && all_since_ == infinity) all_since_ = since;
            if (changes.empty() || folder_.must_poll()) break;
            std::vector<pollfd> polled{{folder_.descriptor(), POLLIN, 0}};
            wait_for(polled, quiet);
            if (polled[0].revents == 0) break;
        }
        if (since >= all_since_ + absence) {
            all = true;
            all_since_ = infinity;
            gone_.clear();
            texts_.read_all();
        }
        for (auto entry = gone_.begin(); entry != gone_.end();) {
            if (since >= entry->second + absence) {
                touched.insert(entry->first);
                entry = gone_.erase(entry);
            } else {
                ++entry;
            }
        }
        if (!all)
            for (const std::string& file : touched) texts_.read(file);
        if (all || !touched.empty()) look_at_kernels(all, touched, since);
    }

    void look_at_kernels(bool all, const std::set<std::string>& touched, double since) {
        const auto concerns = [&](const Texts& texts) {
            return all || !texts.error.empty() || std::ranges::any_of(touched, [&](const std::string& file) {
                       return texts.files.contains(file);
                   });
        };
        bool first = true;
        for (std::size_t k = 0; k < kernels_.size(); ++k) {
            Watched& watched = kernels_[k];
            if (!concerns(watched.now)) continue;
            Texts texts = texts_.of(*watched.kernel);
            if (texts.alone == watched.now.alone && texts.error == watched.now.error) continue;
            if (std::exchange(first, false)) {
                ++edit_;
                edit_since_ = since;
            }
            watched.now = std::move(texts);
            std::erase_if(timings_, [&](const Timing& timing) { return timing.kernel == k; });
            if (timing_ && timing_->kernel == k) timing_->outdated = true;
            enqueue(watched, since);
        }
    }

    // --- Verdicts

    bool outdated(const Worker& worker) const {
        return worker.kernel && kernels_[*worker.kernel].now.alone != worker.texts.alone;
    }

    /// The kernel that an idle worker does next: the shortest of its own; one that waits for another worker
    /// only if that one is held up.
    std::optional<std::size_t> next_for(std::size_t number) const {
        const double now = seconds_now();
        std::optional<std::size_t> own, foreign;
        const auto shorter = [&](std::size_t k, std::optional<std::size_t>& best) {
            if (!best || kernels_[k].now.alone.size() < kernels_[*best].now.alone.size()) best = k;
        };
        for (std::size_t k = 0; k < kernels_.size(); ++k) {
            const Watched& watched = kernels_[k];
            if (!watched.due) continue;
            if (!watched.home || *watched.home == number)
                shorter(k, own);
            else if (const Worker& home = workers_[*watched.home];
                     home.kernel && now - home.sent > stealing && *home.kernel != k)
                shorter(k, foreign);
        }
        return own ? own : foreign;
    }

    void give_work() {
        for (std::size_t i = 0; i < workers_.size(); ++i) {
            Worker& worker = workers_[i];
            if (worker.kernel) continue;
            const std::optional<std::size_t> next = next_for(i);
            if (!next) continue;
            Watched& watched = kernels_[*next];
            watched.due = false;
            if (!watched.home) watched.home = i;
            worker.kernel = next;
            worker.texts = watched.now;
            worker.sent = seconds_now();
            JudgeRequest request;
            request.kernel = *next;
            request.text = watched.now.alone;
            request.before = watched.ran.alone;
            worker.child.send(format(request));
        }
        if (stopwatch_ && !timing_ && !timings_.empty() && !judging()) begin_timing();
    }

    bool judging() const {
        return std::ranges::any_of(workers_,
                                   [](const Worker& worker) { return worker.kernel.has_value(); }) ||
               std::ranges::any_of(kernels_, [](const Watched& watched) { return watched.due; });
    }

    void tell_judgement(Watched& watched, Judgement judgement, const Texts& texts) {
        Judged told;
        told.kernel = watched.kernel;
        told.edit = watched.edit;
        if (watched.of_ran) told.worst_before = watched.of_ran->worst;
        told.milliseconds = (seconds_now() - watched.since) * 1000;
        watched.known = true;
        watched.good = judgement.good;
        watched.tells_of_ran = judgement.ran;
        if (judgement.ran) {
            if (!watched.ran.repeated.empty()) want_time(watched, texts, judgement);
            watched.ran = texts;
            watched.of_ran = judgement;
        }
        ++judged_;
        told.judgement = std::move(judgement);
        tell_(told);
    }

    void take_judgement(Watched& watched, Judgement judgement, const Texts& texts) {
        if (!judgement.same_code) {
            tell_judgement(watched, std::move(judgement), texts);
            return;
        }
        watched.ran = texts;
        if (!watched.tells_of_ran) { // mended: as it was before it did not compile, or crashed
            Judgement again = *watched.of_ran;
            again.moved = Moved{};
            Judged told;
            told.kernel = watched.kernel;
            told.edit = watched.edit;
            told.worst_before = again.worst;
            told.milliseconds = (seconds_now() - watched.since) * 1000;
            watched.good = again.good;
            watched.tells_of_ran = true;
            ++judged_;
            told.judgement = std::move(again);
            tell_(told);
            return;
        }
        ++same_;
        tell_(SameCode{watched.kernel, watched.edit, watched.good, (seconds_now() - watched.since) * 1000});
    }

    void restart(Worker& worker) {
        worker.child = start_judge(shared_);
        worker.kernel.reset();
    }

    void hear(Worker& worker) {
        const Answer answer = worker.child.receive(absence);
        if (answer.kind == Answer::Kind::late) return;
        if (answer.kind == Answer::Kind::error) throw Error("{}", answer.text); // it could not even start
        if (!worker.kernel) { // died while it had nothing to do
            restart(worker);
            return;
        }
        Watched& watched = kernels_[*worker.kernel];
        const Texts texts = std::move(worker.texts);
        const bool wanted = watched.now.alone == texts.alone;
        Judgement judgement;
        if (answer.kind == Answer::Kind::message) {
            worker.kernel.reset();
            judgement = parse_judgement(answer.text);
            if (judgement.device_lost) restart(worker);
        } else {
            restart(worker);
            judgement.verdict = "crash";
            judgement.message = fmt::format(
                "the process that compiled and ran it died: {} (a compiler out of memory or stack?)",
                answer.text);
            judgement.explanation = {judgement.message};
        }
        if (wanted) take_judgement(watched, std::move(judgement), texts);
    }

    double patience(const Worker& worker) const {
        if (!kernels_[*worker.kernel].known) return first_patience;
        return compile_patience + 4 * options_.check.device.time_limit;
    }

    void end_if_overdue(Worker& worker, double now) {
        if (!worker.kernel) return;
        if (outdated(worker) && now - worker.sent > overdue && kernels_[*worker.kernel].known) {
            restart(worker);
        } else if (now - worker.sent > patience(worker)) {
            Watched& watched = kernels_[*worker.kernel];
            const Texts texts = std::move(worker.texts);
            const double waited = now - worker.sent;
            restart(worker);
            if (watched.now.alone != texts.alone) return;
            Judgement judgement;
            judgement.verdict = to_string(Verdict::timeout);
            judgement.message =
                fmt::format("did not compile and run within {:.0f} s; its process was ended", waited);
            judgement.explanation = {judgement.message};
            take_judgement(watched, std::move(judgement), texts);
        }
    }

    // --- Times

    void want_time(const Watched& watched, const Texts& after, const Judgement& judgement) {
        if (!stopwatch_ || watched.edit == 0) return;
        Timing timing;
        timing.kernel = static_cast<std::size_t>(&watched - kernels_.data());
        timing.edit = watched.edit;
        timing.request.kernel = timing.kernel;
        timing.request.before = watched.ran.repeated;
        timing.request.after = after.repeated;
        timing.request.alone = after.alone;
        timing.request.results = judgement.results;
        timings_.push_back(std::move(timing));
    }

    void begin_timing() {
        timing_ = std::move(timings_.front());
        timings_.pop_front();
        timing_->sent = seconds_now();
        stopwatch_->send(format(timing_->request));
    }

    void hear_stopwatch() {
        const Answer answer = stopwatch_->receive(absence);
        if (answer.kind == Answer::Kind::late) return;
        if (answer.kind == Answer::Kind::error) throw Error("{}", answer.text);
        if (answer.kind == Answer::Kind::death) {
            stopwatch_ = start_stopwatch(shared_);
            end_timing("the process that timed it died: " + answer.text);
            return;
        }
        const Times times = parse_times(answer.text);
        if (times.device_lost) stopwatch_ = start_stopwatch(shared_);
        if (!timing_) return;
        if (!times.cannot.empty() || timing_->outdated) {
            end_timing(times.cannot);
            return;
        }
        if (!timing_->begun) {
            timing_->begun = true;
            timing_->same_results = times.same_results;
        } else {
            timing_->times.a.push_back(times.before);
            timing_->times.b.push_back(times.after);
            timing_->times.again.push_back(times.again);
            timing_->reading.push_back(times.floor);
        }
        const std::size_t rounds = timing_->times.a.size();
        if (rounds == timed_rounds) {
            try {
                tell_times();
                timing_.reset();
            } catch (const Error& error) {
                end_timing(error.what());
            }
            return;
        }
        TimeRequest request;
        request.what = TimeRequest::What::round;
        request.kernel = timing_->kernel;
        request.round = static_cast<unsigned>(rounds);
        timing_->sent = seconds_now();
        stopwatch_->send(format(request));
    }

    /// Throws Error if the device's clock stood still.
    void tell_times() {
        measure::PairedTimes& times = timing_->times;
        const auto median = [](std::vector<double> values) {
            std::ranges::sort(values);
            return measure::quantile(values, 0.5);
        };
        Timed told;
        told.kernel = kernels_[timing_->kernel].kernel;
        told.edit = timing_->edit;
        told.before = median(times.a);
        told.after = median(times.b);
        told.reading = median(timing_->reading);
        times.floor = told.reading;
        told.pace = measure::judge_times(times);
        told.with_reading = told.pace.with_floor;
        told.same_results = timing_->same_results;
        tell_(told);
    }

    void end_timing(const std::string& why) {
        if (timing_ && !timing_->outdated) {
            NotTimed told;
            told.kernel = kernels_[timing_->kernel].kernel;
            told.edit = timing_->edit;
            told.why = why;
            tell_(told);
        }
        timing_.reset();
    }

    // --- Waiting

    bool is_idle() const {
        return !judging() && !timing_ && timings_.empty() && gone_.empty() && all_since_ == infinity;
    }

    void settle_if_done() {
        if (judged_ + same_ == 0 || judging()) return;
        Settled told;
        told.edit = edit_;
        told.judged = judged_;
        told.same = same_;
        for (const Watched& watched : kernels_) ++(watched.good ? told.good : told.bad);
        told.milliseconds = (seconds_now() - edit_since_) * 1000;
        judged_ = same_ = 0;
        tell_(told);
    }

    double next_deadline(double now) const {
        double deadline = folder_.must_poll() ? now + FolderWatch::poll_seconds : infinity;
        for (const auto& [file, since] : gone_) deadline = std::min(deadline, since + absence);
        deadline = std::min(deadline, all_since_ + absence);
        for (const Worker& worker : workers_)
            if (worker.kernel) {
                deadline = std::min(deadline, worker.sent + patience(worker));
                if (outdated(worker))
                    deadline = std::min(deadline, std::max(now, worker.sent + overdue) + quiet);
                if (now - worker.sent < stealing)
                    deadline = std::min(deadline, worker.sent + stealing + quiet);
            }
        if (timing_) deadline = std::min(deadline, timing_->sent + time_patience());
        return deadline;
    }

    double time_patience() const { return 2 * compile_patience + 16 * options_.check.device.time_limit; }

    /// Until something has happened; true if it is that the session is to end.
    bool wait() {
        double now = seconds_now();
        std::vector<pollfd> polled{{options_.stop, POLLIN, 0}, {folder_.descriptor(), POLLIN, 0}};
        for (const Worker& worker : workers_) polled.push_back({worker.child.descriptor(), POLLIN, 0});
        polled.push_back({stopwatch_ ? stopwatch_->descriptor() : -1, POLLIN, 0});
        wait_for(polled, next_deadline(now) - now);
        if (polled[0].revents != 0) return true;
        now = seconds_now();
        if (polled[1].revents != 0 || folder_.must_poll() || !gone_.empty() || all_since_ < infinity)
            take_changes();
        for (std::size_t i = 0; i < workers_.size(); ++i)
            if (polled[2 + i].revents != 0)
                hear(workers_[i]);
            else
                end_if_overdue(workers_[i], now);
        if (polled.back().revents != 0) {
            hear_stopwatch();
        } else if (timing_ && now - timing_->sent > time_patience()) {
            stopwatch_ = start_stopwatch(shared_);
            end_timing(fmt::format("not timed within {:.0f} s", time_patience()));
        }
        return false;
    }

    SessionOptions options_;
    const std::function<void(const Event&)>& tell_;
    Shared shared_;
    FolderWatch folder_; // before the texts: what changes while they are read is told afterwards
    FolderTexts texts_;
    std::vector<Watched> kernels_;
    std::vector<Worker> workers_;
    std::optional<Child> stopwatch_;
    std::deque<Timing> timings_;
    std::optional<Timing> timing_;
    std::map<std::string, double> gone_; ///< files that are no more, since when
    double all_since_ = infinity;        ///< since when anything may have changed
    std::size_t edit_ = 0, judged_ = 0, same_ = 0;
    double edit_since_ = 0;
};

} // namespace

std::size_t run_session(std::span<const Case* const> cases, const SessionOptions& options,
                        const std::function<void(const Event&)>& tell) {
    require_kernels(options.check.kernels);
    Session session(cases, options, tell);
    return session.run();
}

} // namespace gnomon::watch
