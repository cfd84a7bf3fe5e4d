#include "casegen/fuzz/mask_chain.h"

#include "casegen/check.h"
#include "casegen/compare.h"
#include "casegen/composition.h"
#include "casegen/fuzz/subject.h"
#include "casegen/symmetry.h"
#include "runtime/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <utility>

namespace gnomon::fuzz {
namespace {

using Words = std::vector<std::uint32_t>;
using reference::Edge;

/// RSMSS's cases whose light the mask's opposite takes away: all but slots and bars that both ends close, or
/// that a breach far away decides about. docs/revectorization.md 4.4
constexpr std::array complementary{1u, 2u, 9u, 11u, 16u, 17u, 18u, 19u, 20u, 21u, 22u, 23u};
/// RSMSS's cases that the five shapes give the same light as. docs/revectorization.md 5.1
constexpr std::array like_shapes{2u,  3u,  16u, 17u, 18u, 20u, 21u, 22u,
                                 23u, 24u, 25u, 26u, 28u, 29u, 30u, 31u};

template <std::size_t N>
bool among(const std::array<unsigned, N>& numbers, unsigned number) {
    return std::ranges::find(numbers, number) != numbers.end();
}

float as_float(std::uint32_t word) { return std::bit_cast<float>(word); }

/// Points whose mirror images are exact: 1 - p is.
glm::vec2 rounded(glm::vec2 p) {
    const auto round = [](float v) { return v >= 0 && v <= 1 ? std::round(v * 256) / 256 : 0.0f; };
    return {round(p.x), round(p.y)};
}

Mask opposite(const Mask& mask) {
    Mask result = mask;
    for (std::uint8_t& texel : result.texels) texel = texel != 0 ? 0 : 1;
    if (result.outside != Outside::clamp)
        result.outside = result.outside == Outside::lit ? Outside::shadow : Outside::lit;
    return result;
}

TexelPoint point_of(const Input& input) {
    return {&input.mask,
            {std::bit_cast<std::int32_t>(input.words[0]), std::bit_cast<std::int32_t>(input.words[1])},
            {as_float(input.words[2]), as_float(input.words[3])}};
}

Arguments arguments_of(const TexelPoint& at) {
    Arguments arguments;
    arguments.mask = at.mask;
    arguments.numbers[0] = at.texel.x;
    arguments.numbers[1] = at.texel.y;
    arguments.numbers[2] = static_cast<double>(at.p.x);
    arguments.numbers[3] = static_cast<double>(at.p.y);
    return arguments;
}

bool may_be(const Case& visibility, const TexelPoint& at, std::uint32_t value) {
    return judge(visibility, arguments_of(at), std::span(&value, 1)).pass;
}

/// Whether two values of what ought to be one light may both stand: steps where rounding may decide which
/// side of the line a point is on, so that either would be right; else as far apart as each may be from the
/// truth.
bool agree(const Case& a, const TexelPoint& at_a, std::uint32_t value_a, const Case& b,
           const TexelPoint& at_b, std::uint32_t value_b) {
    if (value_a == value_b) return true;
    if (a.tolerance.kind == Tolerance::Kind::absolute && b.tolerance.kind == Tolerance::Kind::absolute)
        return std::abs(as_float(value_a) - as_float(value_b)) <= a.tolerance.amount + b.tolerance.amount;
    return (may_be(a, at_a, value_a) && may_be(a, at_a, value_b)) ||
           (may_be(b, at_b, value_a) && may_be(b, at_b, value_b));
}

/// Kernels of one technique on one device.
class MaskChain {
public:
    MaskChain(const Family& family, const glsl::Sources& sources, gpu::Device& device)
        : family_(family), visibility_(*find_kernel(family, "visibility")),
          number_(*find_kernel(family, "number")), sources_(sources), device_(device) {}

    std::vector<std::string> judge_all(std::span<const Input> inputs) {
        failures_.assign(inputs.size(), {});
        points_.clear();
        for (const Input& input : inputs) points_.push_back(point_of(input));
        values_ = assembled(visibility_, points_);
        numbers_ = assembled(number_, points_);
        edges_.clear();
        for (const TexelPoint& at : points_)
            edges_.push_back(is_near(at) ? reference::edge(*at.mask, at.texel) : Edge{});
        judge_ranges();
        judge_parts();
        judge_images();
        judge_along_runs();
        if (is_filter()) judge_opposite();
        if (family_.name.starts_with("rbsm/")) judge_against_cases();
        judge_by_references(); // last: the others say more
        return std::move(failures_);
    }

    /// What a run itself complained of, whatever the values; then nothing.
    std::string take_complaint() { return std::exchange(complaint_, {}); }

private:
    bool is_filter() const { return family_.name == "rsmss" || family_.name == "rbsm/filter"; }

    static bool is_near(const TexelPoint& at) { // no walk ends far away
        return std::abs(at.texel.x) < 1 << 14 && std::abs(at.texel.y) < 1 << 14;
    }

    Words run(const Case& c, const Records& records) {
        const auto found = kernels_.find(&c);
        gpu::Kernel& kernel =
            found != kernels_.end()
                ? found->second
                : kernels_.try_emplace(&c, device_.kernel(compile_standalone(c, sources_), c.name))
                      .first->second;
        Outputs outputs = run_standalone(device_, kernel, c, records);
        if (const std::string failure = failure_of(outputs); !failure.empty() && complaint_.empty())
            complaint_ = fmt::format("{} by {}", failure, c.name);
        return std::move(outputs.words);
    }
    Words assembled(const Case& c, std::span<const TexelPoint> points) {
        if (points.empty()) return {};
        return run_assembled(c, points,
                             [&](const Case& k, const Records& records) { return run(k, records); });
    }

    /// The first invariant that breaks is the failure. Where the conditions say a number, it is part of it.
    void fail(std::size_t i, const std::string& invariant) {
        if (!failures_[i].empty()) return;
        failures_[i] = invariant;
        if (const unsigned number = number_by_conditions(family_, edges_[i]);
            number != 0 && edges_[i].sides != glm::uvec2(0))
            failures_[i] += fmt::format(" in case {}", number);
    }

    void judge_ranges() {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            const float value = as_float(values_[i]);
            if (!(value >= 0 && value <= 1)) fail(i, std::isnan(value) ? "NaN" : "out of range");
            if (!is_filter() && value != 0 && value != 1) fail(i, "neither lit nor shadowed");
            if (is_near(points_[i]) && !is_filter() && !edges_[i].lit && value != 0)
                fail(i, "light in shadow");
        }
    }

    void judge_by_references() {
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!is_near(points_[i])) continue;
            if (numbers_[i] !=
                static_cast<std::uint32_t>(number_.reference.call(arguments_of(points_[i]))[0]))
                fail(i, "another number than the conditions say");
            if (!may_be(visibility_, points_[i], values_[i])) fail(i, "wrong");
        }
    }

    void judge_parts() {
        Composition parts(points_, [&](const Case& c, const Records& records) { return run(c, records); });
        const Composition::Composed composed = parts.compose(family_);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (composed.numbers[i] != numbers_[i]) fail(i, "another number than the parts give");
            const bool both_nan =
                std::isnan(as_float(composed.visibility[i])) && std::isnan(as_float(values_[i]));
            if (composed.visibility[i] != values_[i] && !both_nan)
                fail(i, "another value than the parts give");
        }
    }

    /// The points with their coordinates rounded, of those that are near the mask: what images are compared
    /// at.
    void set_rounded() {
        which_.clear();
        here_.clear();
        for (std::size_t i = 0; i < points_.size(); ++i) {
            if (!is_near(points_[i])) continue;
            which_.push_back(i);
            here_.push_back({points_[i].mask, points_[i].texel, rounded(points_[i].p)});
        }
        here_values_ = assembled(visibility_, here_);
    }

    void judge_images() {
        set_rounded();
        for (const Symmetry& turn : symmetries) {
            std::map<const Mask*, Mask> images;
            std::vector<TexelPoint> there;
            for (const TexelPoint& at : here_) {
                auto found = images.find(at.mask);
                if (found == images.end()) found = images.emplace(at.mask, turn.of_mask(*at.mask)).first;
                there.push_back({&found->second, turn.of_texel(*at.mask, at.texel),
                                 glm::vec2(turn.of_point(glm::dvec2(at.p)))});
            }
            const Words numbers = assembled(number_, there), values = assembled(visibility_, there);
            for (std::size_t n = 0; n < there.size(); ++n) {
                const std::size_t i = which_[n];
                if (numbers[n] != image_number(turn, numbers_[i], edges_[i]))
                    fail(i, fmt::format("another number {}", turn.name));
                if (!agree(visibility_, here_[n], here_values_[n], visibility_, there[n], values[n]))
                    fail(i, fmt::format("another value {}", turn.name));
            }
        }
    }
    unsigned image_number(const Symmetry& turn, unsigned number, const Edge& edge) const {
        if (family_.name == "smsr") return turn.of_number(number, edge.sides);
        return family_.name == "rsmss" ? turn.of_rsmss_number(number) : number;
    }

    /// Beside a straight edge the light goes on from one texel of a run to the next.
    void judge_along_runs() {
        std::vector<TexelPoint> ends, beginnings;
        std::vector<std::size_t> which;
        for (std::size_t n = 0; n < here_.size(); ++n)
            for (const glm::ivec2 step : {glm::ivec2(1, 0), glm::ivec2(0, 1)}) {
                const bool y = step.y == 1;
                const TexelPoint& at = here_[n];
                const Edge& edge = edges_[which_[n]];
                const Edge next = reference::edge(*at.mask, at.texel + step);
                const unsigned across = y ? edge.sides.x : edge.sides.y,
                               along = y ? edge.sides.y : edge.sides.x;
                if (along != 0 || across == 0 || across == reference::both || edge.sides != next.sides ||
                    edge.lit != next.lit || edge.type != next.type || (y ? edge.type.y : edge.type.x) != 0)
                    continue;
                const glm::ivec2 reach =
                    y ? glm::ivec2(edge.reach.z, edge.reach.w) : glm::ivec2(edge.reach.x, edge.reach.y);
                const glm::ivec2 reach_next =
                    y ? glm::ivec2(next.reach.z, next.reach.w) : glm::ivec2(next.reach.x, next.reach.y);
                // One texel further from one end, one nearer to the other: neither walk has met its limit.
                if (std::abs(reach_next.x) != std::abs(reach.x) + 1 ||
                    std::abs(reach_next.y) != std::abs(reach.y) - 1)
                    continue;
                which.push_back(which_[n]);
                ends.push_back({at.mask, at.texel, y ? glm::vec2(at.p.x, 1) : glm::vec2(1, at.p.y)});
                beginnings.push_back(
                    {at.mask, at.texel + step, y ? glm::vec2(at.p.x, 0) : glm::vec2(0, at.p.y)});
            }
        const Words before = assembled(visibility_, ends), after = assembled(visibility_, beginnings);
        for (std::size_t n = 0; n < which.size(); ++n)
            if (!agree(visibility_, ends[n], before[n], visibility_, beginnings[n], after[n]))
                fail(which[n], "does not go on along the run");
    }

    /// Light and shadow exchanged.
    void judge_opposite() {
        std::map<const Mask*, Mask> opposites;
        std::vector<TexelPoint> there;
        for (const TexelPoint& at : here_) {
            auto found = opposites.find(at.mask);
            if (found == opposites.end()) found = opposites.emplace(at.mask, opposite(*at.mask)).first;
            there.push_back({&found->second, at.texel, at.p});
        }
        const Words values = assembled(visibility_, there);
        for (std::size_t n = 0; n < there.size(); ++n) {
            const std::size_t i = which_[n];
            if (family_.name == "rsmss" &&
                !(edges_[i].lit && among(complementary, number_by_conditions(family_, edges_[i]))))
                continue;
            const double sum = static_cast<double>(as_float(here_values_[n])) + as_float(values[n]);
            if (!(std::abs(sum - 1) <= 2 * visibility_.tolerance.amount))
                fail(i, "the opposite mask does not take its light away");
        }
    }

    /// Shapes against the cases that they replace.
    void judge_against_cases() {
        const Family& cases = technique_family(is_filter() ? "rsmss" : "smsr");
        const Case& visibility = *find_kernel(cases, "visibility");
        const Words values = assembled(visibility, here_);
        for (std::size_t n = 0; n < here_.size(); ++n) {
            const std::size_t i = which_[n];
            const unsigned number = number_by_conditions(cases, edges_[i]);
            const bool slot = edges_[i].sides.x == reference::both || edges_[i].sides.y == reference::both;
            if (is_filter() ? !among(like_shapes, number) : !edges_[i].lit || (number == 1 && slot)) continue;
            // At corners where both edges go on the four shapes may darken more, and never less.
            if (!is_filter() && number == 8 && as_float(here_values_[n]) <= as_float(values[n])) continue;
            if (!agree(visibility_, here_[n], here_values_[n], visibility, here_[n], values[n]))
                fail(i, fmt::format("another value than {}", visibility.name));
        }
    }

    const Family& family_;
    const Case &visibility_, &number_;
    glsl::Sources sources_;
    gpu::Device& device_;
    std::map<const Case*, gpu::Kernel> kernels_;
    std::string complaint_;
    // Of the batch that is judged.
    std::vector<std::string> failures_;
    std::vector<TexelPoint> points_, here_;
    std::vector<std::size_t> which_; ///< of here_, numbers of points_
    std::vector<Edge> edges_;
    Words values_, numbers_, here_values_;
};

/// What a dispatch complains of no single value tells: the first input that has it complain alone, else the
/// first of those that do so together.
std::vector<std::string> judge_apart(MaskChain& chain, std::span<const Input> inputs) {
    std::vector<std::string> failures = chain.judge_all(inputs);
    const std::string complaint = chain.take_complaint();
    if (complaint.empty()) return failures;
    std::size_t begin = 0, end = inputs.size();
    const auto complains = [&](std::size_t from, std::size_t to) {
        chain.judge_all(inputs.subspan(from, to - from));
        return chain.take_complaint() == complaint;
    };
    while (end - begin > 1) {
        const std::size_t middle = begin + (end - begin) / 2;
        if (complains(begin, middle))
            end = middle;
        else if (complains(middle, end))
            begin = middle;
        else
            break;
    }
    failures.assign(inputs.size(), {}); // the values mean nothing
    failures[begin] = complaint;
    return failures;
}

} // namespace

Chain mask_chain(const Family& family) {
    Chain chain;
    chain.described = *find_kernel(family, "visibility");
    chain.described.name = "chain/" + technique_name(family);
    chain.described.source = "docs/fuzzing.md";
    chain.batch = 4096;
    chain.batches = 4;
    chain.invariants = {"number and value are what the parts give, one after the other",
                        "the number is that of the one case whose conditions hold",
                        "the value is within the tolerance of the reference, and within its range",
                        "the transposed and the mirrored mask give the same",
                        "beside a straight edge the light goes on from texel to texel"};
    const bool is_filter = family.name == "rsmss" || family.name == "rbsm/filter";
    chain.invariants.push_back(is_filter ? "the opposite mask takes away what this one gives"
                                         : "shadow stays shadow, and light is whole");
    if (family.name.starts_with("rbsm/"))
        chain.invariants.push_back(fmt::format("where shapes and cases must agree, {} gives the same",
                                               is_filter ? "rsmss" : "smsr"));
    chain.judge = [&family](const glsl::Sources& sources, gpu::Device& device) -> Judge {
        auto on_device = std::make_shared<MaskChain>(family, sources, device);
        return [on_device](std::span<const Input> inputs) { return judge_apart(*on_device, inputs); };
    };
    const Case& visibility = *find_kernel(family, "visibility");
    chain.shrink = [&visibility](const Input& input, const StillFails& still_fails) {
        ShrinkOptions options;
        options.candidates = 4096;
        options.small_masks_at_once = std::size_t{1} << 14;
        return shrink(visibility, input, still_fails, options).input;
    };
    chain.format = [name = chain.described.name, &visibility](const Input& input) {
        const std::string call = format_call(visibility, input.words, &input.mask);
        return name + call.substr(call.find('('));
    };
    return chain;
}

} // namespace gnomon::fuzz
