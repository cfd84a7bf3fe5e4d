#include "casegen/fuzz/workers.h"

#include "runtime/clock.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace gnomon::fuzz {
namespace {

static_assert(std::atomic<std::uint32_t>::is_always_lock_free, "children share them");

/// Beyond what dispatches may take: drawing, judging and shrinking end, but a driver's compiler might not.
constexpr double patience = 300;

std::string serve(Fuzzer& fuzzer, std::span<const Case* const> cases, std::atomic<std::uint32_t>& batch,
                  const std::string& text) {
    const Request request = parse_request(text);
    const Unit unit{cases[request.kernel], request.round, request.evaluations, request.shrink,
                    request.batches};
    Reply reply;
    try {
        if (request.tell_inputs) {
            const std::vector<Input> all = fuzzer.inputs(unit, request.part->batch);
            for (std::size_t i = request.part->begin; i < request.part->end && i < all.size(); ++i)
                reply.inputs.push_back(all[i]);
        } else if (request.part) {
            fuzzer.dispatch(unit, *request.part);
        } else {
            reply.result = fuzzer.run(unit, request.known, batch);
        }
    } catch (const CompileError& error) {
        reply.compile_error = error.what();
    } catch (const KernelTimeout& error) {
        reply.timeout = error.what();
    }
    return format_reply(reply);
}

} // namespace

Workers::Workers(std::span<const Case* const> cases, const FuzzerOptions& options, unsigned count)
    : cases_(cases.begin(), cases.end()), options_(options), sent_(count) {
    void* memory = ::mmap(nullptr, count * sizeof(std::atomic<std::uint32_t>), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw Error("no memory to share with workers");
    batches_ = static_cast<std::atomic<std::uint32_t>*>(memory);
    for (unsigned i = 0; i < count; ++i) new (batches_ + i) std::atomic<std::uint32_t>(0);
    for (unsigned i = 0; i < count; ++i) start(i);
}

Workers::~Workers() {
    children_.clear();
    ::munmap(batches_, sent_.size() * sizeof(std::atomic<std::uint32_t>));
}

void Workers::start(std::size_t worker) {
    Child child([this, worker]() -> Child::Serve {
        // Workers are as many as cores: a driver with threads of its own would only have them wait.
        ::setenv("LP_NUM_THREADS", "0", 0);
        auto fuzzer = std::make_shared<Fuzzer>(options_);
        return [this, worker, fuzzer](const std::string& request) {
            return serve(*fuzzer, cases_, batches_[worker], request);
        };
    });
    if (worker < children_.size())
        children_[worker] = std::move(child);
    else
        children_.push_back(std::move(child));
}

void Workers::send(std::size_t worker, const Request& request) {
    batches_[worker] = request.part ? static_cast<std::uint32_t>(request.part->batch) : 0u;
    sent_[worker] = seconds_now();
    children_[worker].send(format_request(request));
}

std::size_t Workers::wait(double seconds) {
    const std::size_t ready = wait_for_any(children_, seconds);
    if (ready < children_.size()) return ready;
    for (std::size_t i = 0; i < children_.size(); ++i)
        if (children_[i].busy() && seconds_now() - sent_[i] > patience + 10 * options_.device.time_limit) {
            children_[i].kill();
            return i;
        }
    return children_.size();
}

Outcome Workers::receive(std::size_t worker) {
    const Answer answer = children_[worker].receive(patience);
    Outcome outcome;
    outcome.batch = batches_[worker];
    switch (answer.kind) {
    case Answer::Kind::message:
        outcome.reply = parse_reply(answer.text);
        if (!outcome.reply.timeout.empty()) start(worker); // its device is lost
        break;
    case Answer::Kind::error:
        throw Error("a worker cannot go on: {}", answer.text);
    case Answer::Kind::late:
        children_[worker].kill();
        outcome.death = "it did not answer and was ended";
        start(worker);
        break;
    case Answer::Kind::death:
        outcome.death = answer.text;
        start(worker);
        break;
    }
    return outcome;
}

Outcome Workers::ask(std::size_t worker, const Request& request) {
    send(worker, request);
    return receive(worker);
}

} // namespace gnomon::fuzz
