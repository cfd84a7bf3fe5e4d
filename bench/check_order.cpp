// Does the order matter in which cases are asked? Every assembly of a family, measured in one run, in turns,
// so that a machine that slows down slows all of them alike: on the device over edges of the mask corpus and
// over the demo scene's pixels, and as scalar C++ over the same edges.
//
//     build/bench/check_order [ROUNDS]
#include "bench/scalar/scalar.h"
#include "casegen/census.h"
#include "casegen/demo_scene.h"
#include "casegen/sampling.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "runtime/error.h"
#include "runtime/glsl/optimizer.h"
#include "runtime/pipeline/renderer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <string_view>

namespace gnomon {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kernels = GNOMON_SOURCE_DIR "/kernels";

glsl::Sources sources_with(const Family& family, const Assembly& assembly) {
    glsl::Sources sources = kernel_sources(kernels);
    sources.generated[family.name + "/cases"] = assembled(family, assembly);
    return sources;
}

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

/// Of this thread on a core: what other processes do does not count.
double thread_milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double median(std::vector<double> values) {
    if (values.empty()) return 0;
    std::ranges::sort(values);
    return values[values.size() / 2];
}

/// Edges that are of a case: what the functions are for.
struct Edges {
    std::string name;
    std::vector<Mask> masks;
    struct Place {
        std::size_t mask;
        Facts facts;
    };
    std::vector<Place> places;
    Counts counts = Counts(Renderer::census_size);

    void add(const Family& family, std::size_t mask, glm::ivec2 texel, glm::dvec2 p, reference::Edge edge) {
        const unsigned number = scalar::number_of(family, edge);
        if (number == 0) return;
        ++counts[number];
        places.push_back({mask, {texel, p, edge}});
    }
};

Edges corpus_edges(const Family& family) {
    EdgePool pool = make_edge_pool(hash("check_order"));
    Edges edges{.name = "mask corpus"};
    Random random(1);
    for (const EdgePool::Entry& entry : pool.entries) {
        const double x = random.unit(), y = random.unit();
        edges.add(family, entry.mask, glm::ivec2(entry.texel), glm::dvec2(x, y), entry.edge());
    }
    edges.masks = std::move(pool.masks);
    return edges;
}

struct DemoView {
    Scene scene = demo_scene();
    Camera camera = default_camera(scene.bounds(), 4.0f / 3);
    ViewSettings settings{.shadow_map = 1024};
    std::unique_ptr<Renderer> on(gpu::Device& device) const {
        return std::make_unique<Renderer>(device, kernel_sources(kernels), scene, camera, Light{}, settings);
    }
};

Edges demo_edges(const Family& family, Renderer& renderer, const ViewSettings& settings) {
    std::vector<std::uint32_t> asked;
    const auto side = static_cast<float>(settings.shadow_map);
    const std::vector<shared::Receiver>& receivers = renderer.receivers();
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::vec4 map = receivers[i].map;
        if (map.w == 1 && map.x >= 0 && map.y >= 0 && map.x < side && map.y < side)
            asked.push_back(static_cast<std::uint32_t>(i));
    }
    Edges edges{.name = "demo scene"};
    constexpr glm::ivec2 centre(Capture::radius);
    for (const Capture& capture : renderer.capture(asked)) {
        Mask mask(2 * Capture::radius + 1, 2 * Capture::radius + 1);
        mask.texels = capture.lit;
        const std::size_t before = edges.places.size();
        edges.add(family, edges.masks.size(), centre, glm::dvec2(capture.p), reference::edge(mask, centre));
        if (edges.places.size() > before) edges.masks.push_back(std::move(mask));
    }
    return edges;
}

struct Row {
    std::string name;
    Variant variant;
    std::vector<unsigned> cases; ///< for both censuses alike, unless by frequency
    bool by_frequency = false, rarest_first = false;

    Assembly assembly(const Family& family, const Counts& counts, bool count_tests = false) const {
        Assembly result{variant, {}, count_tests};
        if (!by_frequency) return result;
        result.cases = cases_by_frequency(family, counts);
        for (const Case* c : left_out_cases(family, result)) result.cases.push_back(c->number);
        if (rarest_first) std::ranges::reverse(result.cases);
        return result;
    }
};

const std::vector<Row>& rows() {
    static const std::vector<Row> all{
        {"switch", Variant::switch_by_number, {}},
        {"document order", Variant::document_order, {}},
        {"frequent first", Variant::frequency_order, {}, true},
        {"rarest first", Variant::frequency_order, {}, true, true},
        {"tree", Variant::branch_tree, {}, true},
        {"branchless", Variant::branchless, {}},
        {"table", Variant::table, {}},
    };
    return all;
}

/// What is known of one row over one set of edges.
struct Measured {
    double tests = 0;                ///< conditions asked per edge
    std::vector<double> nanoseconds; ///< on the device, per edge, of the whole visibility kernel
    std::vector<double> frames;      ///< milliseconds of the scene's visibility kernel
    std::vector<double> compiler;    ///< milliseconds from GLSL to SPIR-V
    double instructions = 0;
};

/// The edges over and over, so that a dispatch is long enough to be measured.
Records records_of(const Case& visibility, const Edges& edges) {
    constexpr std::size_t count = 1 << 17;
    Records records(visibility);
    records.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Edges::Place& place = edges.places[i % edges.places.size()];
        const std::array words{std::bit_cast<std::uint32_t>(place.facts.texel.x),
                               std::bit_cast<std::uint32_t>(place.facts.texel.y),
                               std::bit_cast<std::uint32_t>(static_cast<float>(place.facts.p.x)),
                               std::bit_cast<std::uint32_t>(static_cast<float>(place.facts.p.y))};
        records.add(words, &edges.masks[place.mask]);
    }
    return records;
}

/// The visibility kernel over edges, with conditions_tested as its answer.
double mean_tests(gpu::Device& device, const Family& family, const Case& visibility, const Records& records,
                  const Assembly& assembly) {
    const glsl::Sources sources = sources_with(family, assembly);
    const std::string source = standalone_source(visibility);
    const std::size_t behind_call =
        source.find('\n', source.rfind(fmt::format("{}(", function_name(visibility))));
    const std::string counting = fmt::format("{}\n    result = float(conditions_tested);{}",
                                             source.substr(0, behind_call), source.substr(behind_call));
    gpu::Kernel kernel = device.kernel(
        glsl::compile(sources, counting, standalone_name, glsl::Stage::compute), "conditions tested");
    double sum = 0;
    for (const std::uint32_t word : run_standalone(device, kernel, visibility, records).words)
        sum += static_cast<double>(std::bit_cast<float>(word));
    return sum / static_cast<double>(records.size());
}

void measure_device(gpu::Device& device, const Family& family, const Edges& edges, Renderer* renderer,
                    int rounds, std::vector<Measured>& measured) {
    const Case& visibility = *find_kernel(family, "visibility");
    const Records records = records_of(visibility, edges);
    std::vector<gpu::Kernel> compiled;
    std::vector<Technique> techniques;
    measured.resize(rows().size());
    for (std::size_t i = 0; i < rows().size(); ++i) {
        const Row& row = rows()[i];
        measured[i].tests =
            mean_tests(device, family, visibility, records, row.assembly(family, edges.counts, true));
        const Assembly assembly = row.assembly(family, edges.counts);
        const glsl::Sources sources = sources_with(family, assembly);
        compiled.push_back(device.kernel(compile_standalone(visibility, sources), row.name));
        measured[i].instructions =
            static_cast<double>(glsl::optimized_instructions(compile_standalone(visibility, sources)));
        techniques.push_back(technique_of(family, assembly));
    }
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < rows().size(); ++i) {
            const double nanoseconds = run_standalone(device, compiled[i], visibility, records).nanoseconds;
            measured[i].nanoseconds.push_back(nanoseconds / static_cast<double>(records.size()));
            const glsl::Sources sources = visibility_sources(kernel_sources(kernels), techniques[i]);
            const auto start = Clock::now();
            glsl::compile_anew(sources, stage_text(sources, "visibility.comp"), "visibility.comp",
                               glsl::Stage::compute);
            measured[i].compiler.push_back(milliseconds_since(start));
        }
    if (!renderer) return;
    const std::vector<double> frames = renderer->time_visibility(techniques, rounds);
    for (std::size_t i = 0; i < rows().size(); ++i) measured[i].frames = {frames[i]};
}

struct Scalar {
    std::string name;
    std::vector<double> nanoseconds; ///< per edge, of the case function alone
};

std::vector<Scalar> measure_scalar(const Family& family, const Edges& edges, int rounds) {
    std::vector<scalar::Input> inputs;
    for (const Edges::Place& place : edges.places) inputs.push_back(scalar::make_input(family, place.facts));
    // In an order that no branch predictor knows: neighbours in a mask are often of one case.
    Random random(2);
    for (std::size_t i = inputs.size(); i > 1; --i)
        std::swap(inputs[i - 1], inputs[random.below(static_cast<std::uint32_t>(i))]);
    std::vector<Scalar> measured;
    std::vector<const scalar::Kernel*> chosen;
    std::vector<std::shared_ptr<void>> prepared;
    for (const scalar::Kernel& kernel : scalar::kernels()) {
        if (kernel.family != family.name) continue;
        chosen.push_back(&kernel);
        prepared.push_back(kernel.prepare(inputs));
        measured.push_back({kernel.name, {}});
    }
    volatile float sink = 0;
    for (int round = 0; round < 9 * rounds; ++round) // short ones: a disturbed turn is then one of many
        for (std::size_t i = 0; i < chosen.size(); ++i) {
            const std::size_t repeats = 1 + 200000 / inputs.size();
            const double start = thread_milliseconds();
            for (std::size_t k = 0; k < repeats; ++k) sink = sink + chosen[i]->sum(prepared[i].get());
            measured[i].nanoseconds.push_back(1e6 * (thread_milliseconds() - start) /
                                              static_cast<double>(repeats * inputs.size()));
        }
    return measured;
}

void print(const Edges& edges, const std::vector<Measured>& measured, const std::vector<Scalar>& of_scalar) {
    fmt::print("\n  {}: {} edges\n", edges.name, edges.places.size());
    fmt::print("  {:<28}{:>12}{:>14}{:>14}{:>14}{:>12}\n", "on the device", "tests/edge", "instructions",
               "GLSL, ms", "ns/edge", "frame, ms");
    for (std::size_t i = 0; i < rows().size(); ++i) {
        const Measured& m = measured[i];
        fmt::print("  {:<28}{:>12.2f}{:>14.0f}{:>14.2f}{:>14.2f}{:>12}\n", rows()[i].name, m.tests,
                   m.instructions, median(m.compiler), median(m.nanoseconds),
                   m.frames.empty() ? "" : fmt::format("{:.3f}", median(m.frames)));
    }
    fmt::print("  {:<42}{:>12}\n", "as scalar C++ (orders are the corpus's)", "ns/edge");
    for (const Scalar& s : of_scalar) fmt::print("  {:<42}{:>12.2f}\n", s.name, median(s.nanoseconds));
}

void measure(int rounds) {
    gpu::Device device;
    const DemoView view;
    const std::unique_ptr<Renderer> renderer = view.on(device);
    glsl::warm_up();
    for (const std::string& name : numbered_techniques()) {
        const Family& family = technique_family(name);
        fmt::print("\n{}: {} cases; {} rounds in turns, medians; {}\n", family.name,
                   numbered_cases(family).size(), rounds, device.info().name);
        const Edges corpus = corpus_edges(family), demo = demo_edges(family, *renderer, view.settings);
        for (const Edges* edges : {&corpus, &demo}) {
            fmt::print("  frequent first: {}\n", fmt::join(cases_by_frequency(family, edges->counts), " "));
            std::vector<Measured> measured;
            measure_device(device, family, *edges, edges == &demo ? renderer.get() : nullptr, rounds,
                           measured);
            print(*edges, measured, measure_scalar(family, *edges, rounds));
        }
    }
}

} // namespace
} // namespace gnomon

int main(int argc, char** argv) {
    int rounds = 15;
    if (argc > 1) {
        const std::string_view text = argv[1];
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), rounds);
        if (argc > 2 || error != std::errc{} || end != text.data() + text.size() || rounds < 1) {
            fmt::print(stderr, "check_order takes one number: how many rounds (default 15)\n");
            return 2;
        }
    }
    gnomon::gpu::prepare_process(true);
    try {
        gnomon::measure(rounds);
    } catch (const std::exception& error) {
        fmt::print(stderr, "check_order: {}\n", error.what());
        return 2;
    }
    std::fflush(nullptr);
    std::_Exit(0); // spares the driver's slow farewell, as the program does
}
