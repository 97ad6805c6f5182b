// Command buffers as a host uses them: several frames in flight, some submitted late, some never.
#pragma once

#include "gpu/support/gpu_test.hpp"

#include <functional>
#include <vector>

namespace glint::test {

/// One recorded command buffer, with a fence of its own.
class Recording {
public:
    Recording(gpu::Context& context, const std::function<void(VkCommandBuffer)>& record);
    ~Recording();
    Recording(Recording&& other) noexcept;
    Recording& operator=(Recording&&) = delete;

    void submit(); ///< once, without waiting
    void wait();   ///< for the submitted work

private:
    gpu::Context* context_;
    VkCommandPool pool_ = VK_NULL_HANDLE;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    VkFence fence_ = VK_NULL_HANDLE;
    bool submitted_ = false;
};

/// A copy of an image, recorded after the commands that draw it, to be read after they ran.
class Snapshot {
public:
    /// For an RGBA16F image in SHADER_READ_ONLY_OPTIMAL.
    Snapshot(gpu::Context& context, uint32_t width, uint32_t height);
    void record(VkCommandBuffer commands, VkImage image);
    std::vector<uint16_t> texels() const;

private:
    gpu::Context& context_;
    uint32_t width_, height_;
    gpu::Buffer buffer_;
};

} // namespace glint::test
