// Frame: barriers, scopes, and transfers outside shaders. Pass is in pass.cpp.
#include "gpu/pass.hpp"

#include "base/assert.hpp"
#include "gpu/pass_log.hpp"

#include <algorithm>
#include <utility>

namespace glint::gpu {

Frame::Frame(Context& context, VkCommandBuffer commands, Timers* timers, std::vector<WrittenImage>* written,
             bool begins)
    : context_(context), commands_(commands), timers_(timers), written_(written),
      recording_(commands ? context.nextRecording() : 0) {
    if (timers_ && begins)
        timers_->beginFrame(commands_);
    if (written_)
        written_->clear();
}

Frame::Frame(Context& context, VkCommandBuffer commands, Timers* timers, std::vector<WrittenImage>* written)
    : Frame(context, commands, timers, written, true) {}

Frame Frame::more(Context& context, VkCommandBuffer commands, Timers* timers) {
    return {context, commands, timers, nullptr, false};
}

Frame Frame::rehearsal(Context& context) {
    return {context, VK_NULL_HANDLE, nullptr, nullptr, false};
}

Frame::~Frame() {
    if (rehearsing())
        return;
    settle();
    if (timers_)
        timers_->endFrame(commands_);
}

// ---------------------------------------------------------------- what was recorded before

namespace {

/// The state after any earlier recordings, executed or not.
constexpr ResourceState afterAll(VkImageLayout layout) {
    return {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, 0, 0, layout};
}

} // namespace

/// Recording allocates nothing, so a full list stays as it is.
void Frame::noteWritten(const std::string& pass, std::string_view binding, Image& image) {
    if (written_ && written_->size() < written_->capacity())
        written_->push_back({&pass, binding, &image});
}

void Frame::enter(Image& image) {
    if (image.rest() == VK_IMAGE_LAYOUT_UNDEFINED || image.recording() == recording_)
        return;
    if (restingCount_ == resting_.size())
        settle();
    image.enterRecording(recording_);
    image.lendAgain(afterAll(image.rest()));
    resting_[restingCount_++] = &image;
}

void Frame::enter(Buffer& buffer) {
    if (!context_.adopted() || buffer.recording() == recording_)
        return;
    buffer.enterRecording(recording_);
    buffer.state() = afterAll(VK_IMAGE_LAYOUT_UNDEFINED);
}

/// Returns the images used so far to their resting layouts; an image that is used again is added again.
void Frame::settle() {
    const uint32_t count = std::exchange(restingCount_, 0);
    for (uint32_t i = 0; i < count; ++i) {
        Image& image = *resting_[i];
        for (uint32_t mip = 0; mip < image.desc().mips; ++mip)
            if (image.states()[mip].layout != image.rest())
                use(image, mip, 1, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, image.rest()});
        image.enterRecording(0);
    }
    flushBarriers();
}

void Frame::find(Image& image, VkImageLayout layout) {
    enter(image);
    image.lendAgain(afterAll(layout));
}

void Frame::fail(std::string message) {
    // A rehearsal reports errors; in a real recording, a wrong name is a programming error.
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
    enter(image);
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
        if (imageBarrierCount_ > 0) { // neighbouring mips with the same state share one barrier
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
    enter(buffer);
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

void Frame::beginScope(const char* name) {
    if (context_.api().CmdBeginDebugUtilsLabelEXT) {
        VkDebugUtilsLabelEXT label = {VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
        label.pLabelName = name;
        context_.api().CmdBeginDebugUtilsLabelEXT(commands_, &label);
    }
    if (timers_)
        timers_->begin(commands_, name);
    if (PassLog* const log = PassLog::current())
        log->open(name);
}

void Frame::endScope() {
    if (PassLog* const log = PassLog::current())
        log->close();
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
/// Overwrites the whole resource.
constexpr Use kTransferFillImage = {VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                                    VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, true, true};
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
    copyIn(buffer, static_cast<const std::byte*>(data), size, offset);
}

void Frame::copyIn(Buffer& buffer, const std::byte* data, size_t size, size_t offset) {
    constexpr size_t kMost = 65536; // Vulkan's limit per command
    for (size_t done = 0; done < size; done += kMost)
        context_.api().CmdUpdateBuffer(commands_, buffer.handle(), offset + done, std::min(size - done, kMost),
                                       data + done);
}

void Frame::update(Buffer& buffer, std::span<const std::byte> content, std::span<const ByteRange> parts) {
    if (parts.empty())
        return;
    use(buffer, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    for (const ByteRange& part : parts)
        copyIn(buffer, content.data() + part.first, part.size, part.first);
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
        size_t count = 0; // of structures that share the scratch memory, each with its own part
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

void Frame::copyBytes(Buffer& source, size_t sourceOffset, Buffer& target, size_t targetOffset, size_t size) {
    use(source, kTransferReadBuffer);
    use(target, kTransferWriteBuffer);
    if (rehearsing())
        return;
    flushBarriers();
    const VkBufferCopy region = {sourceOffset, targetOffset, size};
    context_.api().CmdCopyBuffer(commands_, source.handle(), target.handle(), 1, &region);
}

void Frame::mark(Buffer& readback, uint32_t value, size_t offset) {
    if (rehearsing())
        return;
    flushBarriers();
    VkMemoryBarrier2 before = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    before.srcStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    before.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
    before.dstStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    before.dstAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    VkMemoryBarrier2 after = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    after.srcStageMask = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    after.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    after.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
    after.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
    VkDependencyInfo info = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &before;
    context_.api().CmdPipelineBarrier2(commands_, &info);
    context_.api().CmdUpdateBuffer(commands_, readback.handle(), offset, sizeof(value), &value);
    info.pMemoryBarriers = &after;
    context_.api().CmdPipelineBarrier2(commands_, &info);
}

void Frame::clear(Image& image, const VkClearColorValue& value) {
    use(image, 0, image.desc().mips, kTransferFillImage);
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
    // The CPU reads next, so the copy must be visible to the host.
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
        use(image, mip, 1, kTransferFillImage);
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
    use(target, 0, 1, kTransferFillImage);
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
    use(target, 0, 1, kTransferFillImage);
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
    use(target, 0, 1, kTransferFillImage);
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
