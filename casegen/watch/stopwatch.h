// What an evaluation costs before and after an edit: both states' loops are kept alive and run in turns, in
// the code that the optimising compiler makes.
#pragma once

#include "casegen/watch/message.h"
#include "casegen/watch/subject.h"

#include <array>
#include <cstdint>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace gnomon::watch {

class Stopwatch {
public:
    explicit Stopwatch(gpu::Device device) : device_(std::move(device)) {}

    /// Makes the loops of both states, and runs each for the driver's compiler; compares the results of
    /// `subject` with those that were judged. Throws CompileError, KernelTimeout.
    Times begin(const Case& c, Subject& subject, const TimeRequest& request, const std::string& folder);

    /// Nanoseconds per evaluation of the state before, the one after, and the one before again, in an order
    /// that changes with the round's number.
    Times round(unsigned number);

private:
    struct Loop {
        std::string text;
        gpu::Kernel kernel;
    };
    struct Inputs {
        const Case* kernel = nullptr;
        gpu::Buffer records, masks, results;
        double floor = 0; ///< nanoseconds that reading a record takes
    };
    std::shared_ptr<Loop> make(const Case& c, const std::string& text);
    std::shared_ptr<Loop> loop(const Case& c, const std::string& text);
    double run(gpu::Kernel& kernel, std::uint32_t threads, bool reads_masks);
    void upload(const Case& c, const Subject& subject);

    gpu::Device device_;
    std::list<std::shared_ptr<Loop>> kept_; ///< the latest first
    Inputs inputs_;
    std::array<std::shared_ptr<Loop>, 3> turns_; ///< before, after, before again
    std::uint32_t threads_ = 0;
};

} // namespace gnomon::watch
