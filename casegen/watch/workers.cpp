#include "casegen/watch/workers.h"

#include "casegen/watch/stopwatch.h"
#include "casegen/watch/subject.h"
#include "runtime/error.h"
#include "runtime/files.h"

#include <cstdlib>
#include <future>
#include <optional>

namespace gnomon::watch {
namespace {

gpu::Device start_device(const Shared& shared) {
    std::future<void> tables = std::async(std::launch::async, glsl::warm_up);
    gpu::Device device(shared.options.device);
    tables.get();
    return device;
}

/// The machine code of unoptimised shaders, apart from the optimised.
void keep_unoptimised_code() {
    const std::filesystem::path folder = cache_directory() / "mesa-nopt";
    std::error_code ignored;
    std::filesystem::create_directories(folder, ignored);
    ::setenv("MESA_SHADER_CACHE_DIR", folder.c_str(), 1);
    ::setenv("GALLIVM_PERF", "nopt", 1);
}

std::shared_ptr<Subject> make_subject(const Shared& shared, std::size_t kernel) {
    const Case& c = *shared.cases[kernel];
    return std::make_shared<Subject>(c, shared.options, shared.pool, shared.regressions.at(c.name));
}

} // namespace

Child start_judge(const Shared& shared) {
    return Child([&shared]() -> Child::Serve {
        if (!std::getenv("GALLIVM_PERF")) keep_unoptimised_code();
        auto device = std::make_shared<gpu::Device>(start_device(shared));
        auto subjects = std::make_shared<std::map<std::size_t, std::shared_ptr<Subject>>>();
        return [&shared, device, subjects](const std::string& text) {
            const JudgeRequest request = parse_judge_request(text);
            Judgement judgement;
            try {
                std::shared_ptr<Subject>& subject = (*subjects)[request.kernel];
                if (!subject) subject = make_subject(shared, request.kernel);
                judgement =
                    subject->judge(*device, request.text, request.before, shared.folder, shared.replay);
            } catch (const std::exception& error) {
                judgement = {};
                judgement.cannot = error.what();
            }
            return format(judgement);
        };
    });
}

Child start_stopwatch(const Shared& shared) {
    return Child([&shared]() -> Child::Serve {
        auto stopwatch = std::make_shared<Stopwatch>(start_device(shared));
        auto subject = std::make_shared<std::pair<std::size_t, std::shared_ptr<Subject>>>();
        return [&shared, stopwatch, subject](const std::string& text) {
            const TimeRequest request = parse_time_request(text);
            Times times;
            try {
                if (request.what == TimeRequest::What::round) return format(stopwatch->round(request.round));
                if (!subject->second || subject->first != request.kernel)
                    *subject = {request.kernel, make_subject(shared, request.kernel)};
                times =
                    stopwatch->begin(*shared.cases[request.kernel], *subject->second, request, shared.folder);
            } catch (const KernelTimeout& error) {
                times = {};
                times.cannot = error.what();
                times.device_lost = true;
            } catch (const std::exception& error) {
                times = {};
                times.cannot = error.what();
            }
            return format(times);
        };
    });
}

} // namespace gnomon::watch
