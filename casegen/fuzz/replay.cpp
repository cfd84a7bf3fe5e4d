#include "casegen/fuzz/replay.h"

#include "casegen/fuzz/chain.h"
#include "casegen/fuzz/regression.h"
#include "casegen/standalone.h"
#include "runtime/error.h"

#include <fmt/format.h>

namespace gnomon::fuzz {
namespace {

CheckReport replay_one(const Chain& chain, std::span<const Regression> regressions, const Judge& judge) {
    CheckReport report;
    report.kernel = &chain.described;
    report.samples = regressions.size();
    std::vector<Input> inputs;
    for (const Regression& regression : regressions) inputs.push_back(regression.input);
    const std::vector<std::string> failures = judge(inputs);
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        if (failures[i].empty()) continue;
        ++report.failures;
        report.verdict = Verdict::wrong;
        report.message += fmt::format("{}{}: {}", report.message.empty() ? "" : "\n  ", failures[i],
                                      chain.format(inputs[i]));
    }
    return report;
}

} // namespace

std::vector<const Case*> with_regressions(std::span<const Case* const> chains,
                                          const std::filesystem::path& regressions) {
    std::vector<const Case*> found;
    if (chains.empty()) return found;
    const auto on_file = load_regressions(regressions);
    for (const Case* c : chains)
        if (on_file.contains(c->name)) found.push_back(c);
    return found;
}

std::vector<CheckReport> replay(std::span<const Case* const> chains, const CheckOptions& options,
                                WorkerDevice& device) {
    std::vector<CheckReport> reports;
    if (chains.empty()) return reports;
    const glsl::Sources sources = kernel_sources(options.kernels);
    const auto on_file = load_regressions(options.regressions);
    for (const Case* c : chains) {
        const Chain& chain = *find_chain(*c);
        try {
            reports.push_back(replay_one(chain, on_file.at(c->name), chain.judge(sources, device.get())));
        } catch (const CompileError& error) {
            reports.push_back({.kernel = c, .verdict = Verdict::compile_error, .message = error.what()});
        } catch (const KernelTimeout& error) {
            reports.push_back({.kernel = c, .verdict = Verdict::timeout, .message = error.what()});
            device.restart();
        }
    }
    return reports;
}

} // namespace gnomon::fuzz
