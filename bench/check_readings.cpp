// What each reading of RSMSS's document costs: error against ray-traced truth and time of its visibility,
// over several lights, all readings and techniques in one run. Usage: check_readings [LIGHTS] [SIZE OF THE
// SHADOW MAP]
#include "casegen/census.h"
#include "casegen/demo_scene.h"
#include "casegen/readings.h"
#include "casegen/standalone.h"
#include "casegen/technique.h"
#include "runtime/error.h"
#include "runtime/pipeline/judge.h"
#include "runtime/pipeline/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <map>

namespace gnomon {
namespace {

constexpr int width = 640, height = 480, rounds = 7;

struct Subject {
    std::string name;
    Technique technique;
    std::size_t wrong_lit = 0, wrong_shadowed = 0;
    double difference = 0;        ///< sum over pixels of |visibility - truth|
    std::vector<double> ratios{}; ///< of its time to that of the first subject, per light
};

std::vector<Subject> subjects() {
    std::vector<Subject> all{{"rsmss", technique_of(technique_family("rsmss"))}};
    for (const Reading& reading : readings())
        for (std::size_t i = 1; i < reading.values.size(); ++i) {
            Technique technique = technique_of(technique_family("rsmss"));
            technique.generated = reading_sources(reading.bits[i]);
            all.push_back(
                {fmt::format("{} {}={}", reading.decision, reading.name, reading.values[i]), technique});
        }
    for (const char* name : {"rbsm-filter", "smsr", "rbsm-silhouette", "nsm"})
        all.push_back({name, technique_of(technique_family(name))});
    return all;
}

void run(unsigned lights, int shadow_map) {
    const Scene scene = demo_scene();
    gpu::Device device;
    std::vector<Subject> all = subjects();
    std::size_t facing = 0;
    for (unsigned n = 0; n < lights; ++n) {
        ViewSettings settings;
        settings.width = width, settings.height = height, settings.shadow_map = shadow_map;
        const Camera camera = default_camera(scene.bounds(), static_cast<float>(width) / height);
        const Light light{.direction = spread_direction(n)};
        Renderer renderer(device, kernel_sources(GNOMON_SOURCE_DIR "/kernels"), scene, camera, light,
                          settings);
        const Rendering truth = renderer.render({Technique::Kind::raytraced, "raytraced"}, 1);
        std::vector<Technique> techniques;
        for (Subject& subject : all) {
            const Rendering rendering = renderer.render(subject.technique, 1);
            const PixelCounts counts =
                count_pixels(renderer.surfaces(), rendering.visibility, truth.visibility);
            subject.wrong_lit += counts.wrong_lit;
            subject.wrong_shadowed += counts.wrong_shadowed;
            for (std::size_t i = 0; i < truth.visibility.size(); ++i)
                subject.difference +=
                    static_cast<double>(std::abs(rendering.visibility[i] - truth.visibility[i]));
            if (&subject == &all.front()) facing += counts.facing;
            techniques.push_back(subject.technique);
        }
        const std::vector<double> times = renderer.time_visibility(techniques, rounds);
        for (std::size_t i = 0; i < all.size(); ++i) all[i].ratios.push_back(times[i] / times.front());
    }
    fmt::print("demo scene, {} lights, {} x {} pixels, shadow map {}, {}\n", lights, width, height,
               shadow_map, device.info().name);
    fmt::print("{:<26} {:>11} {:>14} {:>9} {:>16} {:>12}\n", "", "wrongly lit", "wrongly shadow", "wrong",
               "mean difference", "time (rsmss)");
    const auto pixels = static_cast<double>(facing);
    for (Subject& subject : all) {
        std::ranges::sort(subject.ratios);
        fmt::print("{:<26} {:>11} {:>14} {:>8.3f}% {:>16.5f} {:>12.2f}\n", subject.name, subject.wrong_lit,
                   subject.wrong_shadowed,
                   100 * static_cast<double>(subject.wrong_lit + subject.wrong_shadowed) / pixels,
                   subject.difference / pixels, subject.ratios[subject.ratios.size() / 2]);
    }
}

int number(const char* text, int lowest, int highest) {
    int value = 0;
    const char* end = text + std::strlen(text);
    if (const auto [stop, error] = std::from_chars(text, end, value);
        error != std::errc{} || stop != end || value < lowest || value > highest)
        throw Error("{}: a whole number from {} to {}", text, lowest, highest);
    return value;
}

} // namespace
} // namespace gnomon

int main(int count, char** arguments) {
    try {
        if (count > 3) throw gnomon::Error("check_readings [LIGHTS] [SHADOW MAP]");
        gnomon::run(static_cast<unsigned>(count > 1 ? gnomon::number(arguments[1], 1, 1000) : 4),
                    count > 2 ? gnomon::number(arguments[2], 16, 4096) : 512);
    } catch (const std::exception& error) {
        fmt::print(stderr, "check_readings: {}\n", error.what());
        return 2;
    }
}
