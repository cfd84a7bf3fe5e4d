#include "casegen/versus/versus.h"

#include "casegen/catalogue.h"
#include "casegen/versus/message.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/gpu/validation.h"
#include "runtime/process.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <set>

namespace gnomon::versus {
namespace {

namespace fs = std::filesystem;

constexpr double patience = 300; // beyond what dispatches and rounds may take

/// The text that a kernel compiles from, without the names of the files it came from; empty if it does not
/// expand, which compiling will explain.
std::string text_of(const Side& side, const Case& c) {
    std::string text, kept;
    try {
        text = glsl::expand(sources_of(side), standalone_source(c), standalone_name);
    } catch (const Error&) {
        return {};
    }
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
        if (text.compare(begin, 5, "#line") != 0) kept.append(text, begin, end - begin);
        begin = end;
    }
    return kept;
}

std::set<std::string> files_below(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file()) names.insert(entry.path().lexically_relative(folder).generic_string());
    return names;
}

/// Files that are no kernels and no part of one (.glslh), on both sides, with other bytes.
std::vector<std::string> other_files(const Side& a, const Side& b) {
    std::vector<std::string> others;
    const std::set<std::string> of_b = files_below(b.folder);
    for (const std::string& name : files_below(a.folder)) {
        const std::string kind = fs::path(name).extension().string();
        const bool is_shader = kind == ".comp" || kind == ".vert" || kind == ".frag" || kind == ".geom";
        if (is_shader && of_b.contains(name) && read_file(a.folder / name) != read_file(b.folder / name))
            others.push_back(name);
    }
    return others;
}

void require_there(const Side& side, const Case& c, const char* which) {
    if (!has_kernel(side, c)) throw Error("{} ({}) has no kernel {}", which, side.label, c.name);
}

/// The child that holds an Examiner, and another one after it has died or hung.
class Worker {
public:
    Worker(const Side& a, const Side& b, const VersusOptions& options) : a_(a), b_(b), options_(options) {
        start();
    }

    struct Outcome {
        Reply reply;
        std::string death; ///< how it ended, if it did
    };
    Outcome ask(const Pair& pair, Question question) {
        child_->send(format_request({question, pair.a->name, pair.b->name}));
        const Answer answer = child_->receive(longest(question));
        Outcome outcome;
        switch (answer.kind) {
        case Answer::Kind::message:
            outcome.reply = parse_reply(answer.text, question);
            if (!outcome.reply.timeout.empty()) start(); // its device is lost
            break;
        case Answer::Kind::error:
            throw Error("{}", answer.text);
        case Answer::Kind::late:
            outcome.death = "it did not answer and was ended";
            start();
            break;
        case Answer::Kind::death:
            outcome.death = answer.text;
            start();
            break;
        }
        return outcome;
    }

private:
    /// Seconds that an answer may take: inputs and rounds as asked for, and patience with all else.
    double longest(Question question) const {
        const ExaminerOptions& asked = options_.examiner;
        constexpr double seconds_per_truth = 0.01;
        double seconds = patience + 10 * asked.device.time_limit;
        seconds += seconds_per_truth * static_cast<double>(asked.samples.value_or(0));
        if (question == Question::time)
            seconds += asked.timing.rounds ? static_cast<double>(*asked.timing.rounds) : asked.timing.seconds;
        return seconds;
    }

    static std::string serve(Examiner& examiner, const std::string& bytes) {
        const Request request = parse_request(bytes);
        const Pair pair{&find_case(request.a), &find_case(request.b)};
        Reply reply;
        try {
            switch (request.question) {
            case Question::same_code:
                reply.same_code = examiner.is_same_code(pair);
                break;
            case Question::run_a:
                reply.side = examiner.run(pair, 0);
                break;
            case Question::run_b:
                reply.side = examiner.run(pair, 1);
                break;
            case Question::difference:
                reply.difference = examiner.difference(pair);
                break;
            case Question::draw:
                reply.picture = examiner.draw(pair);
                break;
            case Question::time:
                reply.time = examiner.time(pair);
                break;
            }
        } catch (const KernelTimeout& error) {
            reply.timeout = error.what();
        } catch (const CompileError& error) {
            reply.obstacle = error.what();
        } catch (const Error& error) { // of what else is asked, one kernel's trouble is not all kernels'
            if (request.question != Question::draw && request.question != Question::time) throw;
            reply.obstacle = error.what();
        }
        if (const std::vector<std::string> messages = gpu::take_validation_messages(); !messages.empty())
            throw Error("Vulkan's validation layer complains ({} messages): {}", messages.size(),
                        messages.front());
        return format_reply(reply, request.question);
    }

    void start() {
        child_.emplace([this]() -> Child::Serve {
            auto examiner = std::make_shared<Examiner>(a_, b_, options_.examiner);
            return [examiner](const std::string& request) { return serve(*examiner, request); };
        });
    }

    const Side &a_, &b_;
    const VersusOptions& options_;
    std::optional<Child> child_;
};

SideReport side_report(const Worker::Outcome& outcome, const Case& c) {
    if (outcome.death.empty() && outcome.reply.timeout.empty()) return outcome.reply.side;
    SideReport report;
    report.allowed = to_string(c.tolerance);
    report.failure = outcome.death.empty() ? "timeout" : "crash";
    report.message = outcome.death.empty() ? outcome.reply.timeout : "the process died: " + outcome.death;
    return report;
}

/// Why a question has no answer; empty if it has one.
std::string obstacle(const Worker::Outcome& outcome) {
    if (!outcome.death.empty()) return "the process died: " + outcome.death;
    return outcome.reply.timeout.empty() ? outcome.reply.obstacle : outcome.reply.timeout;
}

Comparison compare_pair(Worker& worker, const Pair& pair, const VersusOptions& options) {
    Comparison found;
    found.name = pair.a == pair.b ? pair.a->name : fmt::format("{} / {}", pair.a->name, pair.b->name);
    found.a = side_report(worker.ask(pair, Question::run_a), *pair.a);
    const Worker::Outcome of_b = worker.ask(pair, Question::run_b);
    found.b = side_report(of_b, *pair.b);
    const auto comparable = [](const SideReport& side) {
        return side.ran && (side.failure.empty() || side.failure == "wrong");
    };
    if (!comparable(found.a) || !comparable(found.b)) {
        found.not_timed = found.not_drawn =
            fmt::format("{} has no results to go by", comparable(found.a) ? "B" : "A");
        return found;
    }
    const Worker::Outcome difference = worker.ask(pair, Question::difference);
    if (const std::string none = obstacle(difference); !none.empty()) throw Error("{}: {}", found.name, none);
    found.difference = difference.reply.difference;
    found.compared = true;
    if (options.picture) {
        const Worker::Outcome drawn = worker.ask(pair, Question::draw);
        found.not_drawn = obstacle(drawn);
        found.drawn = found.not_drawn.empty();
        found.picture = drawn.reply.picture;
    }
    if (options.times) {
        const Worker::Outcome timed = worker.ask(pair, Question::time);
        found.not_timed = obstacle(timed);
        found.timed = found.not_timed.empty();
        found.time = timed.reply.time;
    }
    return found;
}

} // namespace

Plan make_plan(const Side& a, const Side& b, const std::string& pattern) {
    Plan plan;
    if (a.kernel || b.kernel) {
        if (!pattern.empty())
            throw Error("\"{}\": there is nothing to choose from where a side is a kernel of its own",
                        pattern);
        const Pair pair{a.kernel ? a.kernel : b.kernel, b.kernel ? b.kernel : a.kernel};
        require_there(a, *pair.a, "A");
        require_there(b, *pair.b, "B");
        if (!share_signature(*pair.a, *pair.b))
            throw Error("{} and {} cannot be compared: other parameters or another result",
                        signature(*pair.a), signature(*pair.b));
        plan.pairs.push_back(pair);
        plan.named = true;
        return plan;
    }
    for (const Case* c : find_cases(pattern)) {
        const bool in_a = has_kernel(a, *c), in_b = has_kernel(b, *c);
        if (in_a && in_b) {
            const std::string text = text_of(a, *c);
            if (!text.empty() && text == text_of(b, *c))
                ++plan.same;
            else
                plan.pairs.push_back({c, c});
        } else if (in_a || in_b) {
            (in_a ? plan.only_a : plan.only_b).push_back(c->name);
        }
    }
    if (pattern.empty()) plan.others = other_files(a, b);
    return plan;
}

VersusReport run_plan(const Side& a, const Side& b, const Plan& plan, const VersusOptions& options,
                      const std::function<void(std::size_t)>& done) {
    VersusReport report;
    report.same = plan.same;
    if (plan.pairs.empty()) return report;
    Worker worker(a, b, options);
    for (std::size_t i = 0; i < plan.pairs.size(); ++i) {
        const Pair& pair = plan.pairs[i];
        if (!plan.named && worker.ask(pair, Question::same_code).reply.same_code)
            ++report.same;
        else
            report.comparisons.push_back(compare_pair(worker, pair, options));
        if (done) done(i + 1);
    }
    return report;
}

} // namespace gnomon::versus
