#include "casegen/measure/bench.h"

#include "casegen/check.h"
#include "casegen/compare.h"
#include "runtime/error.h"
#include "runtime/glsl/optimizer.h"

namespace gnomon::measure {
namespace {

std::vector<std::uint32_t> results_of(gpu::Device& device, const Variant& variant, const Inputs& inputs,
                                      const std::filesystem::path& kernels) {
    const Case& c = *variant.kernel;
    Outputs outputs = evaluate(device, kernel_sources(kernels, {}, variant.trigonometry), c, inputs.records);
    // Of a kernel that must fail even an unwritten result is no surprise: it reads as NaN.
    if (const std::string complaint = outputs.complaint(); !complaint.empty() && c.fails.empty())
        throw Error("{}: {}; gnomon check {} tells more", c.name, complaint, c.name);
    return std::move(outputs.words);
}

std::size_t count_beyond_tolerance(const Case& c, const Inputs& inputs,
                                   std::span<const std::uint32_t> results) {
    if (!c.fails.empty()) return 0; // it must be wrong
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    std::size_t count = 0;
    for (std::size_t i = 0; i < inputs.records.size(); ++i) {
        const Arguments with = arguments(c, inputs.records.input(i), inputs.records.mask(i));
        if (!in_domain(c, with)) continue;
        const Truth* known = inputs.truths.empty() ? nullptr : &inputs.truths[i];
        if (!judge(c, with, results.subspan(i * components, components), known).pass) ++count;
    }
    return count;
}

GroupResult measure_group(gpu::Device& device, const Group& group, const BenchOptions& options) {
    GroupResult result;
    result.group = group;
    const Case& c = group.quantity;
    result.unit = unit_of(c);
    result.has_limit = static_cast<bool>(c.reference.truth);
    result.seed = options.seed.value_or(default_seed(c));
    const Inputs inputs = draw_inputs(c, {options.samples, options.repeats, result.seed, options.jobs});
    result.classes = inputs.classes;
    result.class_counts.assign(inputs.classes.size(), 0);
    for (const std::size_t of_class : inputs.class_of) ++result.class_counts[of_class];
    result.inputs = inputs.records.size();
    result.left_out = inputs.left_out;

    for (const Variant& variant : group.variants) {
        const std::vector<std::uint32_t> words = results_of(device, variant, inputs, options.kernels);
        result.accuracy.push_back(summarise(c, inputs, deviations(c, inputs, words)));
        result.beyond_tolerance.push_back(count_beyond_tolerance(*variant.kernel, inputs, words));
        result.instructions.push_back(glsl::optimized_instructions(
            compile_standalone(*variant.kernel, kernel_sources(options.kernels, {}, variant.trigonometry))));
    }
    if (options.rounds == 0) return result;
    result.timings = time_variants(device, group, inputs, {options.kernels, options.rounds, result.seed});
    const Timings& last = result.timings.back(); // with the reading, which the noise is a fraction of too
    for (std::size_t rank = 0; rank < ranks.size(); ++rank) {
        std::vector<Point> points;
        for (std::size_t i = 0; i < group.variants.size(); ++i)
            points.push_back({last.floor + last.variants[i].median,
                              error_at(result.accuracy[i].all.of_scale, ranks[rank])});
        result.dominated[rank] = dominated_by(points, last.noise());
    }
    return result;
}

} // namespace

const char* to_string(Rank rank) {
    switch (rank) {
    case Rank::median:
        return "median";
    case Rank::p99:
        return "99 %";
    case Rank::most:
        break;
    }
    return "max";
}

double error_at(const Quantiles& quantiles, Rank rank) {
    switch (rank) {
    case Rank::median:
        return quantiles.median;
    case Rank::p99:
        return quantiles.p99;
    case Rank::most:
        break;
    }
    return quantiles.most;
}

Bench bench(std::span<const Group> groups, const BenchOptions& options,
            const std::function<void(std::size_t)>& done) {
    require_kernels(options.kernels);
    gpu::Device device(options.device);
    Bench all{machine(device),
              device.info().driver,
              glsl::version() + ", " + glsl::optimizer_version(),
              options,
              {}};
    for (const Group& group : groups) {
        all.groups.push_back(measure_group(device, group, options));
        if (done) done(all.groups.size());
    }
    return all;
}

} // namespace gnomon::measure
