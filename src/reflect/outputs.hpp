// The frame's results: the image with reflections and the reflections alone, in the host's images or in Glint's, and a
// copy of the previous frame's image for hits to take colours from.
#pragma once

#include "glint/outputs.hpp"
#include "reflect/stage.hpp"

namespace glint::reflect {

class OutputImages {
public:
    explicit OutputImages(StageContext& stages) : stages_(stages) {}

    /// Creates Glint's own image if the host provides none. Errors: OutOfMemory; then the old images stay.
    Result<void> set(const Outputs& outputs);
    /// Creates the copy of the previous image. Errors: OutOfMemory.
    Result<void> makePrevious();
    const Outputs& stated() const { return stated_; }

    /// Resets the host's images to the state that the host declares.
    void lend();
    /// Returns the host's images to their layouts.
    void giveBack(gpu::Frame& frame);
    /// As giveBack, and makes Glint's own image ready for sampling.
    void handOut(gpu::Frame& frame);
    /// Keeps the previous frame's image, with what the host drew over it. A copy, so that the image with reflections is
    /// the same one in every frame; by a dispatch, because a GPU took four times as long for vkCmdCopyImage
    /// (lab/notes/gpu.md).
    void remember(gpu::Frame& frame);

    gpu::Image& composite() { return hosts_.composite ? hosts_.composite : own_; }
    /// The host's image for the reflections alone; null without.
    gpu::Image* reflection() { return hosts_.reflection ? &hosts_.reflection : nullptr; }
    gpu::Image& previous() { return previous_; }
    /// What `record` returns.
    HostImage result() const;

private:
    struct Borrowed {
        gpu::Image composite;
        gpu::Image reflection;
    };

    StageContext& stages_;
    Outputs stated_;
    Borrowed hosts_;
    gpu::Image own_;      ///< RGBA16F; absent if the host has images of its own
    gpu::Image previous_; ///< RGBA16F; absent until settings need it
    gpu::Pipeline copy_;  ///< into previous_
};

} // namespace glint::reflect
