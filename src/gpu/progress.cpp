#include "gpu/progress.hpp"

#include "gpu/pass.hpp"

#include <algorithm>
#include <atomic>
#include <cstring>

namespace glint::gpu {

Result<Progress> Progress::create(Context& context, const char* name, uint32_t framesInFlight) {
    GLINT_TRY(marks, Buffer::create(context, {name, kKept * sizeof(uint32_t), VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                              BufferHome::Readback}));
    std::memset(marks.mapped(), 0, marks.size()); // recording numbers start at 1
    Progress progress;
    progress.marks_ = std::move(marks);
    progress.framesInFlight_ = framesInFlight;
    return progress;
}

void Progress::begin(uint64_t frame) {
    frame_ = std::max(frame_, frame);
    ++recording_;
    frames_[recording_ % kKept] = frame_;
}

void Progress::end(Frame& frame) {
    frame.mark(marks_, recording_, recording_ % kKept * sizeof(uint32_t));
}

bool Progress::isExecuted(uint32_t recording) const {
    const uint32_t slot = recording % kKept;
    if (recording == 0 || recording + kKept <= recording_ || frames_[slot] + framesInFlight_ > frame_)
        return false;
    uint32_t& mark = static_cast<uint32_t*>(marks_.mapped())[slot];
    return std::atomic_ref(mark).load(std::memory_order_acquire) == recording;
}

bool Standing::isNeeded(const Progress& progress) {
    const auto newest = std::min<uint32_t>(count_, static_cast<uint32_t>(recordings_.size()));
    done_ = done_ || std::any_of(recordings_.begin(), recordings_.begin() + newest,
                                 [&](uint32_t recording) { return progress.isExecuted(recording); });
    return !done_;
}

void Standing::recorded(const Progress& progress) {
    recordings_[count_++ % recordings_.size()] = progress.recording();
}

} // namespace glint::gpu
