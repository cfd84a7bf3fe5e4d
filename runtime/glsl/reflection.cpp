#include "runtime/glsl/reflection.h"

#include "runtime/error.h"

#include <spirv_cross/spirv_cross.hpp>

#include <algorithm>

namespace gnomon::glsl {

Reflection reflect(const Spirv& words, std::string_view name) try {
    const spirv_cross::Compiler compiler(words);
    for (const spv::Capability capability : compiler.get_declared_capabilities())
        // Geometry shaders are asked for by name, and the device refuses where it has none (Device::raster).
        if (capability != spv::CapabilityShader && capability != spv::CapabilityMatrix &&
            capability != spv::CapabilityGeometry)
            throw CompileError(
                "{}:1: needs SPIR-V capability {} (float64, int64, subgroups …), which not every device has",
                name, static_cast<int>(capability));
    const spirv_cross::ShaderResources resources = compiler.get_shader_resources();
    const auto refuse = [&](const auto& list, const char* kind) {
        if (!list.empty())
            throw CompileError(
                "{}:1: uses {} \"{}\"; kernels read and write storage buffers and push constants only", name,
                kind, list.front().name);
    };
    refuse(resources.uniform_buffers, "the uniform block");
    refuse(resources.sampled_images, "the sampler");
    refuse(resources.separate_images, "the texture");
    refuse(resources.separate_samplers, "the sampler");
    refuse(resources.storage_images, "the image");

    Reflection reflection;
    for (const spirv_cross::Resource& buffer : resources.storage_buffers) {
        if (compiler.get_decoration(buffer.id, spv::DecorationDescriptorSet) != 0)
            throw CompileError("{}:1: the buffer \"{}\" is in a set other than 0", name, buffer.name);
        reflection.storage_buffers.push_back(compiler.get_decoration(buffer.id, spv::DecorationBinding));
    }
    std::ranges::sort(reflection.storage_buffers);
    // Two views of one buffer are one binding.
    reflection.storage_buffers.erase(
        std::unique(reflection.storage_buffers.begin(), reflection.storage_buffers.end()),
        reflection.storage_buffers.end());
    for (const spirv_cross::Resource& block : resources.push_constant_buffers)
        reflection.push_constant_bytes = static_cast<std::uint32_t>(
            compiler.get_declared_struct_size(compiler.get_type(block.base_type_id)));
    if (compiler.get_execution_model() == spv::ExecutionModelGLCompute)
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            reflection.workgroup_size[axis] =
                compiler.get_execution_mode_argument(spv::ExecutionModeLocalSize, axis);
    return reflection;
} catch (const spirv_cross::CompilerError& error) {
    throw CompileError("{}:1: SPIR-V cannot be reflected: {}", name, error.what());
}

} // namespace gnomon::glsl
