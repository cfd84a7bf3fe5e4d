#include "casegen/worker_device.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace gnomon {

void on_worker_devices(std::size_t count, unsigned jobs, const gpu::DeviceOptions& options,
                       const std::function<void(std::size_t, WorkerDevice&)>& act, WorkerDevice* first) {
    const unsigned cores = std::max(1u, std::thread::hardware_concurrency());
    const std::size_t threads = std::min<std::size_t>(jobs > 0 ? jobs : cores, count);
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr failure;
    const auto work = [&](WorkerDevice* started) {
        try {
            std::optional<WorkerDevice> own;
            WorkerDevice& device = started ? *started : own.emplace(options);
            for (std::size_t i = next++; i < count; i = next++) act(i, device);
        } catch (...) {
            const std::scoped_lock lock(mutex);
            if (!failure) failure = std::current_exception();
            next = count;
        }
    };
    std::vector<std::jthread> workers;
    for (std::size_t i = 0; i < threads; ++i) workers.emplace_back(work, i == 0 ? first : nullptr);
    workers.clear();
    if (failure) std::rethrow_exception(failure);
}

} // namespace gnomon
