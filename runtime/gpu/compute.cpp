#include "runtime/error.h"
#include "runtime/gpu/objects.h"

namespace gnomon::gpu {

Kernel::Kernel() = default;
Kernel::Kernel(Kernel&&) noexcept = default;
Kernel& Kernel::operator=(Kernel&&) noexcept = default;
Kernel::~Kernel() = default;
const glsl::Reflection& Kernel::reflection() const { return impl_->reflection; }

Kernel Device::kernel(const glsl::Spirv& words, std::string_view name) {
    Kernel kernel;
    kernel.impl_ = std::make_unique<Kernel::Impl>();
    Kernel::Impl& impl = *kernel.impl_;
    impl.name = name;
    impl.reflection = glsl::reflect(words, name);
    impl.bindings = make_bindings(context_, impl.reflection.storage_buffers,
                                  impl.reflection.push_constant_bytes, VK_SHADER_STAGE_COMPUTE_BIT);
    const Owned<VkShaderModule> module = shader_module(context_, words);
    VkComputePipelineCreateInfo info{VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    info.stage.module = module;
    info.stage.pName = "main";
    info.layout = impl.bindings.pipeline_layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateComputePipelines(context_->device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "creating a compute pipeline");
    impl.pipeline = {context_, pipeline, vkDestroyPipeline};
    return kernel;
}

void Device::bind_always(std::uint32_t binding, const Buffer* buffer) {
    context_->always_at = binding;
    context_->always = buffer ? buffer->impl_->handle : VkBuffer{VK_NULL_HANDLE};
}

double Device::run(Kernel& kernel, std::initializer_list<const Buffer*> buffers, const Dispatch& dispatch) {
    Kernel::Impl& impl = *kernel.impl_;
    std::vector<VkBuffer> handles;
    for (const Buffer* buffer : buffers) handles.push_back(buffer->impl_->handle);
    std::array<std::uint32_t, 3> groups{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::uint32_t size = impl.reflection.workgroup_size[axis];
        groups[axis] = dispatch.threads[axis] / size + (dispatch.threads[axis] % size != 0 ? 1 : 0);
        if (groups[axis] > context_->properties.limits.maxComputeWorkGroupCount[axis])
            throw Error("{} threads are more than {} starts in one dispatch of {}", dispatch.threads[axis],
                        context_->info.name, impl.name);
    }
    try {
        return submit(*context_, [&](VkCommandBuffer commands) {
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, impl.pipeline);
            record_bindings(*context_, commands, VK_PIPELINE_BIND_POINT_COMPUTE, impl.bindings, handles,
                            dispatch.constants, VK_SHADER_STAGE_COMPUTE_BIT, impl.name);
            vkCmdDispatch(commands, groups[0], groups[1], groups[2]);
            full_barrier(commands);
        });
    } catch (const KernelTimeout& timeout) {
        throw KernelTimeout("{}: {}", impl.name, timeout.what());
    }
}

} // namespace gnomon::gpu
