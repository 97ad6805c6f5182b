// GPU time per pass, from timestamps around it. The GPU copies the timestamps into mapped memory at the end of the
// frame, so neither recording nor reading the times waits.
#pragma once

#include "gpu/resources.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace glint::gpu {

struct PassTime {
    std::string name;
    double milliseconds = 0;
};

class Timers {
public:
    static Result<std::unique_ptr<Timers>> create(Context& context);
    ~Timers();
    Timers(const Timers&) = delete;
    Timers& operator=(const Timers&) = delete;

    /// Call first in a frame, outside rendering. This and the next three functions allocate nothing.
    void beginFrame(VkCommandBuffer commands);
    void begin(VkCommandBuffer commands, const char* name); ///< keeps the first 63 characters of the name
    void end(VkCommandBuffer commands);
    /// Call last in a frame, outside rendering; again if passes were added later (Frame::more).
    void endFrame(VkCommandBuffer commands);

    /// Returns the pass times of the newest frame that the GPU has finished, in recording order; empty before the
    /// first, or without timestamps.
    const std::vector<PassTime>& latest();

private:
    static constexpr uint32_t kMaxPasses = 128; ///< per frame; later passes are not timed
    static constexpr uint32_t kFrames = 4;      ///< frames in flight before results are overwritten
    static constexpr size_t kMarkOffset = 2 * kMaxPasses * sizeof(uint64_t);

    struct FrameSlot {
        VkQueryPool pool = VK_NULL_HANDLE;
        Buffer results; ///< the timestamps, then the mark of the frame they belong to
        std::array<std::array<char, 64>, kMaxPasses> names;
        uint32_t count = 0;
        uint32_t mark = 0; ///< of the frame recorded last: the frame number and, in the low byte, the number of passes
        bool pending = false;
    };

    explicit Timers(Context& context) : context_(context) {}
    void barrier(VkCommandBuffer commands, VkPipelineStageFlags2 from, VkAccessFlags2 written, VkPipelineStageFlags2 to,
                 VkAccessFlags2 used) const;
    void writeTimestamp(VkCommandBuffer commands, VkQueryPool pool, uint32_t query);
    void read(FrameSlot& slot);

    Context& context_;
    std::array<FrameSlot, kFrames> slots_;
    uint32_t frame_ = 0;
    bool open_ = false;
    std::vector<PassTime> latest_;
};

} // namespace glint::gpu
