// Child processes that answer requests: what may crash, hang or exhaust memory is asked of a child, and costs
// no more than that child.
//
//     Child child([] {                                       // runs in the child, once: devices, tables
//         auto device = std::make_shared<gpu::Device>();
//         return [device](const std::string& request) { return answer(*device, request); };
//     });
//     child.send("smsr/case_09");
//     const Answer answer = child.receive(20);               // a message, an error, a death, or nothing yet
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include <sys/types.h>

namespace gnomon {

/// What came of a request.
struct Answer {
    enum class Kind {
        message, ///< `text` is what the child's function returned
        error,   ///< it threw: `text` is what() of it, and the child lives on unless it threw while starting
        death,   ///< the child is no more: `text` says how it ended, "signal 11 (Segmentation fault)"
        late,    ///< nothing came in time; the child is still at it
    };
    Kind kind = Kind::message;
    std::string text;
};

/// A fork of this process that serves one request after the other. It dies with this object, and with this
/// process however that ends; it ignores SIGINT and SIGTERM, which are sent to whole groups. Fork before this
/// process has threads or a device: neither survives in a child.
class Child {
public:
    using Serve = std::function<std::string(const std::string& request)>;
    using Start = std::function<Serve()>;

    /// Throws Error if the system refuses another process. What `start` throws is the answer to the first
    /// request.
    explicit Child(const Start& start);
    Child(Child&& other) noexcept;
    Child& operator=(Child&& other) noexcept;
    ~Child(); ///< kills it

    /// Of a child that has died the next answer says so. One request at a time: receive its answer first.
    void send(std::string_view request);
    /// Waits at most so long. A death is told once and for all: every later answer is the same.
    Answer receive(double seconds);
    /// Whether a request is without an answer.
    bool busy() const { return busy_; }
    /// Ends it, whatever it is doing; the next answer is a death.
    void kill();

    int descriptor() const { return socket_; } ///< readable when an answer, or a death, is there
    pid_t pid() const { return pid_; }

private:
    Answer ended();

    pid_t pid_ = -1;
    int socket_ = -1;
    bool busy_ = false;
    std::string partial_; ///< what was read of an answer so far
    std::string end_;     ///< how it ended, once that is known
};

/// The first of `children` that is busy and has something to say, waiting at most so long; their number if
/// none has.
std::size_t wait_for_any(std::span<const Child> children, double seconds);

} // namespace gnomon
