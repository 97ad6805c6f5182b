#include "gpu/pass.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "gpu/pass_log.hpp"

#include <cstring>

namespace glint::gpu {
namespace {

VkPipelineStageFlags2 shaderStages(const Pipeline& pipeline) {
    return pipeline.bindPoint() == VK_PIPELINE_BIND_POINT_COMPUTE
               ? VK_PIPELINE_STAGE_2_COMPUTE_SHADER_BIT
               : VK_PIPELINE_STAGE_2_VERTEX_SHADER_BIT | VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT;
}

const char* accessWord(bool reads, bool writes) {
    return reads && writes ? "readWrite" : writes ? "write" : "read";
}

std::string bindingNames(const Pipeline& pipeline) {
    std::vector<std::string> names;
    for (const ShaderBinding& binding : pipeline.bindings())
        names.push_back(formatText("{} ({})", binding.name, accessWord(binding.reads, binding.writes)));
    return joinText(names, ", ");
}

/// True if every device that runs Glint can filter this format (Vulkan 1.3, "Required Format Support").
bool filterable(VkFormat format) {
    switch (format) {
    case VK_FORMAT_R32_SFLOAT:
    case VK_FORMAT_R32G32_SFLOAT:
    case VK_FORMAT_R32G32B32A32_SFLOAT:
    case VK_FORMAT_D16_UNORM:
    case VK_FORMAT_X8_D24_UNORM_PACK32:
    case VK_FORMAT_D32_SFLOAT:
    case VK_FORMAT_D16_UNORM_S8_UINT:
    case VK_FORMAT_D24_UNORM_S8_UINT:
    case VK_FORMAT_D32_SFLOAT_S8_UINT:
    case VK_FORMAT_R8_UINT:
    case VK_FORMAT_R16_UINT:
    case VK_FORMAT_R32_UINT:
    case VK_FORMAT_R32G32_UINT:
    case VK_FORMAT_R32G32B32A32_UINT: return false;
    default: return true;
    }
}

PassLog* logOf(const Frame& frame) {
    return frame.rehearsing() ? nullptr : PassLog::current();
}

void logUse(const Frame& frame, const Pipeline& pipeline, const ShaderBinding& binding, const Image& image,
            uint32_t firstMip, uint32_t mips) {
    if (PassLog* const log = logOf(frame))
        log->add({.pass = pipeline.name(),
                  .binding = std::string(binding.name),
                  .reads = binding.reads,
                  .writes = binding.writes,
                  .resource = image.desc().name,
                  .image = image.desc(),
                  .firstMip = firstMip,
                  .mips = mips});
}

/// A buffer, or with 0 bytes an acceleration structure.
void logUse(const Frame& frame, const Pipeline& pipeline, const ShaderBinding& binding, const std::string& resource,
            size_t bytes) {
    if (PassLog* const log = logOf(frame))
        log->add({.pass = pipeline.name(),
                  .binding = std::string(binding.name),
                  .reads = binding.reads,
                  .writes = binding.writes,
                  .resource = resource,
                  .bufferSize = bytes});
}

} // namespace

// ---------------------------------------------------------------- what the shader reads and writes

Pass::ResourceKind Pass::resourceKind(BindingKind kind) {
    switch (kind) {
    case BindingKind::SampledImage:
    case BindingKind::StorageImage: return ResourceKind::Image;
    case BindingKind::UniformBuffer:
    case BindingKind::StorageBuffer: return ResourceKind::Buffer;
    case BindingKind::AccelerationStructure: return ResourceKind::AccelerationStructure;
    }
    return ResourceKind::Buffer;
}

const char* Pass::kindWord(ResourceKind kind) {
    switch (kind) {
    case ResourceKind::Image: return "an image";
    case ResourceKind::Buffer: return "a buffer";
    case ResourceKind::AccelerationStructure: return "an acceleration structure";
    }
    return "";
}

const ShaderBinding* Pass::find(std::string_view name, bool reads, bool writes, ResourceKind kind) {
    const std::span<const ShaderBinding> bindings = pipeline_.bindings();
    for (size_t i = 0; i < bindings.size(); ++i) {
        const ShaderBinding& binding = bindings[i];
        if (binding.name != name)
            continue;
        const ResourceKind declared = resourceKind(binding.kind);
        if (binding.reads != reads || binding.writes != writes || declared != kind) {
            frame_.fail(formatText("{}: '{}' is declared for {} as {}, but bound for {} as {}", pipeline_.name(), name,
                                   accessWord(binding.reads, binding.writes), kindWord(declared),
                                   accessWord(reads, writes), kindWord(kind)));
            return nullptr;
        }
        boundMask_ |= 1u << i;
        return &binding;
    }
    frame_.fail(formatText("{}: no binding '{}'; the shader has {}", pipeline_.name(), name, bindingNames(pipeline_)));
    return nullptr;
}

void Pass::bindImage(const ShaderBinding& binding, VkImageView view, VkImageLayout layout, VkSampler sampler) {
    imageInfos_[bound_] = {sampler, view, layout};
    VkWriteDescriptorSet& write = writes_[bound_];
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstBinding = binding.binding;
    write.descriptorCount = 1;
    write.descriptorType = binding.kind == BindingKind::SampledImage ? VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER
                                                                     : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    ++bound_;
}

void Pass::bindBuffer(const ShaderBinding& binding, Buffer& buffer, bool writes) {
    const bool uniform = binding.kind == BindingKind::UniformBuffer;
    VkAccessFlags2 access = uniform ? VK_ACCESS_2_UNIFORM_READ_BIT : VK_ACCESS_2_SHADER_STORAGE_READ_BIT;
    if (writes)
        access = VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT | (binding.reads ? VK_ACCESS_2_SHADER_STORAGE_READ_BIT : 0);
    frame_.use(buffer, {shaderStages(pipeline_), access, VK_IMAGE_LAYOUT_UNDEFINED, writes});
    logUse(frame_, pipeline_, binding, buffer.name(), buffer.size());
    bufferInfos_[bound_] = {buffer.handle(), 0, VK_WHOLE_SIZE};
    VkWriteDescriptorSet& write = writes_[bound_];
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstBinding = binding.binding;
    write.descriptorCount = 1;
    write.descriptorType = uniform ? VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    ++bound_;
}

Pass& Pass::read(std::string_view name, Image& image, SamplerKind sampler) {
    if (const ShaderBinding* binding = find(name, true, false, ResourceKind::Image)) {
        const VkDescriptorImageInfo info = sampled(image, sampler);
        logUse(frame_, pipeline_, *binding, image, 0, image.desc().mips);
        bindImage(*binding, info.imageView, info.imageLayout, info.sampler);
    }
    return *this;
}

Pass& Pass::read(std::string_view name, std::span<Image* const> images, SamplerKind sampler) {
    const ShaderBinding* binding = find(name, true, false, ResourceKind::Image);
    if (!binding)
        return *this;
    if (binding->count != images.size() || arrayImages_ + images.size() > kMaxArrayImages) {
        frame_.fail(formatText("{}: '{}' is an array of {} images, but {} are bound; all arrays may have {}",
                               pipeline_.name(), name, binding->count, images.size(), kMaxArrayImages));
        return *this;
    }
    for (size_t i = 0; i < images.size(); ++i) {
        arrayInfos_[arrayImages_ + i] = sampled(*images[i], sampler);
        logUse(frame_, pipeline_, *binding, *images[i], 0, images[i]->desc().mips);
    }
    bindImage(*binding, VK_NULL_HANDLE, VK_IMAGE_LAYOUT_UNDEFINED, VK_NULL_HANDLE);
    writes_[bound_ - 1].descriptorCount = binding->count;
    writes_[bound_ - 1].dstArrayElement = 0;
    arrayImages_ += binding->count;
    return *this;
}

/// Records the use as a sampled image and returns the descriptor.
VkDescriptorImageInfo Pass::sampled(Image& image, SamplerKind sampler) {
    constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    frame_.use(image, 0, image.desc().mips, {shaderStages(pipeline_), VK_ACCESS_2_SHADER_SAMPLED_READ_BIT, kLayout});
    if (sampler == SamplerKind::LinearClamp && !filterable(image.desc().format))
        sampler = SamplerKind::NearestClamp;
    return {frame_.context_.sampler(sampler), image.view(), kLayout};
}

Pass& Pass::read(std::string_view name, Buffer& buffer) {
    if (const ShaderBinding* binding = find(name, true, false, ResourceKind::Buffer))
        bindBuffer(*binding, buffer, false);
    return *this;
}

Pass& Pass::readByAddress(Buffer& buffer) {
    frame_.use(buffer, {shaderStages(pipeline_), VK_ACCESS_2_SHADER_STORAGE_READ_BIT});
    return *this;
}

Pass& Pass::read(std::string_view name, AccelerationStructure& top) {
    const Use use = traversal(shaderStages(pipeline_));
    frame_.use(top.storage(), use);
    for (AccelerationStructure* bottom : top.references())
        frame_.use(bottom->storage(), use);
    return read(name, top.handle());
}

Pass& Pass::read(std::string_view name, VkAccelerationStructureKHR top) {
    const ShaderBinding* binding = find(name, true, false, ResourceKind::AccelerationStructure);
    if (!binding)
        return *this;
    scene_ = top;
    logUse(frame_, pipeline_, *binding, "acceleration structure", 0);
    VkWriteDescriptorSet& write = writes_[bound_++];
    write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstBinding = binding->binding;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
    return *this;
}

Pass& Pass::write(std::string_view name, Image& image, uint32_t mip, bool keep) {
    if (const ShaderBinding* binding = find(name, false, true, ResourceKind::Image)) {
        frame_.use(
            image, mip, 1,
            {shaderStages(pipeline_), VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT, VK_IMAGE_LAYOUT_GENERAL, true, !keep});
        bindImage(*binding, image.mipView(mip), VK_IMAGE_LAYOUT_GENERAL, VK_NULL_HANDLE);
        frame_.noteWritten(pipeline_.name(), binding->name, image);
        logUse(frame_, pipeline_, *binding, image, mip, 1);
    }
    return *this;
}

Pass& Pass::write(std::string_view name, Buffer& buffer) {
    if (const ShaderBinding* binding = find(name, false, true, ResourceKind::Buffer))
        bindBuffer(*binding, buffer, true);
    return *this;
}

Pass& Pass::readWrite(std::string_view name, Image& image, uint32_t mip) {
    if (const ShaderBinding* binding = find(name, true, true, ResourceKind::Image)) {
        frame_.use(image, mip, 1,
                   {shaderStages(pipeline_), VK_ACCESS_2_SHADER_STORAGE_READ_BIT | VK_ACCESS_2_SHADER_STORAGE_WRITE_BIT,
                    VK_IMAGE_LAYOUT_GENERAL, true});
        bindImage(*binding, image.mipView(mip), VK_IMAGE_LAYOUT_GENERAL, VK_NULL_HANDLE);
        frame_.noteWritten(pipeline_.name(), binding->name, image);
        logUse(frame_, pipeline_, *binding, image, mip, 1);
    }
    return *this;
}

Pass& Pass::readWrite(std::string_view name, Buffer& buffer) {
    if (const ShaderBinding* binding = find(name, true, true, ResourceKind::Buffer))
        bindBuffer(*binding, buffer, true);
    return *this;
}

bool Pass::rehearsing() const {
    return frame_.rehearsing();
}

Pass& Pass::table(VkDescriptorSet set) {
    table_ = set;
    return *this;
}

Pass& Pass::indices(Buffer& buffer) {
    frame_.use(buffer, {VK_PIPELINE_STAGE_2_INDEX_INPUT_BIT, VK_ACCESS_2_INDEX_READ_BIT});
    indices_ = buffer.handle();
    return *this;
}

Pass& Pass::pushBytes(const void* data, size_t size) {
    if (size != pipeline_.pushSize())
        frame_.fail(
            formatText("{}: {} bytes pushed, the shader takes {}", pipeline_.name(), size, pipeline_.pushSize()));
    std::memcpy(pushed_.data(), data, size);
    pushedSize_ = size;
    return *this;
}

// ---------------------------------------------------------------- attachments

Pass& Pass::color(Image& image, const VkClearColorValue* clear, uint32_t mip) {
    VkAccessFlags2 access = VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT;
    if (!clear)
        access |= VK_ACCESS_2_COLOR_ATTACHMENT_READ_BIT; // blending and loading read the attachment
    frame_.use(image, mip, 1,
               {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, access, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true,
                clear != nullptr});
    Attachment& attachment = colors_[colorCount_++];
    attachment.image = &image;
    attachment.info.imageView = image.mipView(mip);
    attachment.info.imageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    attachment.info.loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    attachment.info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    if (clear)
        attachment.info.clearValue.color = *clear;
    frame_.noteWritten(pipeline_.name(), image.desc().name, image);
    return *this;
}

Pass& Pass::resolve(Image& image) {
    frame_.use(image, 0, 1,
               {VK_PIPELINE_STAGE_2_COLOR_ATTACHMENT_OUTPUT_BIT, VK_ACCESS_2_COLOR_ATTACHMENT_WRITE_BIT,
                VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL, true, true});
    VkRenderingAttachmentInfo& info = colors_[colorCount_ - 1].info;
    info.resolveMode = VK_RESOLVE_MODE_AVERAGE_BIT;
    info.resolveImageView = image.mipView(0);
    info.resolveImageLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
    return *this;
}

Pass& Pass::depth(Image& image, bool clear, bool writes) {
    constexpr VkPipelineStageFlags2 kStages =
        VK_PIPELINE_STAGE_2_EARLY_FRAGMENT_TESTS_BIT | VK_PIPELINE_STAGE_2_LATE_FRAGMENT_TESTS_BIT;
    VkAccessFlags2 access = VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_READ_BIT;
    if (writes || clear)
        access |= VK_ACCESS_2_DEPTH_STENCIL_ATTACHMENT_WRITE_BIT;
    frame_.use(image, 0, 1, {kStages, access, VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL, writes || clear, clear});
    depth_.image = &image;
    depth_.info.imageView = image.mipView(0);
    depth_.info.imageLayout = VK_IMAGE_LAYOUT_DEPTH_ATTACHMENT_OPTIMAL;
    depth_.info.loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;
    depth_.info.storeOp = writes || clear ? VK_ATTACHMENT_STORE_OP_STORE : VK_ATTACHMENT_STORE_OP_NONE;
    return *this;
}

Pass& Pass::depthView(Image& image, VkImageView layerView, bool clear) {
    depth(image, clear);
    depth_.info.imageView = layerView;
    return *this;
}

// ---------------------------------------------------------------- recording

bool Pass::begin() {
    const std::span<const ShaderBinding> bindings = pipeline_.bindings();
    for (size_t i = 0; i < bindings.size(); ++i)
        if ((boundMask_ & (1u << i)) == 0)
            frame_.fail(formatText("{}: '{}' is not bound; the shader has {}", pipeline_.name(), bindings[i].name,
                                   bindingNames(pipeline_)));
    if (frame_.rehearsing() || !pipeline_)
        return false;
    GLINT_ASSERT(pipeline_.handle() != VK_NULL_HANDLE, "{} is recorded, but was never compiled", pipeline_.name());

    frame_.flushBarriers();
    frame_.beginScope(pipeline_.name().c_str());
    const Api& api = frame_.context_.api();
    const VkCommandBuffer commands = frame_.commands_;
    api.CmdBindPipeline(commands, pipeline_.bindPoint(), pipeline_.handle());
    // Only now, as a pass may be copied while its expression is evaluated.
    for (uint32_t i = 0, inArrays = 0; i < bound_; ++i) {
        const bool isArray = writes_[i].descriptorCount > 1;
        writes_[i].pImageInfo = isArray ? &arrayInfos_[inArrays] : &imageInfos_[i];
        inArrays += isArray ? writes_[i].descriptorCount : 0;
        writes_[i].pBufferInfo = &bufferInfos_[i];
        if (writes_[i].descriptorType == VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR) {
            sceneWrite_.accelerationStructureCount = 1;
            sceneWrite_.pAccelerationStructures = &scene_;
            writes_[i].pNext = &sceneWrite_;
        }
    }
    if (bound_ > 0)
        api.CmdPushDescriptorSetKHR(commands, pipeline_.bindPoint(), pipeline_.layout(), 0, bound_, writes_.data());
    if (table_)
        api.CmdBindDescriptorSets(commands, pipeline_.bindPoint(), pipeline_.layout(), 1, 1, &table_, 0, nullptr);
    if (pushedSize_ > 0)
        api.CmdPushConstants(commands, pipeline_.layout(), pipeline_.stages(), 0, static_cast<uint32_t>(pushedSize_),
                             pushed_.data());
    return true;
}

void Pass::dispatch(uint32_t width, uint32_t height, uint32_t depth) {
    if (pushedSize_ != pipeline_.pushSize())
        frame_.fail(formatText("{}: takes {} bytes of push constants, none were given", pipeline_.name(),
                               pipeline_.pushSize()));
    if (!begin())
        return;
    const uint32_t* local = pipeline_.localSize();
    const auto groups = [](uint32_t elements, uint32_t size) { return (elements + size - 1) / size; };
    frame_.context_.api().CmdDispatch(frame_.commands_, groups(width, local[0]), groups(height, local[1]),
                                      groups(depth, local[2]));
    frame_.endScope();
}

void Pass::dispatchIndirect(Buffer& arguments, size_t offset) {
    if (pushedSize_ != pipeline_.pushSize())
        frame_.fail(formatText("{}: takes {} bytes of push constants, none were given", pipeline_.name(),
                               pipeline_.pushSize()));
    frame_.use(arguments, {VK_PIPELINE_STAGE_2_DRAW_INDIRECT_BIT, VK_ACCESS_2_INDIRECT_COMMAND_READ_BIT});
    if (!begin())
        return;
    frame_.context_.api().CmdDispatchIndirect(frame_.commands_, arguments.handle(), offset);
    frame_.endScope();
}

Draws Pass::beginDraws() {
    ready_ = begin();
    Draws draws(frame_.context_.api(), frame_.commands_, pipeline_);
    if (!ready_)
        return draws;
    std::array<VkRenderingAttachmentInfo, 8> colors;
    for (uint32_t i = 0; i < colorCount_; ++i)
        colors[i] = colors_[i].info;
    const Image& sizing = colorCount_ > 0 ? *colors_[0].image : *depth_.image;
    VkRenderingInfo info = {VK_STRUCTURE_TYPE_RENDERING_INFO};
    info.renderArea.extent = {sizing.width(), sizing.height()};
    info.layerCount = 1;
    info.colorAttachmentCount = colorCount_;
    info.pColorAttachments = colors.data();
    info.pDepthAttachment = depth_.image ? &depth_.info : nullptr;
    frame_.context_.api().CmdBeginRendering(frame_.commands_, &info);
    if (indices_)
        frame_.context_.api().CmdBindIndexBuffer(frame_.commands_, indices_, 0, VK_INDEX_TYPE_UINT32);
    draws.viewport(0, 0, sizing.width(), sizing.height()).cull(VK_CULL_MODE_NONE);
    return draws;
}

void Pass::endDraws() {
    frame_.context_.api().CmdEndRendering(frame_.commands_);
    frame_.endScope();
}

Draws& Draws::pushBytes(const void* data, size_t size) {
    api_.CmdPushConstants(commands_, pipeline_.layout(), pipeline_.stages(), 0, static_cast<uint32_t>(size), data);
    return *this;
}

Draws& Draws::cull(VkCullModeFlags mode, bool mirrored) {
    api_.CmdSetCullMode(commands_, mode);
    api_.CmdSetFrontFace(commands_, mirrored ? VK_FRONT_FACE_CLOCKWISE : VK_FRONT_FACE_COUNTER_CLOCKWISE);
    return *this;
}

Draws& Draws::viewport(uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    // A negative height flips Vulkan's clip space, so that +Y is up in matrices.
    const VkViewport viewport = {static_cast<float>(x),
                                 static_cast<float>(y + height),
                                 static_cast<float>(width),
                                 -static_cast<float>(height),
                                 0,
                                 1};
    const VkRect2D scissor = {{static_cast<int32_t>(x), static_cast<int32_t>(y)}, {width, height}};
    api_.CmdSetViewport(commands_, 0, 1, &viewport);
    api_.CmdSetScissor(commands_, 0, 1, &scissor);
    return *this;
}

Draws& Draws::scissor(uint32_t x, uint32_t y, uint32_t width, uint32_t height) {
    const VkRect2D scissor = {{static_cast<int32_t>(x), static_cast<int32_t>(y)}, {width, height}};
    api_.CmdSetScissor(commands_, 0, 1, &scissor);
    return *this;
}

void Draws::draw(uint32_t vertexCount, uint32_t instanceCount, uint32_t firstVertex, uint32_t firstInstance) {
    api_.CmdDraw(commands_, vertexCount, instanceCount, firstVertex, firstInstance);
}

void Draws::drawIndexed(uint32_t indexCount, uint32_t firstIndex, int32_t vertexOffset, uint32_t instanceCount,
                        uint32_t firstInstance) {
    api_.CmdDrawIndexed(commands_, indexCount, instanceCount, firstIndex, vertexOffset, firstInstance);
}

} // namespace glint::gpu
