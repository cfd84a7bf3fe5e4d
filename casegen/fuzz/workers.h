// The processes that do a campaign's units.
#pragma once

#include "casegen/fuzz/message.h"
#include "runtime/process.h"

#include <atomic>
#include <memory>
#include <span>
#include <vector>

namespace gnomon::fuzz {

/// What a worker came to.
struct Outcome {
    Reply reply;
    std::string death;       ///< not empty: it is no more, and another one stands in its place
    std::uint32_t batch = 0; ///< in which it died, or did not end
};

/// Forks: make it while this process has neither threads nor a device.
class Workers {
public:
    Workers(std::span<const Case* const> cases, const FuzzerOptions& options, unsigned count);
    ~Workers();
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    std::size_t size() const { return children_.size(); }
    bool busy(std::size_t worker) const { return children_[worker].busy(); }
    void send(std::size_t worker, const Request& request);
    /// The number of one that has come to something, waiting at most so long; size() if none has.
    std::size_t wait(double seconds);
    /// Replaces one that died or hangs. Throws Error for what concerns all units (no device).
    Outcome receive(std::size_t worker);
    /// Both at once.
    Outcome ask(std::size_t worker, const Request& request);

private:
    void start(std::size_t worker);

    std::vector<const Case*> cases_;
    FuzzerOptions options_;
    std::vector<Child> children_;
    std::atomic<std::uint32_t>* batches_ = nullptr; ///< shared with the children, one each
    std::vector<double> sent_;                      ///< when
};

} // namespace gnomon::fuzz
