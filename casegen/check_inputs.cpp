#include "casegen/check_inputs.h"

#include "casegen/fuzz/regression.h"

namespace gnomon {

Sampler make_sampler(const Case& c, const CheckOptions& options, const std::shared_ptr<const EdgePool>& pool,
                     std::span<const CsvInput> regressions) {
    const auto file = [&](const std::filesystem::path& folder) {
        return folder.empty() ? folder : folder / (c.name + ".csv");
    };
    return {c,          options.seed.value_or(default_seed(c)), pool, file(options.pins), file(options.worst),
            regressions};
}

std::map<std::string, std::vector<CsvInput>> load_inputs_of_regressions(std::span<const Case* const> cases,
                                                                        const CheckOptions& options) {
    std::map<std::string, std::vector<CsvInput>> inputs;
    for (const Case* c : cases) inputs[c->name];
    for (const auto& [name, all] : fuzz::load_regressions(options.regressions))
        for (const fuzz::Regression& regression : all) inputs[name].push_back(regression.input);
    return inputs;
}

} // namespace gnomon
