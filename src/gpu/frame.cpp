// Frame: barriers, scopes and the transfers that are no shader's work. The pass itself is in pass.cpp.
#include "gpu/pass.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace glint::gpu {

Frame::Frame(Context& context, VkCommandBuffer commands, Timers* timers, std::vector<WrittenImage>* written)
    : context_(context), commands_(commands), timers_(timers), written_(written) {
    if (timers_)
        timers_->beginFrame(commands_);
    if (written_)
        written_->clear();
}

Frame Frame::more(Context& context, VkCommandBuffer commands, Timers& timers) {
    Frame frame(context, commands);
    frame.timers_ = &timers;
    return frame;
}

Frame Frame::rehearsal(Context& context) {
    return Frame(context, VK_NULL_HANDLE);
}

void Frame::fail(std::string message) {
    // A rehearsal reports; while recording for real, a wrong name is a programmer's mistake.
    GLINT_ASSERT(rehearsing(), "{}", message);
    if (error_.empty())
        error_ = std::move(message);
}

Result<void> Frame::firstError() const {
    if (!error_.empty())
        return Error{ErrorCode::InvalidArgument, error_};
    return {};
}

void Frame::use(Image& image, uint32_t firstMip, uint32_t mipCount, const Use& use) {
    if (rehearsing())
        return;
    std::vector<ResourceState>& states = image.states();
    for (uint32_t mip = firstMip; mip < firstMip + mipCount; ++mip) {
        const std::optional<Barrier> barrier = transition(states[mip], use);
        if (!barrier)
            continue;
        VkImageMemoryBarrier2 out = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
        out.srcStageMask = barrier->srcStages;
        out.srcAccessMask = barrier->srcAccess;
        out.dstStageMask = barrier->dstStages;
        out.dstAccessMask = barrier->dstAccess;
        out.oldLayout = barrier->oldLayout;
        out.newLayout = barrier->newLayout;
        out.srcQueueFamilyIndex = out.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
        out.image = image.handle();
        out.subresourceRange = {image.barrierAspect(), mip, 1, 0, image.desc().layers};
        if (imageBarrierCount_ > 0) { // neighbouring mips with the same history share one barrier
            VkImageMemoryBarrier2& last = imageBarriers_[imageBarrierCount_ - 1];
            if (last.image == out.image && last.srcStageMask == out.srcStageMask &&
                last.srcAccessMask == out.srcAccessMask && last.oldLayout == out.oldLayout &&
                last.newLayout == out.newLayout && last.dstStageMask == out.dstStageMask &&
                last.dstAccessMask == out.dstAccessMask &&
                last.subresourceRange.baseMipLevel + last.subresourceRange.levelCount == mip) {
                ++last.subresourceRange.levelCount;
                continue;
            }
        }
        if (imageBarrierCount_ == imageBarriers_.size())
            flushBarriers();
        imageBarriers_[imageBarrierCount_++] = out;
    }
}

void Frame::use(Buffer& buffer, const Use& use) {
    if (rehearsing())
        return;
    const std::optional<Barrier> barrier = transition(buffer.state(), use);
    if (!barrier)
        return;
    if (bufferBarrierCount_ == bufferBarriers_.size())
        flushBarriers();
    VkBufferMemoryBarrier2& out = bufferBarriers_[bufferBarrierCount_++];
    out = {VK_STRUCTURE_TYPE_BUFFER_MEMORY_BARRIER_2};
    out.srcStageMask = barrier->srcStages;
    out.srcAccessMask = barrier->srcAccess;
    out.dstStageMask = barrier->dstStages;
    out.dstAccessMask = barrier->dstAccess;
    out.srcQueueFamilyIndex = out.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    out.buffer = buffer.handle();
    out.size = VK_WHOLE_SIZE;
}

void Frame::flushBarriers() {
    if (imageBarrierCount_ + bufferBarrierCount_ == 0)
        return;
    VkDependencyInfo info = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.imageMemoryBarrierCount = imageBarrierCount_;
    info.pImageMemoryBarriers = imageBarriers_.data();
    info.bufferMemoryBarrierCount = bufferBarrierCount_;
    info.pBufferMemoryBarriers = bufferBarriers_.data();
    context_.api().CmdPipelineBarrier2(commands_, &info);
    imageBarrierCount_ = bufferBarrierCount_ = 0;
}

void Frame::beginScope(const std::string& name) {
    if (context_.api().CmdBeginDebugUtilsLabelEXT) {
        VkDebugUtilsLabelEXT label = {VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
        label.pLabelName = name.c_str();
        context_.api().CmdBeginDebugUtilsLabelEXT(commands_, &label);
    }
    if (timers_)
        timers_->begin(commands_, name);
}

void Frame::endScope() {
    if (timers_)
        timers_->end(commands_);
    if (context_.api().CmdEndDebugUtilsLabelEXT)
        context_.api().CmdEndDebugUtilsLabelEXT(commands_);
}

// ---------------------------------------------------------------- transfers

namespace {

constexpr Use kTransferWriteBuffer = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                      VK_IMAGE_LAYOUT_UNDEFINED, true};
constexpr Use kTransferReadBuffer = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT};
constexpr Use kTransferWriteImage = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                     VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true};
constexpr Use kTransferReadImage = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_READ_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL};

VkBufferImageCopy copyRegion(const Image& image, uint32_t mip, uint32_t layer, size_t offset) {
    VkBufferImageCopy region = {};
    region.bufferOffset = offset;
    region.imageSubresource = {image.aspect(), mip, layer, 1};
    region.imageExtent = {std::max(image.width() >> mip, 1u), std::max(image.height() >> mip, 1u), 1};
    return region;
}

} // namespace

void Frame::update(Buffer& buffer, const void* data, size_t size, size_t offset) {
    use(buffer, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    constexpr size_t kMost = 65536; // Vulkan's own bound for one command
    for (size_t done = 0; done < size; done += kMost)
        context_.api().CmdUpdateBuffer(commands_, buffer.handle(), offset + done, std::min(size - done, kMost),
                                       static_cast<const std::byte*>(data) + done);
}

void Frame::upload(Buffer& staging, Buffer& target) {
    use(target, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    const VkBufferCopy region = {0, 0, staging.size()};
    context_.api().CmdCopyBuffer(commands_, staging.handle(), target.handle(), 1, &region);
}

void Frame::build(std::span<AccelerationStructure* const> structures, Buffer& scratch) {
    buildAll(structures, scratch, false);
}

void Frame::refit(std::span<AccelerationStructure* const> structures, Buffer& scratch) {
    buildAll(structures, scratch, true);
}

void Frame::buildAll(std::span<AccelerationStructure* const> structures, Buffer& scratch, bool refit) {
    while (!structures.empty()) {
        size_t count = 0; // of those that share the scratch memory, each with a part of its own
        for (size_t bytes = 0; count < structures.size(); ++count) {
            bytes += structures[count]->scratchSize();
            if (count > 0 && bytes > scratch.size())
                break;
        }
        const auto batch = structures.first(count);
        structures = structures.subspan(count);
        for (AccelerationStructure* structure : batch) {
            for (Buffer* input : structure->inputs())
                use(*input, kBuildInput);
            for (AccelerationStructure* bottom : structure->references())
                use(bottom->storage(), kBuildReference);
            use(structure->storage(), kBuildTarget);
        }
        use(scratch, kBuildTarget);
        if (rehearsing())
            continue;
        flushBarriers();
        size_t offset = 0;
        for (const AccelerationStructure* structure : batch) {
            structure->recordBuild(commands_, scratch, offset, refit);
            offset += structure->scratchSize();
        }
    }
}

void Frame::fill(Buffer& buffer, uint32_t value) {
    use(buffer, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    context_.api().CmdFillBuffer(commands_, buffer.handle(), 0, VK_WHOLE_SIZE, value);
}

void Frame::clear(Image& image, const VkClearColorValue& value) {
    Use clearing = kTransferWriteImage;
    clearing.discards = true;
    use(image, 0, image.desc().mips, clearing);
    if (rehearsing())
        return;
    flushBarriers();
    const VkImageSubresourceRange range = {image.aspect(), 0, image.desc().mips, 0, image.desc().layers};
    context_.api().CmdClearColorImage(commands_, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &value, 1,
                                      &range);
}

void Frame::hand(Image& image, const Use& wanted) {
    use(image, 0, image.desc().mips, wanted);
    if (!rehearsing())
        flushBarriers();
}

void Frame::hand(Buffer& buffer, const Use& wanted) {
    use(buffer, wanted);
    if (!rehearsing())
        flushBarriers();
}

void Frame::copyToBuffer(Image& image, uint32_t mip, uint32_t layer, Buffer& buffer) {
    use(image, mip, 1, kTransferReadImage);
    use(buffer, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    const VkBufferImageCopy region = copyRegion(image, mip, layer, 0);
    context_.api().CmdCopyImageToBuffer(commands_, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                                        buffer.handle(), 1, &region);
    // The CPU reads next: make the copy visible to it.
    use(buffer, {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    flushBarriers();
}

void Frame::copyFromBuffer(Buffer& buffer, size_t offset, Image& image, uint32_t mip, uint32_t layer) {
    use(buffer, kTransferReadBuffer);
    use(image, mip, 1, kTransferWriteImage);
    if (rehearsing())
        return;
    flushBarriers();
    const VkBufferImageCopy region = copyRegion(image, mip, layer, offset);
    context_.api().CmdCopyBufferToImage(commands_, buffer.handle(), image.handle(),
                                        VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void Frame::makeMips(Image& image) {
    const uint32_t layers = image.desc().layers;
    for (uint32_t mip = 1; mip < image.desc().mips; ++mip) {
        use(image, mip - 1, 1, kTransferReadImage);
        use(image, mip, 1, kTransferWriteImage);
        if (rehearsing())
            continue;
        flushBarriers();
        const auto extent = [&](uint32_t level) {
            return VkOffset3D{static_cast<int32_t>(std::max(image.width() >> level, 1u)),
                              static_cast<int32_t>(std::max(image.height() >> level, 1u)), 1};
        };
        VkImageBlit blit = {};
        blit.srcSubresource = {image.aspect(), mip - 1, 0, layers};
        blit.srcOffsets[1] = extent(mip - 1);
        blit.dstSubresource = {image.aspect(), mip, 0, layers};
        blit.dstOffsets[1] = extent(mip);
        context_.api().CmdBlitImage(commands_, image.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, image.handle(),
                                    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_LINEAR);
    }
}

void Frame::copy(Image& source, Image& target) {
    use(source, 0, 1, kTransferReadImage);
    use(target, 0, 1, kTransferWriteImage);
    if (rehearsing())
        return;
    flushBarriers();
    VkImageCopy region = {};
    region.srcSubresource = {source.aspect(), 0, 0, 1};
    region.dstSubresource = {target.aspect(), 0, 0, 1};
    region.extent = {source.width(), source.height(), 1};
    context_.api().CmdCopyImage(commands_, source.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.handle(),
                                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void Frame::convert(Image& source, Image& target) {
    use(source, 0, 1, kTransferReadImage);
    use(target, 0, 1, kTransferWriteImage);
    if (rehearsing())
        return;
    flushBarriers();
    const VkOffset3D corner = {static_cast<int32_t>(source.width()), static_cast<int32_t>(source.height()), 1};
    VkImageBlit blit = {};
    blit.srcSubresource = {source.aspect(), 0, 0, 1};
    blit.dstSubresource = {target.aspect(), 0, 0, 1};
    blit.srcOffsets[1] = blit.dstOffsets[1] = corner;
    context_.api().CmdBlitImage(commands_, source.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.handle(),
                                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &blit, VK_FILTER_NEAREST);
}

void Frame::resolve(Image& source, Image& target) {
    use(source, 0, 1, kTransferReadImage);
    use(target, 0, 1, kTransferWriteImage);
    if (rehearsing())
        return;
    flushBarriers();
    VkImageResolve region = {};
    region.srcSubresource = {source.aspect(), 0, 0, 1};
    region.dstSubresource = {target.aspect(), 0, 0, 1};
    region.extent = {source.width(), source.height(), 1};
    context_.api().CmdResolveImage(commands_, source.handle(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, target.handle(),
                                   VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
}

void Frame::copyBuffer(Buffer& source, Buffer& readback) {
    use(source, kTransferReadBuffer);
    use(readback, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    const VkBufferCopy region = {0, 0, source.size()};
    context_.api().CmdCopyBuffer(commands_, source.handle(), readback.handle(), 1, &region);
    use(readback, {VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT});
    flushBarriers();
}

} // namespace glint::gpu
