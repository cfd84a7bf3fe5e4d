#include "runtime/error.h"
#include "runtime/gpu/objects.h"

namespace gnomon::gpu {

Owned<VkShaderModule> shader_module(const std::shared_ptr<Context>& context, const glsl::Spirv& words) {
    VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    info.codeSize = words.size() * sizeof words[0];
    info.pCode = words.data();
    VkShaderModule handle = VK_NULL_HANDLE;
    check(vkCreateShaderModule(context->device, &info, nullptr, &handle), "loading SPIR-V");
    return {context, handle, vkDestroyShaderModule};
}

Bindings make_bindings(const std::shared_ptr<Context>& context, std::vector<std::uint32_t> numbers,
                       std::uint32_t constant_bytes, VkShaderStageFlags stages) {
    Bindings bindings;
    bindings.numbers = std::move(numbers);
    bindings.constant_bytes = constant_bytes;
    if (constant_bytes > context->properties.limits.maxPushConstantsSize)
        throw Error("{} push constant bytes are more than {} offers ({})", constant_bytes, context->info.name,
                    context->properties.limits.maxPushConstantsSize);

    std::vector<VkDescriptorSetLayoutBinding> slots;
    for (const std::uint32_t number : bindings.numbers)
        slots.push_back({number, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, stages, nullptr});
    VkDescriptorSetLayoutCreateInfo set_info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    set_info.bindingCount = static_cast<std::uint32_t>(slots.size());
    set_info.pBindings = slots.data();
    VkDescriptorSetLayout set_layout = VK_NULL_HANDLE;
    check(vkCreateDescriptorSetLayout(context->device, &set_info, nullptr, &set_layout),
          "describing bindings");
    bindings.set_layout = {context, set_layout, vkDestroyDescriptorSetLayout};

    const VkPushConstantRange range{stages, 0, constant_bytes};
    VkPipelineLayoutCreateInfo layout_info{VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    layout_info.setLayoutCount = 1;
    layout_info.pSetLayouts = &set_layout;
    layout_info.pushConstantRangeCount = constant_bytes > 0 ? 1 : 0;
    layout_info.pPushConstantRanges = &range;
    VkPipelineLayout layout = VK_NULL_HANDLE;
    check(vkCreatePipelineLayout(context->device, &layout_info, nullptr, &layout), "describing a pipeline");
    bindings.pipeline_layout = {context, layout, vkDestroyPipelineLayout};

    if (slots.empty()) return bindings;
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                                    static_cast<std::uint32_t>(slots.size())};
    VkDescriptorPoolCreateInfo pool_info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool_info.maxSets = 1;
    pool_info.poolSizeCount = 1;
    pool_info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    check(vkCreateDescriptorPool(context->device, &pool_info, nullptr, &pool), "creating a descriptor pool");
    bindings.pool = {context, pool, vkDestroyDescriptorPool};
    VkDescriptorSetAllocateInfo allocate{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool;
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &set_layout;
    check(vkAllocateDescriptorSets(context->device, &allocate, &bindings.set), "allocating descriptors");
    return bindings;
}

void record_bindings(Context& context, VkCommandBuffer commands, VkPipelineBindPoint point,
                     const Bindings& bindings, std::span<const VkBuffer> given,
                     std::span<const std::byte> constants, VkShaderStageFlags stages,
                     const std::string& name) {
    std::vector<VkBuffer> buffers(given.begin(), given.end());
    if (context.always != VK_NULL_HANDLE && bindings.numbers.size() == given.size() + 1 &&
        bindings.numbers.back() == context.always_at) {
        if (point == VK_PIPELINE_BIND_POINT_GRAPHICS && !context.stores_while_drawing)
            throw Error("{}: {} cannot write to buffers while it draws", name, context.info.name);
        buffers.push_back(context.always);
    }
    if (buffers.size() != bindings.numbers.size())
        throw Error("{} binds {} buffers, {} were given", name, bindings.numbers.size(), buffers.size());
    if (constants.size() != bindings.constant_bytes)
        throw Error("{} takes {} bytes of push constants, {} were given", name, bindings.constant_bytes,
                    constants.size());
    if (!buffers.empty()) {
        std::vector<VkDescriptorBufferInfo> infos;
        for (const VkBuffer buffer : buffers) infos.push_back({buffer, 0, VK_WHOLE_SIZE});
        std::vector<VkWriteDescriptorSet> writes(buffers.size(), {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET});
        for (std::size_t i = 0; i < buffers.size(); ++i) {
            writes[i].dstSet = bindings.set;
            writes[i].dstBinding = bindings.numbers[i];
            writes[i].descriptorCount = 1;
            writes[i].descriptorType = VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
            writes[i].pBufferInfo = &infos[i];
        }
        vkUpdateDescriptorSets(context.device, static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                               nullptr);
        vkCmdBindDescriptorSets(commands, point, bindings.pipeline_layout, 0, 1, &bindings.set, 0, nullptr);
    }
    if (!constants.empty())
        vkCmdPushConstants(commands, bindings.pipeline_layout, stages, 0,
                           static_cast<std::uint32_t>(constants.size()), constants.data());
}

} // namespace gnomon::gpu
