#include "casegen/mutate/campaign.h"

#include "casegen/check.h"
#include "casegen/standalone.h"
#include "runtime/clock.h"
#include "runtime/error.h"
#include "runtime/process.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <map>
#include <memory>
#include <set>
#include <thread>

namespace gnomon::mutate {
namespace {

/// What a worker says: the outcome's number or 't' for a dispatch that did not end, a blank, and the rest in
/// words. Without a mutant: how the kernel itself does.
std::string answer(Examiner& examiner, const Mutant* mutant, const Case& c, const glsl::Sources& sources) {
    try {
        if (!mutant) {
            const std::string complaint = examiner.complaint(c);
            const auto outcome = complaint.empty() ? Examined::Outcome::survived : Examined::Outcome::broken;
            return fmt::format("{} {}", static_cast<int>(outcome), complaint);
        }
        const Examined examined = examiner.examine(c, with(sources, *mutant));
        return fmt::format("{} {}", static_cast<int>(examined.outcome), examined.how);
    } catch (const KernelTimeout& error) {
        return fmt::format("t {}", error.what());
    }
}

/// Hands mutants to workers, kernel by kernel: a mutant that one kernel's check lets pass waits for the next
/// of its users.
class Campaign {
public:
    Campaign(CampaignReport& report, const CampaignOptions& options,
             const std::function<void(std::size_t, std::size_t)>& done)
        : report_(report), options_(options), done_(done), sources_(options.examiner.sources),
          progress_(report.mutants.size()) {
        for (std::size_t i = 0; i < report_.mutants.size(); ++i)
            waiting_[report_.mutants[i].mutant.users.front()].push_back(i);
        const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
        const std::size_t jobs =
            std::min<std::size_t>(options.jobs > 0 ? options.jobs : cores, report_.mutants.size());
        for (std::size_t i = 0; i < jobs; ++i) children_.push_back(start());
        tasks_.resize(jobs);
    }

    void run() {
        while (true) {
            const bool stopped = options_.stop && *options_.stop;
            bool busy = false;
            if (!stopped) give_to_all();
            for (const Child& child : children_) busy = busy || child.busy();
            if (!busy) return;
            const std::size_t ready = wait_for_any(children_, 0.5);
            if (ready < children_.size()) take(ready);
            for (std::size_t worker = 0; worker < children_.size(); ++worker)
                if (children_[worker].busy() && seconds_now() - tasks_[worker].sent > options_.patience) {
                    restart(worker);
                    again_or_dead(worker, "did not answer, and was ended");
                }
        }
    }

    /// Kernels that fail unchanged, and how.
    const std::map<std::string, std::string>& broken() const { return broken_; }

private:
    /// A mutant on a kernel's check.
    struct Progress {
        std::size_t user = 0;  ///< whose turn it is
        bool again = false;    ///< the second try: a machine that is busy must kill no mutant
        bool differs = false;  ///< some user compiles it, and to other code
        bool compiles = false; ///< some user compiles it
        bool broken = false;   ///< some user fails without it
        std::string how;
    };
    struct Task {
        std::size_t mutant = 0;
        const Case* kernel = nullptr;
        double sent = 0;
        bool unchanged = false; ///< the kernel itself is asked about, before its first mutant
        bool again = false;     ///< which did not answer before
    };

    Child start() {
        return Child([this]() -> Child::Serve {
            // As many workers as cores: threads of the driver's own would only have them wait. LLVM's
            // optimiser takes as long as all the rest, and changes no bit; what Mesa would keep nobody asks
            // for again.
            ::setenv("LP_NUM_THREADS", "0", 0);
            ::setenv("GALLIVM_PERF", "nopt", 0);
            ::setenv("MESA_SHADER_CACHE_DISABLE", "true", 0);
            auto examiner = std::make_shared<Examiner>(options_.examiner);
            return [this, examiner](const std::string& request) {
                const std::size_t mutant = std::strtoull(request.c_str(), nullptr, 10);
                const std::size_t user =
                    std::strtoull(request.substr(request.find(' ')).c_str(), nullptr, 10);
                const Mutant& asked = report_.mutants[mutant].mutant;
                return answer(*examiner, request.ends_with('u') ? nullptr : &asked, *asked.users[user],
                              sources_);
            };
        });
    }
    void restart(std::size_t worker) { children_[worker] = start(); }

    /// The kernel that this worker knows, else one that no other worker is at, else any. There are some.
    const Case* kernel_for(std::size_t worker) {
        if (const auto own = waiting_.find(tasks_[worker].kernel); own != waiting_.end()) return own->first;
        for (const auto& [kernel, mutants] : waiting_)
            if (std::ranges::find(tasks_, kernel, &Task::kernel) == tasks_.end()) return kernel;
        return waiting_.begin()->first;
    }

    /// Again and again: a kernel that turns out to be broken hands its mutants on to their next users.
    void give_to_all() {
        for (bool gave = true; gave;) {
            gave = false;
            for (std::size_t worker = 0; worker < children_.size() && !waiting_.empty(); ++worker)
                if (!children_[worker].busy()) {
                    give(worker);
                    gave = true;
                }
        }
    }
    void give(std::size_t worker) {
        const Case* kernel = kernel_for(worker);
        std::deque<std::size_t>& mutants = waiting_[kernel];
        const std::size_t mutant = mutants.front();
        mutants.pop_front();
        if (mutants.empty()) waiting_.erase(kernel);
        send(worker, mutant, kernel);
    }
    /// Nothing is asked of a kernel's mutants before the kernel itself has passed its check: a mutant of one
    /// that crashes or does not end would pass for killed.
    void send(std::size_t worker, std::size_t mutant, const Case* kernel, bool again = false) {
        tasks_[worker] = {mutant, kernel, seconds_now(), !sound_.contains(kernel), again};
        if (const auto broken = broken_.find(kernel->name); broken != broken_.end())
            judge(worker, Examined::Outcome::broken, broken->second);
        else
            children_[worker].send(
                fmt::format("{} {}{}", mutant, progress_[mutant].user, tasks_[worker].unchanged ? " u" : ""));
    }

    void take(std::size_t worker) {
        const Answer said = children_[worker].receive(options_.patience);
        if (said.kind == Answer::Kind::error) throw Error("a worker cannot go on: {}", said.text);
        if (said.kind != Answer::Kind::message) {
            restart(worker);
            again_or_dead(worker, said.kind == Answer::Kind::death ? "the process died: " + said.text
                                                                   : "did not answer, and was ended");
            return;
        }
        if (said.text.starts_with('t')) {
            restart(worker); // its device is lost
            again_or_dead(worker, said.text.substr(2));
            return;
        }
        const auto outcome = static_cast<Examined::Outcome>(said.text[0] - '0');
        if (tasks_[worker].unchanged && outcome != Examined::Outcome::broken) {
            sound_.insert(tasks_[worker].kernel);
            go_on(worker);
            return;
        }
        judge(worker, outcome, said.text.substr(2));
    }

    /// The kernel itself has passed: its mutant now, unless nothing new is to begin.
    void go_on(std::size_t worker) {
        if (!options_.stop || !*options_.stop) send(worker, tasks_[worker].mutant, tasks_[worker].kernel);
    }

    void again_or_dead(std::size_t worker, const std::string& how) {
        const std::size_t mutant = tasks_[worker].mutant;
        if (tasks_[worker].unchanged) {
            if (sound_.contains(tasks_[worker].kernel)) // another worker has seen it pass
                go_on(worker);
            else if (tasks_[worker].again)
                judge(worker, Examined::Outcome::broken, how);
            else
                send(worker, mutant, tasks_[worker].kernel, true);
            return;
        }
        if (progress_[mutant].again) {
            settle(mutant, Fate::killed, tasks_[worker].kernel, how);
            return;
        }
        progress_[mutant].again = true;
        send(worker, mutant, tasks_[worker].kernel);
    }

    void judge(std::size_t worker, Examined::Outcome outcome, const std::string& how) {
        const Task& task = tasks_[worker];
        Progress& progress = progress_[task.mutant];
        const Mutant& mutant = report_.mutants[task.mutant].mutant;
        progress.again = false; // the next kernel that is asked has its second try
        switch (outcome) {
        case Examined::Outcome::killed:
            settle(task.mutant, Fate::killed, task.kernel, how);
            return;
        case Examined::Outcome::broken:
            broken_.emplace(task.kernel->name, how);
            progress.broken = true;
            break;
        case Examined::Outcome::survived:
            if (!progress.differs) progress.how.clear();
            progress.compiles = progress.differs = true;
            progress.how += fmt::format("{}{}: {}", progress.how.empty() ? "" : "; ", task.kernel->name, how);
            break;
        case Examined::Outcome::same_code:
            progress.compiles = true;
            if (!progress.differs) progress.how = how;
            break;
        case Examined::Outcome::stillborn:
            if (!progress.compiles) progress.how = how;
            break;
        }
        if (++progress.user < mutant.users.size()) {
            waiting_[mutant.users[progress.user]].push_back(task.mutant);
            return;
        }
        settle(task.mutant,
               progress.differs    ? Fate::survived
               : progress.compiles ? Fate::same_code
               : progress.broken   ? Fate::not_run
                                   : Fate::stillborn,
               nullptr, progress.how);
    }

    void settle(std::size_t mutant, Fate fate, const Case* by, const std::string& how) {
        MutantReport& report = report_.mutants[mutant];
        report.fate = fate;
        report.by = by;
        report.how = how;
        if (done_) done_(++settled_, report_.mutants.size());
    }

    CampaignReport& report_;
    const CampaignOptions& options_;
    const std::function<void(std::size_t, std::size_t)>& done_;
    const glsl::Sources& sources_;
    std::vector<Progress> progress_;
    std::map<const Case*, std::deque<std::size_t>> waiting_;
    std::vector<Child> children_;
    std::vector<Task> tasks_; ///< each worker's, the last one if it is idle
    std::size_t settled_ = 0;
    std::set<const Case*> sound_; ///< kernels that pass unchanged
    std::map<std::string, std::string> broken_;
};

void count(KernelCount& to, std::size_t number, Fate fate) {
    to.mutants.push_back(number);
    switch (fate) {
    case Fate::not_run:
        ++to.not_run;
        break;
    case Fate::killed:
        ++to.killed;
        break;
    case Fate::survived:
        ++to.survived;
        break;
    case Fate::equivalent:
        ++to.equivalent;
        break;
    case Fate::tolerated:
        ++to.tolerated;
        break;
    case Fate::same_code:
        ++to.same_code;
        break;
    case Fate::stillborn:
        ++to.stillborn;
        break;
    }
}

/// What an entry of the list says of a mutant that is not so.
std::string wrong_claim(const MutantReport& report) {
    switch (report.fate) {
    case Fate::killed:
        return fmt::format("is not equivalent: it is killed by {}", report.by->name);
    case Fate::same_code:
        return "need not be listed: it compiles to the same code";
    case Fate::stillborn:
        return "need not be listed: it does not compile";
    case Fate::not_run:
    case Fate::survived:
    case Fate::equivalent:
    case Fate::tolerated:
        break;
    }
    return {};
}

} // namespace

const char* to_string(Fate fate) {
    switch (fate) {
    case Fate::not_run:
        return "not run";
    case Fate::killed:
        return "killed";
    case Fate::survived:
        return "survived";
    case Fate::equivalent:
        return "equivalent";
    case Fate::tolerated:
        return "tolerated";
    case Fate::same_code:
        return "same code";
    case Fate::stillborn:
        return "stillborn";
    }
    return "";
}

std::optional<double> KernelCount::score() const {
    const std::size_t mortal = killed + survived;
    if (mortal == 0) return {};
    return static_cast<double>(killed) / static_cast<double>(mortal);
}

CampaignReport run_campaign(std::span<const Case* const> cases, const CampaignOptions& options,
                            const std::function<void(std::size_t, std::size_t)>& done) {
    const double begin = seconds_now();
    const glsl::Sources& sources = options.examiner.sources;
    CampaignReport report;
    std::map<std::string, const Equivalent*> listed;
    for (const Equivalent& each : options.equivalents) listed[each.id] = &each;

    std::vector<Mutant> mutants = mutants_of(cases, sources, all_operators());
    std::set<std::string> files, ids;
    for (const Mutant& mutant : mutants) {
        if (mutant.mutation.by != Operator::stale)
            files.insert(mutant.file); // else only its includer is asked about
        ids.insert(mutant.id);
    }
    std::set<std::string> missing;
    const bool asks_all = cases.size() == find_cases("").size(); // what nobody includes has no mutants either
    for (const Equivalent& each : options.equivalents) {
        if (!sources.overlaid.contains(each.file) && !std::filesystem::exists(sources.root / each.file)) {
            if (missing.insert(each.file).second)
                report.complaints.push_back(fmt::format(
                    "{}: mutants of it are listed as equivalent, but there is no such file", each.file));
        } else if ((asks_all || files.contains(each.file)) && !ids.contains(each.id)) {
            report.complaints.push_back(fmt::format(
                "{}: {} is listed as equivalent, but there is no such mutant: the function has changed ({})",
                each.file, each.id, each.mutation));
        }
    }
    std::erase_if(mutants, [&](const Mutant& mutant) {
        return std::ranges::find(options.operators, mutant.mutation.by) == options.operators.end();
    });
    if (!options.only.empty()) {
        std::erase_if(mutants, [&](const Mutant& mutant) { return mutant.id != options.only; });
        if (mutants.empty()) throw Error("none of these kernels has a mutant {}", options.only);
    }
    if (options.limit && mutants.size() > *options.limit) {
        std::vector<std::string> sorted;
        for (const Mutant& mutant : mutants) sorted.push_back(mutant.id);
        std::ranges::sort(sorted);
        std::erase_if(mutants, [&](const Mutant& mutant) { return mutant.id >= sorted[*options.limit]; });
    }
    for (Mutant& mutant : mutants) {
        MutantReport& each = report.mutants.emplace_back();
        const auto entry = listed.find(mutant.id);
        if (entry != listed.end()) each.listed = entry->second;
        each.mutant = std::move(mutant);
    }

    if (!report.mutants.empty()) {
        Campaign campaign(report, options, done);
        campaign.run();
        for (const auto& [kernel, how] : campaign.broken())
            report.complaints.push_back(fmt::format("{} fails its check unchanged: {}", kernel, how));
    }
    for (MutantReport& each : report.mutants) {
        if (!each.listed) continue;
        if (const std::string wrong = wrong_claim(each); !wrong.empty())
            report.complaints.push_back(fmt::format("{}: {} {} ({}; {})", each.mutant.file, each.mutant.id,
                                                    wrong, each.listed->mutation, each.how));
        if (each.fate == Fate::survived)
            each.fate = each.listed->tolerated ? Fate::tolerated : Fate::equivalent;
    }
    for (std::size_t i = 0; i < report.mutants.size(); ++i) count(report.all, i, report.mutants[i].fate);
    for (const Case* c : cases) {
        if (!c->fails.empty()) {
            report.must_fail.push_back(c);
            continue;
        }
        KernelCount& of_kernel = report.kernels.emplace_back();
        of_kernel.kernel = c;
        const std::vector<std::string> included = files_of(*c, sources);
        for (std::size_t i = 0; i < report.mutants.size(); ++i)
            if (counts_for(report.mutants[i].mutant, *c, included))
                count(of_kernel, i, report.mutants[i].fate);
    }
    report.interrupted = options.stop && *options.stop && report.all.not_run > 0;
    report.seconds = seconds_now() - begin;
    return report;
}

} // namespace gnomon::mutate
