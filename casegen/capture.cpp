#include "casegen/capture.h"

#include "casegen/csv.h"
#include "casegen/standalone.h"
#include "runtime/error.h"
#include "runtime/files.h"
#include "runtime/glsl/tokens.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <set>

namespace gnomon {
namespace {

std::string component(const std::string& value, Type type, int k) {
    return type.components == 1 ? value : fmt::format("{}.{}", value, "xyzw"[k]);
}

/// Functions that a text defines.
std::set<std::string> functions_of(const std::string& text) {
    const std::vector<glsl::Token> tokens = glsl::tokens(text);
    std::set<std::string> names;
    for (const glsl::Function& function : glsl::functions(tokens)) names.emplace(function.name);
    return names;
}

/// Functions that the technique's answer is put together from.
std::set<std::string> functions_of(const glsl::Sources& sources, const Technique& technique,
                                   Question question) {
    const glsl::Sources with = answer_sources(sources, technique, question);
    return functions_of(glsl::expand(with, stage_text(with, "record.comp"), stage_name(with, "record.comp")));
}

/// No walk leaves the window, so it does not matter what lies beyond.
std::shared_ptr<const Mask> window_of(const Capture& capture) {
    constexpr int side = 2 * Capture::radius + 1;
    auto mask = std::make_shared<Mask>(side, side);
    mask->texels = capture.lit;
    return mask;
}

/// From the map's texels to the window's.
void move_texel(const Case& c, CapturedCall& call, const Capture& capture) {
    const std::size_t word = texel_word(c);
    for (int axis = 0; axis < 2; ++axis) {
        std::uint32_t& texel = call.inputs[word + static_cast<std::size_t>(axis)];
        const int offset = std::bit_cast<int>(texel) - capture.texel[axis];
        if (offset != 0)
            throw Error("{} looks at the map from a texel beside the pixel's own; what it sees there is not "
                        "captured",
                        c.name);
        texel = std::bit_cast<std::uint32_t>(Capture::radius);
    }
}

CapturedCall captured_call(const Case& c, const RecordedCall& recorded) {
    const auto inputs = static_cast<std::ptrdiff_t>(word_count(c));
    CapturedCall call;
    call.inputs.assign(recorded.words.begin(), recorded.words.begin() + inputs);
    call.result.assign(recorded.words.begin() + inputs, recorded.words.end());
    return call;
}

std::vector<Captured> captured_of(const std::vector<const Case*>& kernels) {
    std::vector<Captured> captured;
    for (const Case* c : kernels) captured.push_back({.kernel = c});
    return captured;
}

/// By file, what records these kernels' calls, each tagged by its place among them.
std::map<std::string, std::string> recording_texts(const glsl::Sources& sources,
                                                   const std::vector<const Case*>& kernels) {
    std::map<std::string, std::string> texts;
    for (std::size_t k = 0; k < kernels.size(); ++k) {
        const std::string file = kernels[k]->name + ".glsl";
        texts[file] = recording_text(*kernels[k], read_file(sources.root / file), static_cast<unsigned>(k));
    }
    return texts;
}

/// What the calls' pixels see of the map, if their kernel looks at it.
void add_windows(Renderer& renderer, Captured& captured) {
    if (!captured.kernel->reference.takes_mask || captured.calls.empty()) return;
    std::vector<std::uint32_t> pixels;
    for (const CapturedCall& call : captured.calls) pixels.push_back(call.pixel.value());
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    const std::vector<Capture> seen = renderer.capture(pixels);
    std::size_t at = 0;
    std::shared_ptr<const Mask> window;
    for (CapturedCall& call : captured.calls) {
        if (pixels[at] != *call.pixel) {
            ++at;
            window.reset();
        }
        if (!window) window = window_of(seen[at]);
        call.window = window;
        move_texel(*captured.kernel, call, seen[at]);
    }
}

} // namespace

std::string recording_text(const Case& c, std::string_view text, unsigned tag) {
    const std::string name = function_name(c);
    std::vector<std::string> parameters, names;
    std::string records;
    int count = 0;
    const auto record = [&](const std::string& value, Type type) {
        for (int k = 0; k < type.components; ++k, ++count)
            records += fmt::format("        record({});\n", to_word(type.scalar, component(value, type, k)));
    };
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        names.push_back(fmt::format("a{}", i));
        parameters.push_back(fmt::format("{} a{}", glsl_name(c.reference.parameters[i]), i));
        record(names.back(), c.reference.parameters[i]);
    }
    record("answer", c.reference.result);
    const std::string result = glsl_name(c.reference.result);
    return fmt::format("#include \"pipeline/record.glslh\"\n#define {0} unrecorded_{0}\n{1}\n#undef {0}\n"
                       "{2} {0}({3}) {{\n    {2} answer = unrecorded_{0}({4});\n"
                       "    if (record_call({6}u, {7}u)) {{\n{5}    }}\n    return answer;\n}}\n",
                       name, text, result, fmt::join(parameters, ", "), fmt::join(names, ", "), records, tag,
                       count);
}

std::vector<ChainLink> chain_of(const glsl::Sources& sources, const Technique& technique) {
    const std::set<std::string> visibility = functions_of(sources, technique, Question::visibility);
    std::set<std::string> number;
    const Family& family = technique_family(technique.name);
    if (find_kernel(family, "number")) number = functions_of(sources, technique, Question::number);
    std::vector<ChainLink> links;
    for (const Family& known : catalogue())
        for (const Case& c : known.cases) {
            if (visibility.contains(function_name(c)))
                links.push_back({&c, Question::visibility});
            else if (number.contains(function_name(c)))
                links.push_back({&c, Question::number});
        }
    return links;
}

std::vector<std::uint32_t> asked_pixels(Renderer& renderer) {
    std::vector<std::uint32_t> pixels;
    const auto side = static_cast<float>(renderer.settings().shadow_map);
    const auto within = [&](float v) { return v >= 0 && v < side; };
    const std::vector<shared::Receiver>& receivers = renderer.receivers();
    for (std::size_t i = 0; i < receivers.size(); ++i) {
        const glm::vec4 map = receivers[i].map;
        if (map.w == 1 && within(map.x) && within(map.y)) pixels.push_back(static_cast<std::uint32_t>(i));
    }
    return pixels;
}

std::vector<std::uint32_t> case_numbers(Renderer& renderer, const Technique& technique,
                                        const std::vector<std::uint32_t>& pixels) {
    if (pixels.empty()) return {};
    return renderer.record(technique, Question::number, pixels, {}).answers;
}

std::vector<std::uint32_t> calling_pixels(Renderer& renderer, const glsl::Sources& sources,
                                          const Technique& technique, const ChainLink& link,
                                          const std::vector<std::uint32_t>& pixels) {
    if (pixels.empty()) return {};
    const Recorded recorded =
        renderer.record(technique, link.question, pixels, recording_texts(sources, {link.kernel}));
    std::set<std::uint32_t> calling;
    for (const RecordedCall& call : recorded.calls) calling.insert(pixels[call.x]);
    return {calling.begin(), calling.end()};
}

std::vector<Captured> capture_calls(Renderer& renderer, const glsl::Sources& sources,
                                    const Technique& technique, Question question,
                                    const std::vector<const Case*>& kernels,
                                    const std::vector<std::uint32_t>& pixels) {
    std::vector<Captured> captured = captured_of(kernels);
    if (pixels.empty()) return captured;
    const std::vector<float> frame = renderer.visibility(technique);
    const Recorded recorded = renderer.record(technique, question, pixels, recording_texts(sources, kernels));
    if (question == Question::visibility)
        for (std::size_t i = 0; i < pixels.size(); ++i)
            if (std::bit_cast<std::uint32_t>(frame[pixels[i]]) != recorded.answers[i])
                for (Captured& each : captured) each.unlike_frame.push_back(pixels[i]);
    for (const RecordedCall& call : recorded.calls) {
        Captured& to = captured[call.tag];
        to.calls.push_back(captured_call(*to.kernel, call));
        to.calls.back().pixel = pixels[call.x];
        to.calls.back().visibility = frame[pixels[call.x]];
    }
    for (Captured& each : captured) add_windows(renderer, each);
    return captured;
}

std::vector<const Case*> kernels_of(const std::vector<StageText>& stages) {
    std::set<std::string> names;
    for (const StageText& stage : stages) names.merge(functions_of(stage.text));
    std::vector<const Case*> kernels;
    for (const Family& known : catalogue())
        for (const Case& c : known.cases)
            if (names.contains(function_name(c))) kernels.push_back(&c);
    return kernels;
}

std::vector<Captured> capture_frame_calls(Renderer& renderer, const glsl::Sources& sources,
                                          const Technique& technique, const std::vector<const Case*>& kernels,
                                          const std::vector<std::uint32_t>& pixels, std::size_t most) {
    std::vector<Captured> captured = captured_of(kernels);
    const auto width = static_cast<std::uint32_t>(renderer.settings().width);
    const std::vector<float> frame = renderer.visibility(technique);
    Recorded recorded = renderer.record_frame(technique, pixels, recording_texts(sources, kernels));
    std::vector<std::uint32_t> unlike;
    for (std::size_t i = 0; i < frame.size(); ++i)
        if (std::bit_cast<std::uint32_t>(frame[i]) != recorded.answers[i])
            unlike.push_back(static_cast<std::uint32_t>(i));
    std::vector<std::string> stages;
    for (const StageText& stage : recorded.stages) stages.push_back(stage.file);
    for (const RecordedCall& each : recorded.calls) {
        Captured& to = captured[each.tag];
        CapturedCall call = captured_call(*to.kernel, each);
        call.stage = each.stage;
        call.invocation = {each.x, each.y};
        if (is_of_pixels(stages[each.stage])) {
            call.pixel = each.y * width + each.x;
            call.visibility = frame[*call.pixel];
        }
        to.calls.push_back(std::move(call));
    }
    for (Captured& each : captured) {
        each.unlike_frame = unlike;
        each.stages = stages;
        each.all = each.calls.size();
        each.calls = spread(std::move(each.calls), most);
        add_windows(renderer, each);
    }
    return captured;
}

std::vector<std::string> result_columns(const Case& c, const std::string& name) {
    const int components = c.reference.result.components;
    if (components == 1) return {name};
    std::vector<std::string> names;
    for (int k = 0; k < components; ++k) names.push_back(fmt::format("{}_{}", name, "xyzw"[k]));
    return names;
}

std::string captured_csv(const Captured& captured, int width, const std::string& comment) {
    const Case& c = *captured.kernel;
    std::string text;
    for (std::size_t begin = 0; begin < comment.size();) {
        const std::size_t end = std::min(comment.find('\n', begin), comment.size());
        text += "# " + comment.substr(begin, end - begin) + '\n';
        begin = end + 1;
    }
    std::vector<std::string> header = columns(c);
    header.insert(header.end(), {"pixel_x", "pixel_y"});
    for (std::string& name : result_columns(c, "captured")) header.push_back(std::move(name));
    header.emplace_back("visibility");
    if (!captured.stages.empty()) header.insert(header.end(), {"stage", "invocation_x", "invocation_y"});
    text += fmt::format("{}\n", fmt::join(header, ","));
    const auto side = static_cast<std::uint32_t>(width);
    const Mask* last = nullptr;
    std::string window; // of the last call: a pixel's calls see the same one
    for (const CapturedCall& call : captured.calls) {
        if (call.window && call.window.get() != last) {
            last = call.window.get();
            window = format_mask(*last, '/') + ',' + to_string(last->outside) + ',';
        }
        text += window;
        for (std::size_t i = 0; i < call.inputs.size(); ++i)
            text += format_word(c.reference.words[i], call.inputs[i]) + ',';
        text += call.pixel ? fmt::format("{},{}", *call.pixel % side, *call.pixel / side) : ",";
        for (const std::uint32_t word : call.result)
            text += ',' + format_word(c.reference.result.scalar, word);
        text += ',';
        if (call.pixel) text += format_word(Scalar::float32, std::bit_cast<std::uint32_t>(call.visibility));
        if (!captured.stages.empty())
            text +=
                fmt::format(",{},{},{}", captured.stages[call.stage], call.invocation.x, call.invocation.y);
        text += '\n';
    }
    return text;
}

std::vector<std::size_t> differing_rows(const Case& c, std::span<const std::uint32_t> wanted,
                                        std::span<const std::uint32_t> got) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    const bool is_float = c.reference.result.scalar == Scalar::float32;
    const auto is_nan = [&](std::uint32_t word) {
        return is_float && std::isnan(std::bit_cast<float>(word));
    };
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < wanted.size(); ++i)
        if (wanted[i] != got[i] && !(is_nan(wanted[i]) && is_nan(got[i])) &&
            (rows.empty() || rows.back() != i / components))
            rows.push_back(i / components);
    return rows;
}

} // namespace gnomon
