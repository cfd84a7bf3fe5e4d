#include "cli/explain.h"

#include "casegen/technique.h"
#include "runtime/error.h"
#include "runtime/glsl/optimizer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <functional>

namespace gnomon::cli {
namespace {

using Clock = std::chrono::steady_clock;

double median(std::vector<double> values) {
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Medians of both in turns.
Pair in_turns(int rounds, const std::function<double()>& all, const std::function<double()>& reduced) {
    std::vector<double> of_all, of_reduced;
    for (int i = 0; i < rounds; ++i) {
        of_all.push_back(all());
        of_reduced.push_back(reduced());
    }
    return {median(of_all), median(of_reduced)};
}

glsl::Spirv compile_cold(const glsl::Sources& sources, const Technique& technique) {
    const glsl::Sources with = visibility_sources(sources, technique);
    return glsl::compile_anew(with, stage_text(with, "visibility.comp"), stage_name(with, "visibility.comp"),
                              glsl::Stage::compute);
}

double compiler_milliseconds(const glsl::Sources& sources, const Technique& technique) {
    const auto start = Clock::now();
    compile_cold(sources, technique);
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// With a question that no texel answers with yes and no driver has seen, so that its cache has nothing.
Technique unseen(const glsl::Sources& sources, Technique technique) {
    static unsigned seen = static_cast<unsigned>(Clock::now().time_since_epoch().count());
    std::string text = visibility_sources(sources, technique).generated.at("technique");
    const std::size_t body = text.find("    return");
    if (body == std::string::npos) throw Error("<technique> has no return to put a question before");
    text.insert(body, fmt::format("    if (texel.x == -{}) return 0.5;\n", 20000 + ++seen % 2000000000u));
    technique.generated["technique"] = text;
    return technique;
}

std::size_t differing_pixels(const Rendering& a, const Rendering& b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.visibility.size(); ++i)
        if (std::bit_cast<std::uint32_t>(a.visibility[i]) != std::bit_cast<std::uint32_t>(b.visibility[i]) ||
            !(a.image.pixels[i] == b.image.pixels[i]))
            ++count;
    return count;
}

std::vector<unsigned> numbers(const std::vector<const Case*>& cases) {
    std::vector<unsigned> result;
    for (const Case* c : cases) result.push_back(c->number);
    return result;
}

/// Names of parameters that no held case takes.
std::vector<std::string> facts_left_out(const Family& family, const Assembly& assembly) {
    std::vector<std::string> names;
    for (const CaseParameter& p : case_parameters(family, assembly))
        if (!p.needed) names.push_back(p.name);
    return names;
}

template <typename T>
std::string list(const std::vector<T>& values) {
    return values.empty() ? "none" : fmt::format("{}", fmt::join(values, ", "));
}

} // namespace

Explanation explain(Renderer& renderer, const glsl::Sources& sources, const Family& family,
                    const Counts& counts, const Assembly& assembly, int frames) {
    // All cases are put together in the same way, so that only what is left out differs.
    Assembly whole = assembly;
    for (const Case* c : left_out_cases(family, assembly)) whole.cases.push_back(c->number);
    const Technique all = technique_of(family, whole), reduced = technique_of(family, assembly);
    Explanation found{.counts = counts, .assembly = assembly, .left_out = 0, .differing = 0};
    const Rendering with_all = renderer.render(technique_of(family), 1),
                    with_reduced = renderer.render(reduced, 1);
    found.left_out = with_reduced.left_out;
    found.differing = differing_pixels(with_all, with_reduced);

    glsl::warm_up();
    found.instructions = {static_cast<double>(glsl::optimized_instructions(compile_cold(sources, all))),
                          static_cast<double>(glsl::optimized_instructions(compile_cold(sources, reduced)))};
    found.compiler = in_turns(
        9, [&] { return compiler_milliseconds(sources, all); },
        [&] { return compiler_milliseconds(sources, reduced); });
    const std::vector<double> visibility = renderer.time_visibility({all, reduced}, frames);
    found.visibility = {visibility[0], visibility[1]};
    found.driver = in_turns(
        3, [&] { return renderer.time_first_visibility(unseen(sources, all)); },
        [&] { return renderer.time_first_visibility(unseen(sources, reduced)); });
    return found;
}

std::string census_table(const std::vector<CaseShare>& shares, bool several) {
    std::string text = fmt::format("{:>6}  {:<22}  {:>10}  {:>8}", "number", "case", "count", "share");
    text += several ? fmt::format("  {:>8}  {:>9}\n", "mean", "deviation") : "\n";
    for (const CaseShare& s : shares) {
        text +=
            fmt::format("{:>6}  {:<22}  {:>10}  {:>7.3f}%", s.c->number, s.c->name, s.count, 100 * s.share);
        text += several ? fmt::format("  {:>7.3f}%  {:>8.3f}%\n", 100 * s.mean, 100 * s.deviation) : "\n";
    }
    return text;
}

std::string explanation_text(const Family& family, const Explanation& e) {
    const std::vector<Counts> one{e.counts};
    std::string text = census_table(case_shares(family, one), false);
    text += fmt::format("held ({})        cases {}\n", to_string(e.assembly.variant),
                        list(numbers(held_cases(family, e.assembly))));
    text += fmt::format("left out             cases {}; facts {}\n",
                        list(numbers(left_out_cases(family, e.assembly))),
                        list(facts_left_out(family, e.assembly)));
    text += fmt::format("{:<34}{:>12}{:>12}{:>8}\n", "the visibility kernel", "all cases", "held", "ratio");
    const auto row = [&](const char* what, const Pair& pair, const char* unit, int digits) {
        text += fmt::format("  {:<32}{:>9.{}f} {:<2}{:>9.{}f} {:<2}{:>8.3f}\n", what, pair.all, digits, unit,
                            pair.reduced, digits, unit, pair.ratio());
    };
    row("instructions, optimised SPIR-V", e.instructions, "", 0);
    row("GLSL to SPIR-V, no cache", e.compiler, "ms", 2);
    row("driver's compiler, no cache", e.driver, "ms", 2);
    row("one frame's visibility", e.visibility, "ms", 3);
    text += e.differing == 0
                ? fmt::format("the images are the same, bit for bit{}\n",
                              e.left_out > 0 ? fmt::format(": {} pixels had to be found again", e.left_out)
                                             : std::string())
                : fmt::format("the images DIFFER in {} pixels\n", e.differing);
    return text;
}

nlohmann::ordered_json explanation_json(const Family& family, const Explanation& e) {
    const auto pair = [](const Pair& p) {
        return nlohmann::ordered_json{{"all", p.all}, {"reduced", p.reduced}, {"ratio", p.ratio()}};
    };
    return {{"variant", to_string(e.assembly.variant)},
            {"held", numbers(held_cases(family, e.assembly))},
            {"left_out", numbers(left_out_cases(family, e.assembly))},
            {"facts_left_out", facts_left_out(family, e.assembly)},
            {"pixels_left_out", e.left_out},
            {"pixels_differing", e.differing},
            {"instructions", pair(e.instructions)},
            {"compiler_milliseconds", pair(e.compiler)},
            {"driver_milliseconds", pair(e.driver)},
            {"visibility_milliseconds", pair(e.visibility)}};
}

} // namespace gnomon::cli
