// Worker threads, each with a device of its own.
#pragma once

#include "runtime/gpu/device.h"

#include <cstddef>
#include <functional>
#include <future>
#include <optional>

namespace gnomon {

/// Started in the background, and replaced when a kernel has hung it. With an instance of its own, so that
/// other workers' devices go on then.
class WorkerDevice {
public:
    explicit WorkerDevice(const gpu::DeviceOptions& options) : options_(options) {
        options_.isolated = true;
        restart();
    }
    gpu::Device& get() {
        if (starting_.valid()) device_.emplace(starting_.get());
        return *device_;
    }
    void restart() {
        starting_ = std::async(std::launch::async, [options = options_] { return gpu::Device(options); });
    }

private:
    gpu::DeviceOptions options_;
    std::future<gpu::Device> starting_;
    std::optional<gpu::Device> device_;
};

/// Calls `act(i, device)` once for every i below `count`, in `jobs` threads (0: one per core; never more than
/// there are calls), which take the next i in turn. What a call throws ends the work and is thrown from here.
/// `first`, if there is one, serves one of the threads, with options of its own.
void on_worker_devices(std::size_t count, unsigned jobs, const gpu::DeviceOptions& options,
                       const std::function<void(std::size_t, WorkerDevice&)>& act,
                       WorkerDevice* first = nullptr);

} // namespace gnomon
