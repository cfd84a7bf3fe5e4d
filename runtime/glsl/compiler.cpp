#include "runtime/glsl/compiler.h"

#include "runtime/error.h"
#include "runtime/files.h"

#include <fmt/format.h>
#include <glslang/Public/ResourceLimits.h>
#include <glslang/Public/ShaderLang.h>
#include <glslang/SPIRV/GlslangToSpv.h>
#include <spirv-tools/libspirv.hpp>

#include <cstring>
#include <mutex>

namespace gnomon::glsl {
namespace {

constexpr int glsl_version = 460;

EShLanguage language(Stage stage) {
    switch (stage) {
    case Stage::vertex:
        return EShLangVertex;
    case Stage::fragment:
        return EShLangFragment;
    case Stage::geometry:
        return EShLangGeometry;
    case Stage::compute:
        break;
    }
    return EShLangCompute;
}

/// glslang's log as lines "file:line: message"; its trailing summary ("2 compilation errors …") says nothing
/// more.
std::string readable(const char* log, std::string_view name) {
    std::string lines;
    std::string_view rest = log;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        std::string_view line = rest.substr(0, end);
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
        for (const std::string_view prefix : {"ERROR: ", "WARNING: "})
            if (line.starts_with(prefix)) line.remove_prefix(prefix.size());
        if (line.empty() || line.find("compilation errors.") != std::string_view::npos ||
            line.find("compilation terminated") != std::string_view::npos)
            continue;
        if (!lines.empty()) lines += '\n';
        lines += line;
    }
    return lines.empty() ? fmt::format("{}:1: glslang failed without saying why", name) : lines;
}

void initialize_once() {
    static std::once_flag once;
    std::call_once(once, [] {
        if (!glslang::InitializeProcess()) throw Error("glslang could not be initialised");
    });
}

Spirv translate(const std::string& text, std::string_view name, Stage stage) {
    initialize_once();
    const EShLanguage kind = language(stage);
    const auto messages = static_cast<EShMessages>(EShMsgSpvRules | EShMsgVulkanRules);
    glslang::TShader shader(kind);
    const char* source = text.c_str();
    shader.setStrings(&source, 1);
    shader.setEnvInput(glslang::EShSourceGlsl, kind, glslang::EShClientVulkan, glsl_version);
    shader.setEnvClient(glslang::EShClientVulkan, glslang::EShTargetVulkan_1_3);
    shader.setEnvTarget(glslang::EShTargetSpv, glslang::EShTargetSpv_1_6);
    if (!shader.parse(GetDefaultResources(), glsl_version, false, messages))
        throw CompileError("{}", readable(shader.getInfoLog(), name));
    glslang::TProgram program;
    program.addShader(&shader);
    if (!program.link(messages)) throw CompileError("{}", readable(program.getInfoLog(), name));
    Spirv words;
    glslang::SpvOptions options;
    options.disableOptimizer =
        true; // spirv-opt costs more time than it saves, and hides what the author wrote
    glslang::GlslangToSpv(*program.getIntermediate(kind), words, &options);
    return words;
}

/// What is wrong with these words; empty: nothing. Ids by the shader's own names, or by number alone.
std::string fault(const Spirv& words, bool named) {
    spvtools::SpirvTools tools(SPV_ENV_VULKAN_1_3);
    std::string log;
    tools.SetMessageConsumer(
        [&](spv_message_level_t, const char*, const spv_position_t&, const char* message) {
            log += log.empty() ? "" : "; ";
            log += message;
        });
    spvtools::ValidatorOptions options;
    options.SetFriendlyNames(named);
    if (tools.Validate(words.data(), words.size(), options)) return "";
    return log.empty() ? "SPIRV-Tools does not say why" : log;
}

void validate(const Spirv& words, std::string_view name) {
    // Naming every id takes four times as long as the validation: only for the message.
    if (!fault(words, false).empty())
        throw CompileError("{}:1: glslang made invalid SPIR-V: {}", name, fault(words, true));
}

// The cache holds, per file, the whole key text and the words: two texts with one hash cannot be mistaken for
// each other, and a file cut short or damaged is not believed.

std::string cache_key(std::string_view expanded, Stage stage) {
    return fmt::format("{}\nvulkan1.3 spirv1.6 stage {}\n{}", version(), static_cast<int>(stage), expanded);
}

std::filesystem::path cache_path(std::string_view key) {
    return cache_directory() / "spirv" / fmt::format("{:016x}.spv", hash(key));
}

void store(const std::string& key, const Spirv& words) {
    std::string file(sizeof(std::uint64_t), '\0');
    const std::uint64_t length = key.size();
    std::memcpy(file.data(), &length, sizeof length);
    file += key;
    file.append(reinterpret_cast<const char*>(words.data()), words.size() * sizeof(std::uint32_t));
    const std::uint64_t checksum = hash(file);
    file.append(reinterpret_cast<const char*>(&checksum), sizeof checksum);
    const std::filesystem::path path = cache_path(key);
    try {
        std::filesystem::create_directories(path.parent_path());
        write_file(path, file);
    } catch (const std::exception&) {
        // A cache that cannot be written costs time, not correctness.
    }
}

} // namespace

Spirv find_cached(std::string_view expanded, Stage stage) {
    const std::string key = cache_key(expanded, stage);
    std::string file;
    try {
        file = read_file(cache_path(key));
    } catch (const Error&) {
        return {};
    }
    constexpr std::size_t frame = 2 * sizeof(std::uint64_t);
    if (file.size() < frame + key.size() || (file.size() - frame - key.size()) % sizeof(std::uint32_t) != 0)
        return {};
    std::uint64_t length = 0, checksum = 0;
    const std::size_t body = file.size() - sizeof checksum;
    std::memcpy(&length, file.data(), sizeof length);
    std::memcpy(&checksum, file.data() + body, sizeof checksum);
    if (length != key.size() || std::string_view(file).substr(sizeof length, key.size()) != key) return {};
    if (hash(std::string_view(file).substr(0, body)) != checksum) return {};
    Spirv words((body - sizeof length - key.size()) / sizeof(std::uint32_t));
    std::memcpy(words.data(), file.data() + sizeof length + key.size(), words.size() * sizeof(std::uint32_t));
    return words;
}

Spirv compile(const Sources& sources, std::string_view text, std::string_view name, Stage stage) {
    return compile_expanded(expand(sources, text, name), name, stage);
}

Spirv compile_expanded(const std::string& expanded, std::string_view name, Stage stage, bool kept) {
    if (kept)
        if (Spirv cached = find_cached(expanded, stage); !cached.empty()) return cached;
    Spirv words = translate(expanded, name, stage);
    validate(words, name);
    if (kept) store(cache_key(expanded, stage), words);
    return words;
}

Spirv compile_anew(const Sources& sources, std::string_view text, std::string_view name, Stage stage) {
    return compile_expanded(expand(sources, text, name), name, stage, false);
}

void warm_up() {
    translate("#version 460\nlayout(local_size_x = 1) in;\nvoid main() {}\n", "warm-up", Stage::compute);
}

std::string version() {
    const glslang::Version v = glslang::GetVersion();
    return fmt::format("glslang {}.{}.{}{}", v.major, v.minor, v.patch, v.flavor ? v.flavor : "");
}

} // namespace gnomon::glsl
