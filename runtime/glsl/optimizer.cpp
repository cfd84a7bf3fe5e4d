#include "runtime/glsl/optimizer.h"

#include "runtime/error.h"

#include <spirv-tools/optimizer.hpp>

#include <algorithm>

namespace gnomon::glsl {

namespace {

Spirv run(spvtools::Optimizer& optimizer, const Spirv& words) {
    Spirv optimized;
    if (!optimizer.Run(words.data(), words.size(), &optimized))
        throw Error("SPIRV-Tools cannot optimise a shader that it validated");
    return optimized;
}

} // namespace

Spirv optimized(const Spirv& words) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPass(spvtools::CreateStripDebugInfoPass());
    optimizer.RegisterPerformancePasses();
    optimizer.RegisterPass(spvtools::CreateCompactIdsPass());
    return run(optimizer, words);
}

std::size_t optimized_instructions(const Spirv& words) {
    spvtools::Optimizer optimizer(SPV_ENV_VULKAN_1_3);
    optimizer.RegisterPerformancePasses();
    const Spirv optimized = run(optimizer, words);
    constexpr std::size_t header = 5;
    constexpr std::uint32_t op_line = 8, op_no_line = 317, op_function = 54, op_function_end = 56;
    std::size_t count = 0;
    bool in_function = false;
    for (std::size_t i = header; i < optimized.size(); i += std::max(optimized[i] >> 16, 1u)) {
        const std::uint32_t op = optimized[i] & 0xffffu;
        if (op == op_function) in_function = true;
        if (in_function && op != op_line && op != op_no_line) ++count;
        if (op == op_function_end) in_function = false;
    }
    return count;
}

std::string optimizer_version() {
    const std::string text = spvSoftwareVersionString(); // "v2023.1 unknown hash, 2023-01-27"
    return "SPIRV-Tools " + text.substr(0, text.find(' '));
}

} // namespace gnomon::glsl
