#include "casegen/standalone.h"

#include "casegen/added_buffer.h"
#include "casegen/catalogue.h"
#include "runtime/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

namespace gnomon {
namespace {

constexpr std::uint32_t guard_words = 256;

// The hook that kernels of revectorisation see a map through, over masks packed one bit per texel, rows
// unpadded.
constexpr const char* mask_hook = R"(
layout(std430, binding = 2) readonly buffer Masks { uint mask_bits[]; };
uint mask_first;
ivec2 mask_size;
uint mask_outside;
bool lit(ivec2 texel) {
    // No branch: kernels ask for many texels, and a driver compiles all of it for each.
    ivec2 nearest = clamp(texel, ivec2(0), mask_size - 1);
    uint bit = uint(nearest.y * mask_size.x + nearest.x);
    bool stored = ((mask_bits[mask_first + (bit >> 5)] >> (bit & 31u)) & 1u) != 0u;
    uint beyond = nearest == texel ? 0u : mask_outside;
    bool lit_beyond = beyond == 1u; // a name: glslang branches around an expression
    return beyond == 0u ? stored : lit_beyond;
}
)";

std::string word_expression(std::size_t word) {
    return fmt::format("words_{}.{}", word / 4, "xyzw"[word % 4]);
}

std::string from_word(Scalar scalar, const std::string& word) {
    switch (scalar) {
    case Scalar::float32:
        return fmt::format("uintBitsToFloat({})", word);
    case Scalar::int32:
        return fmt::format("int({})", word);
    case Scalar::boolean:
        return fmt::format("{} != 0u", word);
    case Scalar::uint32:
        break;
    }
    return word;
}

/// glslang makes an OpUndef where a function ends without a return; a driver may then return anything, the
/// right answer included.
bool has_undefined_value(const glsl::Spirv& words) {
    constexpr std::size_t header = 5;
    constexpr std::uint32_t op_undef = 1;
    for (std::size_t i = header; i < words.size(); i += std::max(words[i] >> 16, 1u))
        if ((words[i] & 0xffffu) == op_undef) return true;
    return false;
}

std::size_t record_words(const Case& c) {
    const std::size_t words = word_count(c) + (c.reference.takes_mask ? 4 : 0);
    return std::max<std::size_t>(4, (words + 3) / 4 * 4);
}

/// Reads `record`, for word_expression(). Four words at once: lavapipe makes a loop over its lanes of every
/// read.
std::string record_reading(const Case& c) {
    std::string text;
    for (std::size_t i = 0; i < record_words(c) / 4; ++i)
        text += fmt::format("    uvec4 words_{} = inputs[record + {}u];\n", i, i);
    return text;
}

constexpr std::size_t least_rehearsed = 4096;

} // namespace

std::string to_word(Scalar scalar, const std::string& value) {
    switch (scalar) {
    case Scalar::float32:
        return fmt::format("floatBitsToUint({})", value);
    case Scalar::int32:
    case Scalar::boolean:
        return fmt::format("uint({})", value);
    case Scalar::uint32:
        break;
    }
    return value;
}

glsl::Sources kernel_sources(const std::filesystem::path& kernels, const Readings& readings,
                             Trigonometry trigonometry) {
    glsl::Sources sources{kernels, generated_sources()};
    sources.generated.merge(reading_sources(readings));
    sources.generated["integral/trigonometry"] = trigonometry_source(trigonometry);
    return sources;
}

namespace {

/// What stands before a main() that calls the kernel. The prototype first: GLSL converts arguments silently,
/// so that another signature would otherwise do.
std::string preamble(const Case& c, const char* constants, std::string_view before, bool with_kernel = true) {
    const std::string kernel = fmt::format("{};\n#include \"{}.glsl\"", signature(c), c.name);
    return fmt::format(R"(layout(local_size_x = 64) in;
{}{}
layout(std430, binding = 0) readonly buffer Inputs {{ uvec4 inputs[]; }};
layout(std430, binding = 1) writeonly buffer Results {{ uint results[]; }};
layout(push_constant) uniform Constants {{ {} }};
{}
)",
                       before, with_kernel ? kernel : "", constants,
                       with_kernel && c.reference.takes_mask ? mask_hook : "");
}

/// Sets up the mask of `record`, if there is one, and calls the kernel: `result`.
std::string call(const Case& c) {
    std::string arguments, text;
    std::size_t word = 0;
    for (std::size_t i = 0; i < c.parameters.size(); ++i) {
        const Type type = c.reference.parameters[i];
        std::vector<std::string> components;
        for (int k = 0; k < type.components; ++k)
            components.push_back(from_word(type.scalar, word_expression(word++)));
        arguments += fmt::format("{}{}({})", i > 0 ? ", " : "", glsl_name(type), fmt::join(components, ", "));
    }
    if (c.reference.takes_mask)
        text = fmt::format("    mask_first = {};\n    mask_size = ivec2({}, {});\n    mask_outside = {};\n",
                           word_expression(word), word_expression(word + 1), word_expression(word + 2),
                           word_expression(word + 3));
    return text + fmt::format("    {} result = {}({});\n", glsl_name(c.reference.result), function_name(c),
                              arguments);
}

/// The words of `result`.
std::vector<std::string> result_words(const Case& c) {
    const Type type = c.reference.result;
    std::vector<std::string> words;
    for (int k = 0; k < type.components; ++k)
        words.push_back(
            to_word(type.scalar, type.components == 1 ? "result" : fmt::format("result.{}", "xyzw"[k])));
    return words;
}

} // namespace

std::string standalone_source(const Case& c, const Addition& addition) {
    std::string writes;
    const std::vector<std::string> words = result_words(c);
    for (std::size_t k = 0; k < words.size(); ++k)
        writes += fmt::format("    results[{}u + {}u * index + {}u] = {};\n", guard_words, words.size(), k,
                              words[k]);
    const std::string begin = preamble(c, "uint count;", addition.declarations);
    return begin + fmt::format(R"(void main() {{
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    uint record = index * {}u;
{}{}{}{}}}
)",
                               record_words(c) / 4, record_reading(c), call(c), writes, addition.at_end);
}

std::string standalone_source(const Case& c) { return standalone_source(c, Addition()); }

std::string repeated_source(const Case& c, Repeated what) {
    std::vector<std::string> words;
    if (what == Repeated::calls)
        words = result_words(c);
    else
        for (std::size_t word = 0; word < word_count(c); ++word) words.push_back(word_expression(word));
    return preamble(c, "uint count, last, evaluations;", {}, what == Repeated::calls) +
           fmt::format(R"(void main() {{
    uint index = gl_GlobalInvocationID.x;
    if (index >= count) return;
    uint sum = 0u;
    for (uint i = 0u; i < evaluations; ++i) {{
    uint record = ((index + i * {}u) & last) * {}u;
{}{}    sum += {};
    }}
    results[index] = sum;
}}
)",
                       repeated_stride, record_words(c) / 4, record_reading(c),
                       what == Repeated::calls ? call(c) : "", fmt::join(words, " + "));
}

namespace {

std::string text_with(const Case& c, const glsl::Sources& sources, const Addition& addition) {
    if (const std::string file = c.name + ".glsl";
        !sources.overlaid.contains(file) && !std::filesystem::is_regular_file(sources.root / file))
        throw CompileError("{}/{}: no such file; the catalogue has a case of this name",
                           sources.root.string(), file);
    return glsl::expand(sources, standalone_source(c, addition), standalone_name);
}

glsl::Spirv compile_text(const Case& c, const std::string& text, const std::string& folder, bool kept,
                         bool with_addition) {
    const std::string file = fmt::format("{}/{}.glsl", folder, c.name);
    glsl::Spirv words;
    try {
        words = glsl::compile_expanded(text, standalone_name, glsl::Stage::compute, kept);
    } catch (const CompileError& error) {
        const std::string message = error.what();
        if (const std::size_t at = message.find("glslang made invalid SPIR-V"); at != std::string::npos)
            throw CompileError("{}:1: {}", file, message.substr(at));
        const bool linking = message.find("No function definition (body) found") != std::string::npos;
        if (linking && message.find("lit(") != std::string::npos)
            throw CompileError("{}:1: calls lit(), but its table entry takes no mask", file);
        if (!linking && !message.starts_with(standalone_name)) throw;
        throw CompileError("{}:1: does not define what its table declares: {}", file, signature(c));
    }
    if (has_undefined_value(words))
        throw CompileError("{}:1: a function in it, or included by it, returns no value on some path", file);
    const glsl::Reflection reflection = glsl::reflect(words, file);
    std::vector<std::uint32_t> expected{0, 1};
    if (c.reference.takes_mask) expected.push_back(2);
    if (with_addition) expected.push_back(added_binding);
    for (const std::uint32_t binding : reflection.storage_buffers)
        if (std::ranges::find(expected, binding) == expected.end())
            throw CompileError(
                "{}:1: uses a buffer of its own (binding {}); a kernel is a function of its parameters", file,
                binding);
    return words;
}

} // namespace

std::string standalone_text(const Case& c, const glsl::Sources& sources) {
    return text_with(c, sources, Addition());
}

glsl::Spirv compile_standalone(const Case& c, const glsl::Sources& sources, bool kept) {
    return compile_standalone_text(c, standalone_text(c, sources), sources.root.filename().string(), kept);
}

glsl::Spirv compile_standalone(const Case& c, const glsl::Sources& sources, const Addition& addition) {
    return compile_text(c, text_with(c, sources, addition), sources.root.filename().string(), true, true);
}

glsl::Spirv compile_standalone_text(const Case& c, const std::string& text, const std::string& folder,
                                    bool kept) {
    return compile_text(c, text, folder, kept, false);
}

Records::Records(const Case& c)
    : takes_mask_(c.reference.takes_mask), word_count_(word_count(c)), stride_(record_words(c)) {}

void Records::add(std::span<const std::uint32_t> words, const Mask* mask) {
    add_with([&](std::span<std::uint32_t> to) {
        std::ranges::copy(words, to.begin());
        return mask;
    });
}

void Records::place_mask(std::size_t count, const Mask* mask) {
    mask_of_.resize(mask_of_.size() + count, mask);
    if (!takes_mask_) return;
    const auto first = static_cast<std::uint32_t>(mask_words_.size());
    const auto [found, is_new] = packed_.try_emplace(mask, first);
    if (is_new) {
        mask_words_.resize(mask_words_.size() + (mask->texels.size() + 31) / 32);
        for (std::size_t i = 0; i < mask->texels.size(); ++i)
            if (mask->texels[i] != 0) mask_words_[first + i / 32] |= 1u << (i % 32);
    }
    const std::array words{found->second, static_cast<std::uint32_t>(mask->width),
                           static_cast<std::uint32_t>(mask->height),
                           static_cast<std::uint32_t>(mask->outside)};
    for (std::size_t at = words_.size() - count * stride_ + word_count_; at < words_.size(); at += stride_)
        std::ranges::copy(words, words_.begin() + static_cast<std::ptrdiff_t>(at));
}

Records draw_records(const Case& c, const Sampler& sampler, std::size_t begin, std::size_t end) {
    Records records(c);
    records.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
        records.add_with([&](std::span<std::uint32_t> words) { return sampler.draw(i, words); });
    return records;
}

std::string Outputs::complaint() const {
    if (const auto gaps = std::ranges::count(unwritten, 1); gaps > 0)
        return fmt::format("{} of {} results were never written", gaps, unwritten.size());
    if (stray_write) return "memory before or behind the results was overwritten";
    if (unstable) return "two runs over the same inputs gave different results";
    return {};
}

namespace {

Outputs run_with(gpu::Device& device, gpu::Kernel& kernel, const Case& c, const Records& records,
                 gpu::Buffer* added) {
    const auto components = static_cast<std::size_t>(c.reference.result.components);
    const std::size_t result_words = records.size() * components;
    const gpu::Buffer inputs = device.upload(records.words());
    const gpu::Buffer masks = device.upload(records.masks());
    gpu::Buffer results = device.allocate((result_words + 2 * guard_words) * sizeof(std::uint32_t));

    Outputs outputs;
    const auto run = [&](std::size_t samples, std::uint32_t poison) {
        std::vector<std::uint32_t> memory(result_words + 2 * guard_words, poison);
        device.write(results, std::as_bytes(std::span(memory)));
        const auto count = static_cast<std::uint32_t>(samples);
        const gpu::Dispatch dispatch{.threads = {count, 1, 1}, .constants = gpu::bytes_of(count)};
        if (added) device.write(*added, std::vector<std::byte>(added->size()));
        const bool masked = c.reference.takes_mask;
        outputs.nanoseconds = masked && added
                                  ? device.run(kernel, {&inputs, &results, &masks, added}, dispatch)
                              : masked ? device.run(kernel, {&inputs, &results, &masks}, dispatch)
                              : added  ? device.run(kernel, {&inputs, &results, added}, dispatch)
                                       : device.run(kernel, {&inputs, &results}, dispatch);
        device.read(results, std::as_writable_bytes(std::span(memory)));
        const auto poisoned = [&](std::uint32_t word) { return word == poison; };
        const auto end_of_results =
            memory.begin() + static_cast<std::ptrdiff_t>(guard_words + samples * components);
        if (!std::all_of(memory.begin(), memory.begin() + guard_words, poisoned) ||
            !std::all_of(end_of_results, memory.end(), poisoned))
            outputs.stray_write = true;
        return memory;
    };
    const std::size_t rehearsed = std::min(records.size(), std::max(least_rehearsed, records.size() / 8));
    const std::vector<std::uint32_t> rehearsal = run(rehearsed, 0xffc0ffeeu);
    constexpr std::uint32_t poison =
        0x7fdeadbeu; // NaN, and beyond every integer result's range: never a result
    const std::vector<std::uint32_t> memory = run(records.size(), poison);

    outputs.words.assign(memory.begin() + guard_words, memory.end() - guard_words);
    outputs.unwritten.assign(records.size(), 0);
    for (std::size_t i = 0; i < result_words; ++i) {
        if (outputs.words[i] == poison)
            outputs.unwritten[i / components] = 1;
        else if (i < rehearsed * components && rehearsal[guard_words + i] != outputs.words[i])
            outputs.unstable = true;
    }
    return outputs;
}

} // namespace

Outputs run_standalone(gpu::Device& device, gpu::Kernel& kernel, const Case& c, const Records& records) {
    return run_with(device, kernel, c, records, nullptr);
}

Outputs run_standalone(gpu::Device& device, gpu::Kernel& kernel, const Case& c, const Records& records,
                       gpu::Buffer& added) {
    return run_with(device, kernel, c, records, &added);
}

Outputs evaluate(gpu::Device& device, const glsl::Sources& sources, const Case& c, const Records& records) {
    gpu::Kernel kernel = device.kernel(compile_standalone(c, sources), c.name);
    return run_standalone(device, kernel, c, records);
}

} // namespace gnomon
