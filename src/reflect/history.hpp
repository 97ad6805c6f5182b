// Images that a frame leaves to later frames. This class manages ping-pong images and images that are accumulated in
// place: when they are valid, and why not.
#pragma once

#include "reflect/stage.hpp"

#include <string_view>
#include <vector>

namespace glint::reflect {

/// The reason why a frame has no history.
enum class HistoryReset : uint8_t {
    None, ///< the frame has a history
    Off,  ///< the settings disable it
    First,
    Settings, ///< the settings changed
    View,     ///< the camera moved, its projection changed, or the host said so (View::cut)
    Asked,    ///< Reflections::restartAccumulation, or another scene
    NotLight, ///< the previous frame was not radiance: nothing was drawn, or debug colours
};
std::string_view textOf(HistoryReset reason);

/// An image of a history: all that is said about it, in one row.
struct HistoryImage {
    size_t index; ///< its place among the images that History::make gets
    const char* name;
    VkFormat format;
    uint32_t tile = 1;          ///< pixels of the frame on a side of the square that shares texels
    uint32_t texelsPerTile = 1; ///< side by side

    /// Its size for a frame of `width` x `height` pixels; one texel, which is only bound, unless it is `needed`.
    StageImage sized(uint32_t width, uint32_t height, bool needed = true) const {
        const auto tiles = [&](uint32_t pixels) { return (pixels + tile - 1) / tile; };
        return {name, format, needed ? texelsPerTile * tiles(width) : 1, needed ? tiles(height) : 1};
    }
};

class History {
public:
    /// How the previous frame is stored.
    enum class Kind : uint8_t {
        Turns,   ///< ping-pong images: `now` is written, `before` is read
        InPlace, ///< one set of images that each frame adds to: `before` is `now`, and empty after a reset
    };

    History(StageContext& stages, Kind kind) : stages_(stages), kind_(kind) {}

    /// Creates the images, or replaces them; replaced images are kept while in flight. The next frame is the first.
    /// Without `remembers`, ping-pong images are created only once. Errors: OutOfMemory.
    Result<void> make(std::span<const StageImage> images, bool remembers);
    /// Creates the second set of ping-pong images if missing. Errors: OutOfMemory.
    Result<void> remember();

    /// Gives the next frame no history, for this reason.
    void reset(HistoryReset reason);
    /// Begins a frame. Returns true if it has a history; otherwise `why` returns the reason. Call before the images are
    /// written.
    bool begin(gpu::Frame& frame, bool wanted);
    /// Invalidates the current frame's history for a further reason.
    void drop(HistoryReset reason) { why_ = reason; }
    /// Ends the frame. Its images become the history of the next frame if `reset` is None.
    void end(gpu::Frame& frame, HistoryReset reason = HistoryReset::None);

    bool valid() const { return why_ == HistoryReset::None; }
    HistoryReset why() const { return why_; }
    gpu::Image& now(const HistoryImage& image) { return now(image.index); }
    gpu::Image& before(const HistoryImage& image) { return before(image.index); }

    // For ping-pong images: a recorded frame may never be executed, which only the GPU knows. Each pair has a tag, the
    // number of the recording that wrote it. Readers of `before` compare the tag (lib/history.glsl).
    uint32_t expectedTag() const { return lastRecording_; }
    /// Copies the tag of `before` to `offset` of `target`.
    void copyTag(gpu::Frame& frame, gpu::Buffer& target, size_t offset);

private:
    struct Pair {
        gpu::Image turns[2];
    };

    gpu::Image& now(size_t image) { return images_[image].turns[turn_]; }
    gpu::Image& before(size_t image) { return images_[image].turns[kind_ == Kind::Turns ? turn_ ^ 1 : turn_]; }

    StageContext& stages_;
    Kind kind_;
    std::vector<StageImage> wanted_;
    std::vector<Pair> images_;
    gpu::Buffer tags_;
    gpu::Standing blank_; ///< the images to read have a layout, and contain nothing or a history
    uint32_t turn_ = 0;
    uint32_t lastRecording_ = 0;
    HistoryReset next_ = HistoryReset::First; ///< why the next frame has no history
    HistoryReset why_ = HistoryReset::First;
};

} // namespace glint::reflect
