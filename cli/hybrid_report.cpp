#include "cli/hybrid_report.h"

#include <fmt/format.h>

namespace gnomon::cli {
namespace {

double share(std::size_t part, std::size_t whole) {
    return whole == 0 ? 0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string choice_text(const Choice& choice) {
    std::string text =
        fmt::format("auto takes {}, after a calibration of {:.0f} ms:\n", choice.name(), choice.milliseconds);
    for (const Candidate& candidate : choice.candidates)
        text += candidate.refused.empty()
                    ? fmt::format("  {:<12} {:8.2f} ms, of {} frames\n", candidate.name,
                                  typical_time(candidate), candidate.milliseconds.size())
                    : fmt::format("  {:<12} refused: {}\n", candidate.name, candidate.refused);
    return text;
}

nlohmann::ordered_json choice_json(const Choice& choice) {
    nlohmann::ordered_json candidates = nlohmann::ordered_json::array();
    for (const Candidate& candidate : choice.candidates) {
        nlohmann::ordered_json json{{"technique", candidate.name}};
        if (candidate.refused.empty())
            json.update({{"typical_milliseconds", typical_time(candidate)},
                         {"milliseconds", candidate.milliseconds}});
        else
            json["refused"] = candidate.refused;
        candidates.push_back(std::move(json));
    }
    return {{"chosen", choice.name()},
            {"calibration_milliseconds", choice.milliseconds},
            {"candidates", std::move(candidates)}};
}

} // namespace

std::string hybrid_text(const Rendering& rendering, bool prune) {
    const HybridFrame& frame = rendering.hybrid.value();
    std::string text = rendering.choice ? choice_text(*rendering.choice) : "";
    text += fmt::format("rays              {} for {} pixels that face the light: {:.3f} % uncertain\n",
                        frame.rays, frame.facing, 100 * share(frame.rays, frame.facing));
    text += fmt::format("maps              {} triangles emitted, {:.1f} bytes per texel\n",
                        frame.maps.triangles_emitted, frame.maps.bytes_per_texel);
    if (!prune) return text + "left out          nothing: --prune off\n";
    if (frame.left_out.empty()) text += "left out          nothing: the frame needs every step\n";
    for (const LeftOut& left : frame.left_out)
        text += fmt::format("left out          {}: {}: {}\n", left.step, left.what, left.why);
    return text;
}

nlohmann::ordered_json hybrid_json(const Rendering& rendering, bool prune) {
    const HybridFrame& frame = rendering.hybrid.value();
    nlohmann::ordered_json left_out = nlohmann::ordered_json::array();
    for (const LeftOut& left : frame.left_out)
        left_out.push_back({{"step", left.step}, {"what", left.what}, {"why", left.why}});
    nlohmann::ordered_json json{{"prune", prune},
                                {"facing", frame.facing},
                                {"rays", frame.rays},
                                {"uncertain_share", share(frame.rays, frame.facing)},
                                {"triangles_emitted", frame.maps.triangles_emitted},
                                {"bytes_per_texel", frame.maps.bytes_per_texel},
                                {"left_out", std::move(left_out)}};
    if (rendering.choice) json["auto"] = choice_json(*rendering.choice);
    return json;
}

} // namespace gnomon::cli
