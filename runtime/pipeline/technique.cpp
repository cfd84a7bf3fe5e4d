#include "runtime/pipeline/technique.h"

#include "runtime/files.h"

#include <fmt/format.h>

#include <algorithm>

namespace gnomon {
namespace {

glsl::Sources with(glsl::Sources sources, const Technique& technique, const char* wrapper) {
    const std::string& family = technique.family.empty() ? technique.name : technique.family;
    std::string prefix = family;
    std::ranges::replace(prefix, '/', '_');
    sources.generated["technique"] =
        fmt::format(fmt::runtime(wrapper), fmt::arg("family", family), fmt::arg("prefix", prefix));
    for (const auto& [name, text] : technique.generated) sources.generated[name] = text;
    return sources;
}

std::filesystem::path below_kernels(const std::string& file) {
    return file.find('/') == std::string::npos ? std::filesystem::path("pipeline") / file
                                               : std::filesystem::path(file);
}

} // namespace

glsl::Sources visibility_sources(const glsl::Sources& sources, const Technique& technique) {
    return with(sources, technique,
                "#include \"{family}/visibility.glsl\"\n"
                "float technique_visibility(ivec2 texel, vec2 p) {{\n"
                "    return {prefix}_visibility(texel, p);\n}}\n");
}

glsl::Sources number_sources(const glsl::Sources& sources, const Technique& technique) {
    return with(sources, technique,
                "#include \"{family}/number.glsl\"\n"
                "uint technique_number(ivec2 texel) {{\n    return {prefix}_number(texel);\n}}\n");
}

glsl::Sources answer_sources(const glsl::Sources& sources, const Technique& technique, Question question) {
    const bool number = question == Question::number;
    glsl::Sources result =
        number ? number_sources(sources, technique) : visibility_sources(sources, technique);
    result.generated["technique"] +=
        fmt::format("uint technique_answer(ivec2 texel, vec2 p) {{\n    return {};\n}}\n",
                    number ? "technique_number(texel)" : "floatBitsToUint(technique_visibility(texel, p))");
    return result;
}

std::string stage_text(const glsl::Sources& sources, const std::string& file) {
    return glsl::text_of(sources, below_kernels(file).generic_string());
}

std::string stage_name(const glsl::Sources& sources, const std::string& file) {
    return (sources.root.filename() / below_kernels(file)).generic_string();
}

} // namespace gnomon
