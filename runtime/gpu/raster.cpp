#include "runtime/error.h"
#include "runtime/gpu/objects.h"

#include <algorithm>

namespace gnomon::gpu {
namespace {

VkFormat vulkan_format(Format format) {
    return format == Format::depth32_float ? VK_FORMAT_D32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
}

VkCullModeFlags cull_mode(Cull cull) {
    switch (cull) {
    case Cull::front:
        return VK_CULL_MODE_FRONT_BIT;
    case Cull::back:
        return VK_CULL_MODE_BACK_BIT;
    case Cull::none:
        break;
    }
    return VK_CULL_MODE_NONE;
}

/// What `into` binds, and what a further stage does.
void add_interface(glsl::Reflection& into, const glsl::Spirv& stage, std::string_view name) {
    const glsl::Reflection extra = glsl::reflect(stage, name);
    auto& numbers = into.storage_buffers;
    numbers.insert(numbers.end(), extra.storage_buffers.begin(), extra.storage_buffers.end());
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    into.push_constant_bytes = std::max(into.push_constant_bytes, extra.push_constant_bytes);
}

VkImageAspectFlags aspect(Format format) {
    return format == Format::depth32_float ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

VkImageLayout drawing_layout(Format format) {
    return format == Format::depth32_float ? VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL
                                           : VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
}

void change_layout(VkCommandBuffer commands, VkImage image, Format format, VkImageLayout from,
                   VkImageLayout to) {
    VkImageMemoryBarrier2 barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
    barrier.srcStageMask = barrier.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    barrier.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = {aspect(format), 0, 1, 0, 1};
    VkDependencyInfo info{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = 1;
    info.pImageMemoryBarriers = &barrier;
    vkCmdPipelineBarrier2(commands, &info);
}

} // namespace

Target::Target() = default;
Target::Target(Target&&) noexcept = default;
Target& Target::operator=(Target&&) noexcept = default;
Target::~Target() = default;
std::uint32_t Target::width() const { return impl_->width; }
std::uint32_t Target::height() const { return impl_->height; }

Raster::Raster() = default;
Raster::Raster(Raster&&) noexcept = default;
Raster& Raster::operator=(Raster&&) noexcept = default;
Raster::~Raster() = default;

Target Device::target(std::uint32_t width, std::uint32_t height, Format format) {
    const std::uint32_t limit = max_image_side();
    if (width == 0 || height == 0 || width > limit || height > limit)
        throw Error("an image of {} x {} cannot be drawn: {} takes 1 to {} on a side", width, height,
                    info().name, limit);
    VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    info.imageType = VK_IMAGE_TYPE_2D;
    info.format = vulkan_format(format);
    info.extent = {width, height, 1};
    info.mipLevels = info.arrayLayers = 1;
    info.samples = VK_SAMPLE_COUNT_1_BIT;
    info.tiling = VK_IMAGE_TILING_OPTIMAL;
    info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT |
                 static_cast<VkImageUsageFlags>(format == Format::depth32_float
                                                    ? VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT
                                                    : VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
    Target target;
    target.impl_ = std::make_unique<Target::Impl>();
    Target::Impl& impl = *target.impl_;
    impl.width = width;
    impl.height = height;
    impl.format = format;
    VkImage image = VK_NULL_HANDLE;
    check(vkCreateImage(context_->device, &info, nullptr, &image), "creating an image");
    impl.image = {context_, image, vkDestroyImage};
    VkMemoryRequirements needs{};
    vkGetImageMemoryRequirements(context_->device, image, &needs);
    impl.memory = allocate_memory(context_, needs, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, 0);
    check(vkBindImageMemory(context_->device, image, impl.memory, 0), "binding an image's memory");
    VkImageViewCreateInfo view_info{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view_info.image = image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view_info.format = info.format;
    view_info.subresourceRange = {aspect(format), 0, 1, 0, 1};
    VkImageView view = VK_NULL_HANDLE;
    check(vkCreateImageView(context_->device, &view_info, nullptr, &view), "creating an image view");
    impl.view = {context_, view, vkDestroyImageView};
    return target;
}

Raster Device::raster(const glsl::Spirv& vertex, const glsl::Spirv& fragment, const RasterState& state,
                      std::string_view name, const glsl::Spirv& geometry) {
    if (!geometry.empty() && !has_geometry_shaders())
        throw Error("{}: {} has no geometry shaders; choose another --device or technique", name,
                    info().name);
    const bool adjacency = state.topology == Topology::triangles_with_adjacency;
    if (adjacency && geometry.empty()) throw Error("{}: adjacency is for a geometry shader", name);

    Raster raster;
    raster.impl_ = std::make_unique<Raster::Impl>();
    Raster::Impl& impl = *raster.impl_;
    impl.name = name;
    impl.state = state;
    glsl::Reflection interface;
    std::vector<Owned<VkShaderModule>> modules; // kept until the pipeline is made
    std::vector<VkPipelineShaderStageCreateInfo> shaders;
    const auto add_stage = [&](const glsl::Spirv& words, VkShaderStageFlagBits stage) {
        if (words.empty()) return;
        add_interface(interface, words, name);
        modules.push_back(shader_module(context_, words));
        VkPipelineShaderStageCreateInfo shader{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
        shader.stage = stage;
        shader.module = modules.back();
        shader.pName = "main";
        shaders.push_back(shader);
        impl.stages |= static_cast<VkShaderStageFlags>(stage);
    };
    add_stage(vertex, VK_SHADER_STAGE_VERTEX_BIT);
    add_stage(geometry, VK_SHADER_STAGE_GEOMETRY_BIT);
    add_stage(fragment, VK_SHADER_STAGE_FRAGMENT_BIT);
    impl.bindings =
        make_bindings(context_, interface.storage_buffers, interface.push_constant_bytes, impl.stages);

    const VkPipelineVertexInputStateCreateInfo input{
        VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly{
        VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology =
        adjacency ? VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST_WITH_ADJACENCY : VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport{VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo rasterization{
        VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    rasterization.depthClampEnable = state.clamp_depth ? VK_TRUE : VK_FALSE;
    rasterization.cullMode = cull_mode(state.cull);
    rasterization.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
    rasterization.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo samples{VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    VkPipelineDepthStencilStateCreateInfo depth{VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_LESS_OR_EQUAL;
    VkPipelineColorBlendAttachmentState write_all{};
    write_all.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                               VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    const std::vector<VkPipelineColorBlendAttachmentState> attachments(state.colours.size(), write_all);
    VkPipelineColorBlendStateCreateInfo blend{VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    blend.attachmentCount = static_cast<std::uint32_t>(attachments.size());
    blend.pAttachments = attachments.data();
    constexpr std::array dynamic_states{VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic{VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = static_cast<std::uint32_t>(dynamic_states.size());
    dynamic.pDynamicStates = dynamic_states.data();
    std::vector<VkFormat> formats;
    for (const Format format : state.colours) formats.push_back(vulkan_format(format));
    VkPipelineRenderingCreateInfo rendering{VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(formats.size());
    rendering.pColorAttachmentFormats = formats.data();
    rendering.depthAttachmentFormat = VK_FORMAT_D32_SFLOAT;

    VkGraphicsPipelineCreateInfo info{VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
    info.stageCount = static_cast<std::uint32_t>(shaders.size());
    info.pStages = shaders.data();
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &rasterization;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
    info.layout = impl.bindings.pipeline_layout;
    VkPipeline pipeline = VK_NULL_HANDLE;
    check(vkCreateGraphicsPipelines(context_->device, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline),
          "creating a raster pipeline");
    impl.pipeline = {context_, pipeline, vkDestroyPipeline};
    return raster;
}

double Device::draw(Raster& raster, std::initializer_list<const Target*> colours, const Target& depth,
                    std::initializer_list<const Buffer*> buffers, std::uint32_t vertices,
                    std::span<const std::byte> constants) {
    Raster::Impl& impl = *raster.impl_;
    std::vector<VkBuffer> handles;
    for (const Buffer* buffer : buffers) handles.push_back(buffer->impl_->handle);
    std::vector<const Target*> all(colours);
    all.push_back(&depth);

    const auto attachment = [](const Target& target) {
        VkRenderingAttachmentInfo info{VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
        info.imageView = target.impl_->view;
        info.imageLayout = drawing_layout(target.impl_->format);
        info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
        info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
        if (target.impl_->format == Format::depth32_float) info.clearValue.depthStencil = {1.0f, 0};
        return info;
    };
    std::vector<VkRenderingAttachmentInfo> colour_attachments;
    for (const Target* target : colours) colour_attachments.push_back(attachment(*target));
    const VkRenderingAttachmentInfo depth_attachment = attachment(depth);
    const VkRect2D area{{0, 0}, {depth.width(), depth.height()}};
    VkRenderingInfo rendering{VK_STRUCTURE_TYPE_RENDERING_INFO};
    rendering.renderArea = area;
    rendering.layerCount = 1;
    rendering.colorAttachmentCount = static_cast<std::uint32_t>(colour_attachments.size());
    rendering.pColorAttachments = colour_attachments.data();
    rendering.pDepthAttachment = &depth_attachment;
    const VkViewport viewport{0, 0, static_cast<float>(depth.width()), static_cast<float>(depth.height()),
                              0, 1};
    try {
        return submit(*context_, [&](VkCommandBuffer commands) {
            for (const Target* target : all) // what was there is cleared: coming from UNDEFINED is right
                change_layout(commands, target->impl_->image, target->impl_->format,
                              VK_IMAGE_LAYOUT_UNDEFINED, drawing_layout(target->impl_->format));
            vkCmdBeginRendering(commands, &rendering);
            vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, impl.pipeline);
            record_bindings(*context_, commands, VK_PIPELINE_BIND_POINT_GRAPHICS, impl.bindings, handles,
                            constants, impl.stages, impl.name);
            vkCmdSetViewport(commands, 0, 1, &viewport);
            vkCmdSetScissor(commands, 0, 1, &area);
            vkCmdDraw(commands, vertices, 1, 0, 0);
            vkCmdEndRendering(commands);
            full_barrier(commands); // stages may have written to buffers (bind_always)
            for (const Target* target : all)
                change_layout(commands, target->impl_->image, target->impl_->format,
                              drawing_layout(target->impl_->format), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
        });
    } catch (const KernelTimeout& timeout) {
        throw KernelTimeout("{}: {}", impl.name, timeout.what());
    }
}

Buffer Device::texels(const Target& target) {
    const Target::Impl& impl = *target.impl_;
    const std::size_t texel = impl.format == Format::depth32_float ? 4 : 16;
    Buffer buffer = allocate(texel * impl.width * impl.height);
    submit(*context_, [&](VkCommandBuffer commands) {
        VkBufferImageCopy region{};
        region.imageSubresource = {aspect(impl.format), 0, 0, 1};
        region.imageExtent = {impl.width, impl.height, 1};
        vkCmdCopyImageToBuffer(commands, impl.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                               buffer.impl_->handle, 1, &region);
        full_barrier(commands);
    });
    return buffer;
}

} // namespace gnomon::gpu
