// GPU time of each pass, by timestamps around it. Results come some frames later; asking never waits.
#pragma once

#include "gpu/context.hpp"

#include <array>
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

    /// Call first in a frame, outside rendering.
    void beginFrame(VkCommandBuffer commands);
    void begin(VkCommandBuffer commands, const std::string& name);
    void end(VkCommandBuffer commands);

    /// The newest frame that the GPU has finished, in order; empty before the first, or without timestamps.
    const std::vector<PassTime>& latest();

private:
    static constexpr uint32_t kMaxPasses = 128; ///< a frame; later ones go untimed
    static constexpr uint32_t kFrames = 4;      ///< in flight, before results are overwritten

    struct FrameSlot {
        VkQueryPool pool = VK_NULL_HANDLE;
        std::vector<std::string> names;
        bool pending = false;
    };

    explicit Timers(Context& context) : context_(context) {}
    void writeTimestamp(VkCommandBuffer commands, VkQueryPool pool, uint32_t query);
    bool resolve(FrameSlot& slot);

    Context& context_;
    std::array<FrameSlot, kFrames> slots_;
    uint32_t current_ = 0;
    bool open_ = false;
    std::vector<PassTime> latest_;
};

} // namespace glint::gpu
