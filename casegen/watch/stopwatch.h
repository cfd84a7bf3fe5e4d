// What an evaluation costs before and after an edit: both states' loops are kept alive and run in turns, in
// the code that the optimising compiler makes.
#pragma once

#include "casegen/measure/loop.h"
#include "casegen/watch/message.h"
#include "casegen/watch/subject.h"

#include <array>
#include <list>
#include <memory>
#include <string>
#include <utility>

namespace gnomon::watch {

class Stopwatch {
public:
    explicit Stopwatch(gpu::Device device) : device_(std::move(device)) {}

    /// Makes the loops of both states, and runs each for the driver's compiler; compares the results of
    /// `subject` with those that were judged. Throws CompileError, KernelTimeout.
    Times begin(const Case& c, Subject& subject, const TimeRequest& request, const std::string& folder);

    /// Nanoseconds per evaluation of the state before, the one after, the one before again, and of reading
    /// the inputs alone, in an order that changes with the round's number.
    Times round(unsigned number);

private:
    struct Kept {
        std::string text;
        measure::Loop loop;
        std::uint32_t threads =
            0; ///< that make its dispatch long enough; the loop's are those of its last turn
    };
    void upload(const Case& c, const Subject& subject);
    std::shared_ptr<Kept> make(const Case& c, const std::string& text);
    std::shared_ptr<Kept> find(const Case& c, const std::string& text);

    gpu::Device device_;
    const Case* kernel_ = nullptr; ///< that the buffers are of
    measure::LoopBuffers buffers_;
    measure::Loop reads_;
    std::list<std::shared_ptr<Kept>> kept_;      ///< the latest first
    std::array<std::shared_ptr<Kept>, 3> turns_; ///< before, after, before again
};

} // namespace gnomon::watch
