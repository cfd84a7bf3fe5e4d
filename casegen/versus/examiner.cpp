#include "casegen/versus/examiner.h"

#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/fuzz/regression.h"
#include "casegen/fuzz/subject.h"
#include "casegen/measure/accuracy.h"
#include "casegen/measure/inputs.h"
#include "casegen/measure/variant.h"
#include "runtime/error.h"
#include "runtime/glsl/names.h"
#include "runtime/gpu/validation.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gnomon::versus {
namespace {

namespace fs = std::filesystem;

/// What both kernels are asked: on the whole of a quantity's domain, if they are forms of one.
Case question_of(const Pair& pair) {
    if (pair.a == pair.b) return *pair.a;
    const std::array<const Case*, 2> both{pair.a, pair.b};
    constexpr std::array mode{Trigonometry::portable};
    const std::vector<measure::Group> groups = measure::group(both, mode, {});
    return groups.size() == 1 ? groups.front().quantity : *pair.a;
}

bool is_conditioned(const Case& c) { return c.tolerance.kind == Tolerance::Kind::conditioned; }

CsvInput input_of(const Records& records, std::size_t i) {
    const std::span<const std::uint32_t> words = records.input(i);
    return {{words.begin(), words.end()}, records.mask(i) ? *records.mask(i) : Mask()};
}

} // namespace

bool share_signature(const Case& a, const Case& b) {
    return a.reference.parameters == b.reference.parameters && a.reference.result == b.reference.result &&
           a.reference.takes_mask == b.reference.takes_mask;
}

struct Examiner::Impl {
    std::array<Side, 2> sides;
    ExaminerOptions options;
    std::optional<gpu::Device> device;
    std::shared_ptr<const EdgePool> pool;
    std::map<std::string, std::vector<fuzz::Regression>> regressions;

    /// The pair that is at hand: its inputs, and what either side made of them.
    struct AtHand {
        Pair pair;
        Case question;
        std::vector<CsvInput> fixed;
        std::optional<Sampler> sampler;
        std::optional<Records> records;
        std::vector<std::uint8_t> defined;
        std::array<std::vector<std::uint32_t>, 2> results;
        std::array<std::vector<bool>, 2> passed; ///< per record, by the side's own table
    };
    std::unique_ptr<AtHand> at_hand;

    gpu::Device& get_device() {
        if (!device) device.emplace(options.device);
        return *device;
    }

    fs::path file(const fs::path& folder, const Case& c) const {
        return folder.empty() ? folder : folder / (c.name + ".csv");
    }

    AtHand& at(const Pair& pair) {
        if (at_hand && at_hand->pair.a == pair.a && at_hand->pair.b == pair.b) return *at_hand;
        at_hand = std::make_unique<AtHand>(); // in its place: the sampler refers to the question
        AtHand& made = *at_hand;
        made.pair = pair;
        made.question = question_of(pair);
        if (!pool)
            pool = std::make_shared<const EdgePool>(
                make_edge_pool(options.seed.value_or(default_seed("masks"))));
        const auto add_regressions = [&](const Case& c) {
            for (const fuzz::Regression& regression : regressions[c.name])
                made.fixed.push_back(regression.input);
        };
        add_regressions(*pair.a);
        if (pair.a != pair.b) {
            add_regressions(*pair.b);
            for (const fs::path& path : {file(options.worst, *pair.b), file(options.pins, *pair.b)})
                if (!path.empty() && fs::is_regular_file(path))
                    for (CsvInput& input : read_inputs(*pair.b, path)) made.fixed.push_back(std::move(input));
        }
        made.sampler.emplace(made.question, options.seed.value_or(default_seed(*pair.a)), pool,
                             file(options.pins, *pair.a), file(options.worst, *pair.a), made.fixed);
        const std::size_t samples =
            std::max(options.samples.value_or(default_samples(made.question)), made.sampler->fixed_count());
        made.records.emplace(made.question);
        made.records->reserve(samples);
        for (std::size_t i = 0; i < samples; ++i) {
            made.records->add_with(
                [&](std::span<std::uint32_t> words) { return made.sampler->draw(i, words); });
            const Arguments with = arguments(made.question, made.records->input(i), made.records->mask(i));
            made.defined.push_back(in_domain(made.question, with) ? 1 : 0);
        }
        return made;
    }

    /// A lone file stands for the kernel's, and compilers say so; people wrote the other one.
    void name_lone_file(std::string& message, const Case& c, int side) const {
        const Side& of = sides[static_cast<std::size_t>(side)];
        const std::string name = c.name + ".glsl";
        const std::string shown = (of.folder.filename() / name).generic_string();
        if (!of.overlaid.contains(name)) return;
        for (std::size_t at = message.find(shown); at != message.npos;
             at = message.find(shown, at + of.label.size()))
            message.replace(at, shown.size(), of.label);
    }

    const Case& kernel(const Pair& pair, int side) const { return side == 0 ? *pair.a : *pair.b; }

    void judge_side(AtHand& at, int side, SideReport& report) const {
        const Case& c = kernel(at.pair, side);
        const std::vector<std::uint32_t>& results = at.results[static_cast<std::size_t>(side)];
        const auto components = static_cast<std::size_t>(c.reference.result.components);
        // Errors are told on the whole of the question's domain, verdicts are the kernel's own.
        Case asked = c;
        asked.where = at.question.where;
        asked.parameters = at.question.parameters;
        const std::vector<Truth> truths = measure::truths_on(asked, *at.records, 0, default_truth_files());
        measure::Inputs inputs(asked);
        std::vector<std::uint32_t> defined_results;
        std::vector<bool>& passed = at.passed[static_cast<std::size_t>(side)];
        passed.clear();
        for (std::size_t i = 0; i < at.records->size(); ++i) {
            const std::span<const std::uint32_t> input = at.records->input(i);
            const Mask* mask = at.records->mask(i);
            const std::span<const std::uint32_t> got = std::span(results).subspan(i * components, components);
            passed.push_back(
                judge(c, arguments(c, input, mask), got, truths.empty() ? nullptr : &truths[i]).pass);
            if (!passed.back()) ++report.wrong;
            if (at.defined[i] == 0) continue;
            inputs.records.add(input, mask);
            if (!truths.empty()) inputs.truths.push_back(truths[i]);
            defined_results.insert(defined_results.end(), got.begin(), got.end());
        }
        // What a tolerance allows is told in the unit of the tolerance, if both sides have the same.
        const bool of_limit = !truths.empty() && is_conditioned(*at.pair.a) && is_conditioned(*at.pair.b);
        std::vector<double> errors;
        for (const measure::Deviation& one : measure::deviations(asked, inputs, defined_results))
            errors.push_back(of_limit ? one.of_limit : one.of_scale);
        report.error = measure::quantiles(std::move(errors));
        report.unit = of_limit ? "of the limit" : measure::unit_of(c);
    }
};

Examiner::Examiner(const Side& a, const Side& b, const ExaminerOptions& options)
    : impl_(std::make_unique<Impl>()) {
    impl_->sides = {a, b};
    impl_->options = options;
    impl_->regressions = fuzz::load_regressions(options.regressions);
}

Examiner::~Examiner() = default;

bool Examiner::is_same_code(const Pair& pair) {
    return glsl::without_names(compile_standalone(*pair.a, sources_of(impl_->sides[0]))) ==
           glsl::without_names(compile_standalone(*pair.b, sources_of(impl_->sides[1])));
}

SideReport Examiner::run(const Pair& pair, int side) {
    const Case& c = impl_->kernel(pair, side);
    SideReport report;
    report.allowed = to_string(c.tolerance);
    glsl::Spirv words;
    try {
        words = compile_standalone(c, sources_of(impl_->sides[static_cast<std::size_t>(side)]));
    } catch (const CompileError& error) {
        report.failure = "compile error";
        report.message = error.what();
        std::ranges::replace(report.message, '\n', ' ');
        impl_->name_lone_file(report.message, c, side);
        return report;
    }
    Impl::AtHand& at = impl_->at(pair);
    gpu::Kernel kernel = impl_->get_device().kernel(words, c.name);
    const Outputs outputs = run_standalone(*impl_->device, kernel, c, *at.records);
    report.ran = true;
    report.seed = at.sampler->seed();
    report.samples = at.records->size();
    at.results[static_cast<std::size_t>(side)] = outputs.words;
    impl_->judge_side(at, side, report);
    report.failure = fuzz::failure_of(outputs);
    report.message = outputs.complaint();
    if (report.failure.empty() && report.wrong > 0) report.failure = "wrong";
    return report;
}

DifferenceReport Examiner::difference(const Pair& pair) {
    Impl::AtHand& at = impl_->at(pair);
    DifferenceReport report;
    report.counts = versus::difference(at.question, *at.records, at.defined, at.results[0], at.results[1]);
    for (std::size_t i = 0; i < at.records->size(); ++i)
        if (at.passed[0][i] && !at.passed[1][i]) ++report.lost;
    if (report.counts.differ == 0) return report;
    const std::size_t i = report.counts.worst;
    const CsvInput input = input_of(*at.records, i);
    const Mask* mask = at.records->mask(i);
    const auto components = static_cast<std::size_t>(pair.a->reference.result.components);
    const auto got = [&](std::size_t side, const Case& c) {
        return format_result(c, std::span(at.results[side]).subspan(i * components, components));
    };
    report.worst_defined = at.defined[i] != 0;
    report.call_a = format_call(*pair.a, input.words, mask);
    report.call_b = format_call(*pair.b, input.words, mask);
    report.got_a = got(0, *pair.a);
    report.got_b = got(1, *pair.b);
    if (report.worst_defined)
        report.want =
            format_result(at.question, at.question.reference.call(arguments(*pair.a, input.words, mask)));
    gnomon::Finding finding;
    finding.input = input.words;
    if (mask) finding.mask = *mask;
    report.command_a = replay_command(*pair.a, finding, impl_->sides[0].options);
    report.command_b = replay_command(*pair.b, finding, impl_->sides[1].options);
    return report;
}

PictureReport Examiner::draw(const Pair& pair) {
    Impl::AtHand& at = impl_->at(pair);
    const ExaminerOptions& options = impl_->options;
    const Difference counts =
        versus::difference(at.question, *at.records, at.defined, at.results[0], at.results[1]);
    const std::array<Axis, 2> axes = options.axes ? *options.axes : telling_axes(at.question, counts.where);
    CsvInput rest;
    if (options.at) {
        rest = *options.at;
    } else {
        const auto first_defined =
            static_cast<std::size_t>(std::ranges::find(at.defined, 1) - at.defined.begin());
        rest = input_of(*at.records,
                        counts.differ > 0 ? counts.worst : std::min(first_defined, at.records->size() - 1));
    }
    const Records records = picture_records(at.question, axes, options.size, rest);
    std::array<std::vector<std::uint32_t>, 2> results;
    for (const int side : {0, 1}) {
        const Case& c = impl_->kernel(pair, side);
        const Outputs outputs = evaluate(
            impl_->get_device(), sources_of(impl_->sides[static_cast<std::size_t>(side)]), c, records);
        if (const std::string complaint = outputs.complaint(); !complaint.empty())
            throw Error("{}: {}", c.name, complaint);
        results[static_cast<std::size_t>(side)] = outputs.words;
    }
    const Picture picture = picture_of(at.question, records, options.size, results[0], results[1]);
    PictureReport report;
    report.png = encode_png(picture.image);
    const auto described = [](const Axis& axis) {
        return axis.values.empty() || axis.values.size() > 8
                   ? fmt::format("{} from {:g} to {:g}", axis.name, axis.from, axis.to)
                   : fmt::format("{} = {:g}", axis.name, fmt::join(axis.values, ", "));
    };
    report.across = described(axes[0]);
    report.down = described(axes[1]);
    report.rest = format_call(*pair.a, rest.words, pair.a->reference.takes_mask ? &rest.mask : nullptr);
    report.scale = picture.scale;
    report.pixels = picture.image.pixels.size();
    report.differ = picture.differ;
    report.finiteness = picture.finiteness;
    report.both_nan = picture.both_nan;
    report.outside = picture.outside;
    return report;
}

measure::Pairing Examiner::time(const Pair& pair) {
    Impl::AtHand& at = impl_->at(pair);
    std::vector<std::size_t> ordinary, defined;
    for (std::size_t i = 0; i < at.records->size(); ++i)
        if (at.defined[i] != 0) {
            defined.push_back(i);
            if (i >= at.sampler->fixed_count()) ordinary.push_back(i);
        }
    return measure::time_pair(impl_->get_device(), {pair.a, sources_of(impl_->sides[0])},
                              {pair.b, sources_of(impl_->sides[1])}, *at.records,
                              ordinary.empty() ? defined : ordinary, impl_->options.timing);
}

} // namespace gnomon::versus
