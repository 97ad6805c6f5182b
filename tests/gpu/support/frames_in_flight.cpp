#include "gpu/support/frames_in_flight.hpp"

#include "gpu/pass.hpp"

#include <cstring>
#include <utility>

namespace glint::test {

Recording::Recording(gpu::Context& context, const std::function<void(VkCommandBuffer)>& record) : context_(&context) {
    const gpu::Api& api = context.api();
    VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.queueFamilyIndex = context.queueFamily();
    api.CreateCommandPool(context.device(), &pool, nullptr, &pool_);
    VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = pool_;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    api.AllocateCommandBuffers(context.device(), &allocate, &commands_);
    const VkFenceCreateInfo fence = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO};
    api.CreateFence(context.device(), &fence, nullptr, &fence_);
    const VkCommandBufferBeginInfo begin = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    api.BeginCommandBuffer(commands_, &begin);
    record(commands_);
    api.EndCommandBuffer(commands_);
}

Recording::Recording(Recording&& other) noexcept
    : context_(other.context_), pool_(std::exchange(other.pool_, VK_NULL_HANDLE)), commands_(other.commands_),
      fence_(std::exchange(other.fence_, VK_NULL_HANDLE)), submitted_(std::exchange(other.submitted_, false)) {}

Recording::~Recording() {
    wait();
    if (!pool_)
        return;
    context_->api().DestroyFence(context_->device(), fence_, nullptr);
    context_->api().DestroyCommandPool(context_->device(), pool_, nullptr);
}

void Recording::submit() {
    VkCommandBufferSubmitInfo buffer = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
    buffer.commandBuffer = commands_;
    VkSubmitInfo2 submit = {VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
    submit.commandBufferInfoCount = 1;
    submit.pCommandBufferInfos = &buffer;
    ASSERT_EQ(context_->api().QueueSubmit2(context_->queue(), 1, &submit, fence_), VK_SUCCESS);
    submitted_ = true;
}

void Recording::wait() {
    if (submitted_)
        context_->api().WaitForFences(context_->device(), 1, &fence_, VK_TRUE, UINT64_MAX);
}

Snapshot::Snapshot(gpu::Context& context, uint32_t width, uint32_t height)
    : context_(context), width_(width), height_(height),
      buffer_(must(gpu::Buffer::create(context, {"test/snapshot", size_t{8} * width * height,
                                                 VK_BUFFER_USAGE_TRANSFER_DST_BIT, gpu::BufferHome::Readback}))) {}

void Snapshot::record(VkCommandBuffer commands, VkImage image) {
    constexpr VkImageLayout kLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    gpu::Image borrowed =
        gpu::Image::borrow(image, VK_NULL_HANDLE, {"test/source", VK_FORMAT_R16G16B16A16_SFLOAT, width_, height_},
                           {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_WRITE_BIT, 0, 0, kLayout});
    gpu::Frame frame(context_, commands);
    frame.copyToBuffer(borrowed, 0, 0, buffer_);
    frame.hand(borrowed, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, kLayout});
}

std::vector<uint16_t> Snapshot::texels() const {
    std::vector<uint16_t> out(buffer_.size() / sizeof(uint16_t));
    std::memcpy(out.data(), buffer_.mapped(), buffer_.size());
    return out;
}

} // namespace glint::test
