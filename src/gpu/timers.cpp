#include "gpu/timers.hpp"

#include <atomic>
#include <cstring>

namespace glint::gpu {

Result<std::unique_ptr<Timers>> Timers::create(Context& context) {
    std::unique_ptr<Timers> timers(new Timers(context));
    if (context.timestampPeriodNs() == 0)
        return timers; // no pools: every call is a no-op
    for (FrameSlot& slot : timers->slots_) {
        VkQueryPoolCreateInfo info = {VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = 2 * kMaxPasses;
        if (context.api().CreateQueryPool(context.device(), &info, context.callbacks(), &slot.pool) != VK_SUCCESS)
            return makeError(ErrorCode::OutOfMemory, "the timestamp queries cannot be created");
        context.nameObject(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(slot.pool), "glint/timers");
        GLINT_TRY(results, Buffer::create(context, {"glint/timers", kMarkOffset + sizeof(uint32_t),
                                                    VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::Readback}));
        std::memset(results.mapped(), 0, results.size()); // frame marks start at 1
        slot.results = std::move(results);
    }
    return timers;
}

Timers::~Timers() {
    for (FrameSlot& slot : slots_)
        if (slot.pool)
            context_.api().DestroyQueryPool(context_.device(), slot.pool, context_.callbacks());
}

void Timers::beginFrame(VkCommandBuffer commands) {
    FrameSlot& slot = slots_[++frame_ % kFrames];
    if (!slot.pool)
        return;
    slot.count = 0;
    slot.pending = false;
    context_.api().CmdResetQueryPool(commands, slot.pool, 0, 2 * kMaxPasses);
}

void Timers::begin(VkCommandBuffer commands, const char* name) {
    FrameSlot& slot = slots_[frame_ % kFrames];
    open_ = slot.pool && slot.count < kMaxPasses;
    if (!open_)
        return;
    std::array<char, 64>& kept = slot.names[slot.count];
    std::strncpy(kept.data(), name, kept.size() - 1);
    kept.back() = 0;
    writeTimestamp(commands, slot.pool, 2 * slot.count++);
}

void Timers::end(VkCommandBuffer commands) {
    if (!open_)
        return;
    FrameSlot& slot = slots_[frame_ % kFrames];
    writeTimestamp(commands, slot.pool, 2 * slot.count - 1);
    open_ = false;
}

void Timers::endFrame(VkCommandBuffer commands) {
    FrameSlot& slot = slots_[frame_ % kFrames];
    if (!slot.pool || slot.count == 0)
        return;
    constexpr VkPipelineStageFlags2 kTransfer = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    constexpr VkAccessFlags2 kWrite = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    const Api& api = context_.api();
    slot.mark = frame_ << 8 | slot.count;
    slot.pending = true;
    barrier(commands, kTransfer, kWrite, kTransfer, kWrite); // orders this after the earlier frame in the slot
    api.CmdCopyQueryPoolResults(commands, slot.pool, 0, 2 * slot.count, slot.results.handle(), 0, sizeof(uint64_t),
                                VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT);
    barrier(commands, kTransfer, kWrite, kTransfer, kWrite); // the mark signals that the timestamps are present
    api.CmdUpdateBuffer(commands, slot.results.handle(), kMarkOffset, sizeof(slot.mark), &slot.mark);
    barrier(commands, kTransfer, kWrite, VK_PIPELINE_STAGE_2_HOST_BIT, VK_ACCESS_2_HOST_READ_BIT);
}

void Timers::barrier(VkCommandBuffer commands, VkPipelineStageFlags2 from, VkAccessFlags2 written,
                     VkPipelineStageFlags2 to, VkAccessFlags2 used) const {
    VkMemoryBarrier2 all = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
    all.srcStageMask = from;
    all.srcAccessMask = written;
    all.dstStageMask = to;
    all.dstAccessMask = used;
    VkDependencyInfo info = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
    info.memoryBarrierCount = 1;
    info.pMemoryBarriers = &all;
    context_.api().CmdPipelineBarrier2(commands, &info);
}

void Timers::writeTimestamp(VkCommandBuffer commands, VkQueryPool pool, uint32_t query) {
    // Mesa's llvmpipe queues a timestamp with the next triangles but runs dispatches at once: without a flush, a pass's
    // first timestamp is written after its dispatch. A barrier finishes all queued work, at no extra cost on a software
    // device.
    constexpr VkPipelineStageFlags2 kAll = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
    const auto finish = [&] {
        if (context_.info().software)
            barrier(commands, kAll, VK_ACCESS_2_MEMORY_WRITE_BIT, kAll,
                    VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT);
    };
    finish();
    context_.api().CmdWriteTimestamp2(commands, kAll, pool, query);
    finish();
}

void Timers::read(FrameSlot& slot) {
    auto* const bytes = static_cast<std::byte*>(slot.results.mapped());
    uint32_t& mark = *reinterpret_cast<uint32_t*>(bytes + kMarkOffset);
    if (std::atomic_ref(mark).load(std::memory_order_acquire) != slot.mark)
        return;
    std::array<uint64_t, 2 * kMaxPasses> ticks;
    std::memcpy(ticks.data(), bytes, 2 * slot.count * sizeof(uint64_t));
    latest_.resize(slot.count);
    for (size_t i = 0; i < slot.count; ++i) {
        latest_[i].name = slot.names[i].data();
        latest_[i].milliseconds =
            static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * context_.timestampPeriodNs() * 1e-6;
    }
    slot.pending = false;
}

const std::vector<PassTime>& Timers::latest() {
    // Oldest first, so that the newest finished frame remains.
    for (uint32_t i = 1; i <= kFrames; ++i)
        if (FrameSlot& slot = slots_[(frame_ + i) % kFrames]; slot.pending)
            read(slot);
    return latest_;
}

} // namespace glint::gpu
