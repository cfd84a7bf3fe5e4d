#include "casegen/readings.h"

#include "casegen/reference/rsmss.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace gnomon {
namespace {

Readings bits_of(unsigned rsmss) { return {.rsmss = rsmss}; }

unsigned all_bits(const Reading& reading) {
    unsigned bits = 0;
    for (const Readings& value : reading.bits) bits |= value.rsmss;
    return bits;
}

} // namespace

const std::vector<Reading>& readings() {
    using namespace reference;
    static const std::vector<Reading> all{
        {"A3",
         "slot-end",
         {"dark", "printed"},
         {{}, bits_of(printed_end)},
         "the end of a slot that goes on to another end (cases 5, 7): dark, or the printed minimum of three "
         "ramps"},
        {"A4",
         "two-openings",
         {"lighter", "first"},
         {{}, bits_of(first_opening)},
         "a slot that opens on both sides of a texel (cases 4, 6): the lighter ramp, or the one listed "
         "first"},
        {"A5",
         "breach-tie",
         {"own-side", "first", "opposite"},
         {{}, bits_of(first_breach), bits_of(opposite_breach)},
         "different breaches equally near (cases 9, 11, 13, 15): that which adds to the texel's own light or "
         "shadow "
         "most, the one listed first, or the opposite"},
        {"A6",
         "bar",
         {"dark", "ramp"},
         {{}, bits_of(ramped_bar)},
         "a shadow bar between two ends, without breach (cases 12 to 15): dark, or lighter towards its "
         "sides"},
        {"A7",
         "long-runs",
         {"fade", "whole"},
         {{}, bits_of(long_runs)},
         "runs longer than the 16 texels of a walk: taken as 16 from their end, or as long as the walks can "
         "tell"},
        {"A8",
         "far-breach",
         {"width", "position"},
         {{}, bits_of(breach_by_position)},
         "a breach beyond the next texel of a bar's end (cases 12, 14): a ramp over the whole width, or by "
         "position"},
        {"A9",
         "isolated",
         {"edge", "flipped"},
         {{}, {.flip_isolated = true}},
         "a texel that differs from all four neighbours: an edge to them, or flipped in the map first"},
    };
    return all;
}

Readings parse_readings(const std::vector<std::string>& settings) {
    Readings chosen;
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        const std::string name = setting.substr(0, equals);
        const auto reading = std::ranges::find(readings(), name, &Reading::name);
        std::vector<const char*> names;
        for (const Reading& r : readings()) names.push_back(r.name);
        if (equals == std::string::npos || reading == readings().end())
            throw Error("--reading {}: NAME=VALUE with one of the names {}", setting, fmt::join(names, ", "));
        const std::string value = setting.substr(equals + 1);
        const auto found =
            std::ranges::find(reading->values, value, [](const char* known) { return std::string(known); });
        if (found == reading->values.end())
            throw Error("--reading {}: {} is one of {}", setting, name, fmt::join(reading->values, ", "));
        const Readings& bits = reading->bits[static_cast<std::size_t>(found - reading->values.begin())];
        if (all_bits(*reading) != 0)
            chosen.rsmss = (chosen.rsmss & ~all_bits(*reading)) | bits.rsmss;
        else
            chosen.flip_isolated = bits.flip_isolated;
    }
    return chosen;
}

Readings readings_for(const std::string& technique, const std::vector<std::string>& settings) {
    const Readings chosen = parse_readings(settings);
    if (chosen != Readings{} && (technique == "none" || technique == "raytraced"))
        throw Error("--reading {}: --technique {} asks no shadow map", to_string(chosen), technique);
    if (chosen.rsmss != 0 && technique != "rsmss")
        throw Error("--reading {}: only --technique rsmss is read in more than one way, {} is not",
                    to_string({.rsmss = chosen.rsmss}), technique);
    return chosen;
}

std::map<std::string, std::string> reading_sources(const Readings& chosen) {
    return {{"rsmss/options", fmt::format("const uint RSMSS_OPTIONS = {}u;\n", chosen.rsmss)},
            {"pipeline/options", fmt::format("#define FLIP_ISOLATED {}\n", chosen.flip_isolated ? 1 : 0)}};
}

std::string to_string(const Readings& chosen) {
    std::vector<std::string> parts;
    for (const Reading& reading : readings())
        for (std::size_t i = 1; i < reading.values.size(); ++i)
            if ((reading.bits[i].rsmss & chosen.rsmss) != 0 ||
                (reading.bits[i].flip_isolated && chosen.flip_isolated))
                parts.push_back(fmt::format("{}={}", reading.name, reading.values[i]));
    return fmt::format("{}", fmt::join(parts, " "));
}

} // namespace gnomon
