#include "cli/reproduce/measure.h"

#include "cli/rendering.h"
#include "runtime/pipeline/judge.h"

#include <array>

namespace gnomon::cli {
namespace {

void count_truth(const PixelCounts& pixels, const CountKey& of, Counts& counts) {
    const auto add = [&](const char* quantity, std::size_t value) {
        counts[{of.view, of.width, of.height, 0, "raytraced", quantity}] = value;
    };
    add("facing", pixels.facing);
    add("facing_away", pixels.all - pixels.facing); // nothing is seen there: the thesis has it among these
    add("lit", pixels.truly_lit);
    add("shadowed", pixels.truly_shadowed);
}

/// "Light" and "Shadow" are what the technique says, right or wrong.   [hybrid.md, convention 7]
void count_normal(const PixelCounts& pixels, CountKey of, Counts& counts) {
    of.technique = "nsm";
    const auto add = [&](const char* quantity, std::size_t value) {
        of.quantity = quantity;
        counts[of] = value;
    };
    const std::size_t right_lit = pixels.truly_lit - pixels.wrong_shadowed;
    const std::size_t right_shadowed = pixels.truly_shadowed - pixels.wrong_lit;
    add("right_lit", right_lit);
    add("wrong_lit", pixels.wrong_lit);
    add("right_shadowed", right_shadowed);
    add("wrong_shadowed", pixels.wrong_shadowed);
    add("right_total", right_lit + right_shadowed);
    add("wrong_total", pixels.wrong_lit + pixels.wrong_shadowed);
}

/// Certain pixels by what they are said to be, uncertain ones by what they are.   [hybrid.md, convention 11]
void count_hybrid(const Surfaces& surfaces, std::span<const PixelState> states, std::span<const float> truth,
                  CountKey of, Counts& counts) {
    std::array<std::array<std::size_t, 2>, 3> pixels{}; // by state, then by truth
    for (std::size_t i = 0; i < states.size(); ++i)
        if (surfaces.facing[i] != 0) ++pixels.at(static_cast<std::size_t>(states[i])).at(truth[i] >= 0.5f);
    const auto add = [&](const char* quantity, std::size_t value) {
        of.quantity = quantity;
        counts[of] = value;
    };
    const auto& shadowed = pixels[static_cast<std::size_t>(PixelState::shadowed)];
    const auto& lit = pixels[static_cast<std::size_t>(PixelState::lit)];
    const auto& uncertain = pixels[static_cast<std::size_t>(PixelState::uncertain)];
    add("lit_certain", lit[0] + lit[1]);
    add("lit_certain_wrong", lit[0]);
    add("lit_uncertain", uncertain[1]);
    add("shadowed_certain", shadowed[0] + shadowed[1]);
    add("shadowed_certain_wrong", shadowed[1]);
    add("shadowed_uncertain", uncertain[0]);
    add("certain", lit[0] + lit[1] + shadowed[0] + shadowed[1]);
    add("certain_right", lit[1] + shadowed[0]);
    add("certain_wrong", lit[0] + shadowed[1]);
    add("uncertain", uncertain[0] + uncertain[1]);
}

} // namespace

std::span<const char* const> counted_hybrids() {
    static constexpr std::array names{"beister", "crsm", "crsma", "bilinear", "crsma-one-ring"};
    return names;
}

void count_view(gpu::Device& device, const glsl::Sources& sources, const Scene& scene, const ThesisView& view,
                int width, int height, std::span<const int> maps, Counts& counts) {
    std::vector<float> truth;
    for (const int map : maps) {
        Renderer renderer(device, sources, scene, view.camera, thesis_light(),
                          as_published(width, height, map));
        CountKey of{view.name, width, height, map, {}, {}};
        const Surfaces& surfaces = renderer.surfaces();
        if (truth.empty()) { // the same for all maps
            truth = renderer.visibility(technique_by_name("raytraced"));
            count_truth(count_pixels(surfaces, truth, truth), of, counts);
        }
        const std::vector<float> normal = renderer.visibility(technique_by_name("nsm"));
        count_normal(count_pixels(surfaces, normal, truth), of, counts);
        for (const char* name : counted_hybrids()) {
            of.technique = name;
            count_hybrid(surfaces, renderer.states(technique_by_name(name)), truth, of, counts);
        }
    }
}

} // namespace gnomon::cli
