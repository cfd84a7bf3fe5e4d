#include "casegen/watch/session.h"

#include "casegen/fuzz/regression.h"
#include "casegen/watch/clock.h"
#include "casegen/watch/edits.h"
#include "casegen/watch/timekeeper.h"
#include "casegen/watch/workers.h"
#include "runtime/error.h"
#include "runtime/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace gnomon::watch {
namespace {

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

class Session {
public:
    Session(std::span<const Case* const> cases, const SessionOptions& options,
            const std::function<void(const Event&)>& tell)
        : options_(options), tell_(tell),
          edits_(options.check.kernels,
                 options.poll ? FolderWatch::How::polling : FolderWatch::How::inotify_if_possible) {
        shared_.cases.assign(cases.begin(), cases.end());
        shared_.options = options.check;
        shared_.options.device.isolated = false; // a process each
        shared_.folder = edits_.texts().name();
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
        if (options_.times) times_.emplace(shared_, tell_);
        tell_(Began{kernels_.size(), static_cast<unsigned>(jobs), edits_.polls()});
        edit_since_ = seconds_now();
        for (Watched& watched : kernels_) {
            watched.now = edits_.texts().of(*watched.kernel);
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

    /// Finds the kernels whose text is another now.
    void take_changes() {
        const double since = seconds_now();
        const Touched touched = edits_.take();
        if (touched.empty()) return;
        const auto concerns = [&](const Texts& texts) {
            return touched.all || !texts.error.empty() ||
                   std::ranges::any_of(touched.files,
                                       [&](const std::string& file) { return texts.files.contains(file); });
        };
        bool first = true;
        for (std::size_t k = 0; k < kernels_.size(); ++k) {
            Watched& watched = kernels_[k];
            if (!concerns(watched.now)) continue;
            Texts texts = edits_.texts().of(*watched.kernel);
            if (texts.alone == watched.now.alone && texts.error == watched.now.error) continue;
            if (std::exchange(first, false)) {
                ++edit_;
                edit_since_ = since;
            }
            watched.now = std::move(texts);
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
        if (times_ && !judging()) times_->go_on();
    }

    bool judging() const {
        return std::ranges::any_of(workers_,
                                   [](const Worker& worker) { return worker.kernel.has_value(); }) ||
               std::ranges::any_of(kernels_, [](const Watched& watched) { return watched.due; });
    }

    void tell_judgement(Watched& watched, Judgement judgement, const Texts& texts) {
        // Of another code. What is the same code but for its text leaves the time of the edit before it
        // wanted.
        if (times_) times_->forget(number_of(watched));
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

    std::size_t number_of(const Watched& watched) const {
        return static_cast<std::size_t>(&watched - kernels_.data());
    }

    void want_time(const Watched& watched, const Texts& after, const Judgement& judgement) {
        if (!times_ || watched.edit == 0) return;
        TimeRequest request;
        request.kernel = number_of(watched);
        request.before = watched.ran.repeated;
        request.after = after.repeated;
        request.alone = after.alone;
        request.results = judgement.results;
        times_->want(watched.edit, std::move(request));
    }

    // --- Waiting

    bool is_idle() const { return !judging() && (!times_ || times_->is_idle()) && !edits_.waits(); }

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
        double deadline = edits_.deadline(now);
        if (times_) deadline = std::min(deadline, times_->deadline());
        for (const Worker& worker : workers_)
            if (worker.kernel) {
                deadline = std::min(deadline, worker.sent + patience(worker));
                if (outdated(worker))
                    deadline = std::min(deadline, std::max(now, worker.sent + overdue) + quiet);
                if (now - worker.sent < stealing)
                    deadline = std::min(deadline, worker.sent + stealing + quiet);
            }
        return deadline;
    }

    /// Until something has happened; true if it is that the session is to end.
    bool wait() {
        double now = seconds_now();
        std::vector<pollfd> polled{{options_.stop, POLLIN, 0}, {edits_.descriptor(), POLLIN, 0}};
        for (const Worker& worker : workers_) polled.push_back({worker.child.descriptor(), POLLIN, 0});
        polled.push_back({times_ ? times_->descriptor() : -1, POLLIN, 0});
        wait_for(polled, next_deadline(now) - now);
        if (polled[0].revents != 0) return true;
        now = seconds_now();
        if (polled[1].revents != 0 || edits_.is_due()) take_changes();
        for (std::size_t i = 0; i < workers_.size(); ++i)
            if (polled[2 + i].revents != 0)
                hear(workers_[i]);
            else
                end_if_overdue(workers_[i], now);
        if (polled.back().revents != 0)
            times_->hear();
        else if (times_)
            times_->end_if_overdue(now);
        return false;
    }

    SessionOptions options_;
    const std::function<void(const Event&)>& tell_;
    Shared shared_;
    Edits edits_;
    std::vector<Watched> kernels_;
    std::vector<Worker> workers_;
    std::optional<Timekeeper> times_;
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
