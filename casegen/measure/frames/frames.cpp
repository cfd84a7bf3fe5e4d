#include "casegen/measure/frames/frames.h"

#include "casegen/measure/pareto.h"
#include "casegen/measure/quantiles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace gnomon::measure {
namespace {

bool promises_truth(const Technique& technique) {
    if (technique.kind == Technique::Kind::raytraced || technique.kind == Technique::Kind::automatic)
        return true;
    const HybridTechnique* known = find_hybrid(technique.name);
    return technique.kind == Technique::Kind::hybrid && known != nullptr && known->sound;
}

double rmse_of(const Surfaces& surfaces, const std::vector<float>& found, const std::vector<float>& truth) {
    double sum = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (surfaces.facing[i] == 0) continue;
        ++count;
        const double difference = static_cast<double>(found[i]) - static_cast<double>(truth[i]);
        sum += std::isfinite(difference) ? difference * difference : 1;
    }
    return count == 0 ? 0 : std::sqrt(sum / static_cast<double>(count));
}

double noise_of(const std::vector<FrameRow>& rows) {
    std::vector<double> distances;
    for (const FrameRow& row : rows)
        for (const double one : row.times.rounds)
            distances.push_back(std::abs(one / row.times.milliseconds - 1));
    return std::max(least_noise, quantiles(std::move(distances)).median);
}

void time_all(SceneResult& result, Renderer& renderer, const std::vector<Technique>& techniques, int rounds) {
    std::vector<TechniqueTimes> times = renderer.time_techniques(techniques, rounds);
    for (std::size_t i = 0; i < techniques.size(); ++i) {
        result.rows[i].times = std::move(times[i]);
        result.rows[i].times.visibility = {}; // judged already
    }
    const auto nsm = std::ranges::find(result.rows, "nsm", &FrameRow::technique);
    const FrameRow& yardstick = nsm == result.rows.end() ? result.rows.front() : *nsm;
    result.yardstick = yardstick.technique;
    for (FrameRow& row : result.rows) row.over_yardstick = ratio_of(row.times.rounds, yardstick.times.rounds);
    result.noise = noise_of(result.rows);
    std::vector<Point> points;
    for (const FrameRow& row : result.rows)
        points.push_back({row.times.milliseconds, row.counts.wrong_share()});
    const std::vector<std::optional<std::size_t>> by = dominated_by(points, result.noise);
    for (std::size_t i = 0; i < by.size(); ++i) result.rows[i].dominated_by = by[i];
}

} // namespace

SceneResult measure_scene(gpu::Device& device, const glsl::Sources& sources, const Scene& scene,
                          const FrameView& view, const std::vector<Technique>& techniques, int rounds) {
    Renderer renderer(device, sources, scene, view.camera, view.light, view.settings);
    const int width = view.settings.width, height = view.settings.height;
    Rendering truth = renderer.render({Technique::Kind::raytraced, "raytraced"}, 1);
    SceneResult result;
    result.view = view;
    result.triangles = scene.triangles.size();
    for (const Technique& technique : techniques) {
        Rendering rendering = renderer.render(technique, 1);
        FrameRow row;
        row.technique = technique.name;
        row.exact = promises_truth(technique);
        row.counts = count_pixels(renderer.surfaces(), rendering.visibility, truth.visibility);
        row.differing = count_differing(rendering.visibility, truth.visibility);
        row.rmse = rmse_of(renderer.surfaces(), rendering.visibility, truth.visibility);
        row.rays = rendering.hybrid ? rendering.hybrid->rays : 0;
        row.errors =
            false_colours(renderer.surfaces(), rendering.visibility, truth.visibility, width, height);
        row.image = std::move(rendering.image);
        result.rows.push_back(std::move(row));
    }
    result.truth = std::move(truth.image);
    if (rounds > 0 && !techniques.empty()) time_all(result, renderer, techniques, rounds);
    return result;
}

std::vector<std::string> broken_promises(const SceneResult& result) {
    std::vector<std::string> lines;
    for (const FrameRow& row : result.rows)
        if (row.exact && row.differing > 0)
            lines.push_back(fmt::format("WRONG: {} promises the ray tracer's image; on {}, {} pixels differ",
                                        row.technique, result.view.scene, row.differing));
    return lines;
}

} // namespace gnomon::measure
