#include "gpu/timers.hpp"

namespace glint::gpu {

Result<std::unique_ptr<Timers>> Timers::create(Context& context) {
    std::unique_ptr<Timers> timers(new Timers(context));
    if (context.timestampPeriodNs() == 0)
        return timers; // no pools: every call is a no-op
    for (FrameSlot& slot : timers->slots_) {
        VkQueryPoolCreateInfo info = {VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        info.queryType = VK_QUERY_TYPE_TIMESTAMP;
        info.queryCount = 2 * kMaxPasses;
        if (context.api().CreateQueryPool(context.device(), &info, nullptr, &slot.pool) != VK_SUCCESS)
            return makeError(ErrorCode::OutOfMemory, "the timestamp queries cannot be created");
        context.nameObject(VK_OBJECT_TYPE_QUERY_POOL, reinterpret_cast<uint64_t>(slot.pool), "glint/timers");
        slot.names.reserve(kMaxPasses);
    }
    return timers;
}

Timers::~Timers() {
    for (FrameSlot& slot : slots_)
        if (slot.pool)
            context_.api().DestroyQueryPool(context_.device(), slot.pool, nullptr);
}

void Timers::beginFrame(VkCommandBuffer commands) {
    current_ = (current_ + 1) % kFrames;
    FrameSlot& slot = slots_[current_];
    if (!slot.pool)
        return;
    if (slot.pending)
        resolve(slot); // the last chance before its queries are reset
    slot.names.clear();
    slot.pending = false;
    context_.api().CmdResetQueryPool(commands, slot.pool, 0, 2 * kMaxPasses);
}

void Timers::begin(VkCommandBuffer commands, const std::string& name) {
    FrameSlot& slot = slots_[current_];
    open_ = slot.pool && slot.names.size() < kMaxPasses;
    if (!open_)
        return;
    const auto query = static_cast<uint32_t>(2 * slot.names.size());
    slot.names.push_back(name);
    writeTimestamp(commands, slot.pool, query);
}

void Timers::end(VkCommandBuffer commands) {
    FrameSlot& slot = slots_[current_];
    if (!open_)
        return;
    const auto query = static_cast<uint32_t>(2 * slot.names.size() - 1);
    writeTimestamp(commands, slot.pool, query);
    slot.pending = true;
    open_ = false;
}

void Timers::writeTimestamp(VkCommandBuffer commands, VkQueryPool pool, uint32_t query) {
    // Mesa's llvmpipe queues a timestamp with the next triangles and runs dispatches at once: until something flushes,
    // a pass's first timestamp waits until after its dispatch. A barrier finishes all work there; it costs a software
    // device nothing that it would not do anyway.
    const auto finish = [&] {
        if (!context_.info().software)
            return;
        VkMemoryBarrier2 all = {VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
        all.srcStageMask = all.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
        all.srcAccessMask = VK_ACCESS_2_MEMORY_WRITE_BIT;
        all.dstAccessMask = VK_ACCESS_2_MEMORY_READ_BIT | VK_ACCESS_2_MEMORY_WRITE_BIT;
        VkDependencyInfo info = {VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
        info.memoryBarrierCount = 1;
        info.pMemoryBarriers = &all;
        context_.api().CmdPipelineBarrier2(commands, &info);
    };
    finish();
    context_.api().CmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool, query);
    finish();
}

bool Timers::resolve(FrameSlot& slot) {
    std::array<uint64_t, 2 * kMaxPasses> ticks = {};
    const auto count = static_cast<uint32_t>(2 * slot.names.size());
    if (context_.api().GetQueryPoolResults(context_.device(), slot.pool, 0, count, count * sizeof(uint64_t),
                                           ticks.data(), sizeof(uint64_t), VK_QUERY_RESULT_64_BIT) != VK_SUCCESS)
        return false;
    latest_.resize(slot.names.size());
    for (size_t i = 0; i < slot.names.size(); ++i) {
        latest_[i].name = slot.names[i];
        latest_[i].milliseconds =
            static_cast<double>(ticks[2 * i + 1] - ticks[2 * i]) * context_.timestampPeriodNs() * 1e-6;
    }
    slot.pending = false;
    return true;
}

const std::vector<PassTime>& Timers::latest() {
    // Oldest first, so that the newest finished frame is the one that stays.
    for (uint32_t i = 1; i <= kFrames; ++i)
        if (FrameSlot& slot = slots_[(current_ + i) % kFrames]; slot.pending)
            resolve(slot);
    return latest_;
}

} // namespace glint::gpu
