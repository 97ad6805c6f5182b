// The constants that every pass of a frame reads, and their buffer: camera, conventions, which inputs are present, and
// the settings in force.
#pragma once

#include "reflect/history.hpp"
#include "reflect/host.hpp"
#include "shared/frame_constants.h"
#include "shared/settings_constants.h"

namespace glint::reflect {

/// The buffer: frame/frame_block.glsl.
struct FrameBlockValues {
    shared::FrameConstants constants = {};
    shared::SettingsConstants settings = {};
};

class FrameBlock {
public:
    static Result<FrameBlock> create(StageContext& stages);

    /// Begins a frame with this camera.
    void begin(const View& view, const Host& host);
    bool sameView() const { return sameView_; }             ///< same view as the previous frame
    bool sameProjection() const { return sameProjection_; } ///< perspective or orthographic, as in the previous frame

    /// Writes the buffer. `traced`: size in traced pixels. `previous`: the previous frame's image.
    void record(gpu::Frame& frame, const Host& host, const shared::SettingsConstants& resolved, glm::uvec2 traced,
                History& previous);

    gpu::Buffer& buffer() { return buffer_; }
    const shared::FrameConstants& values() const { return values_.constants; }
    const FrameBlockValues& whole() const { return values_; } ///< without what the GPU writes

private:
    explicit FrameBlock(StageContext& stages) : stages_(&stages) {}

    StageContext* stages_;
    gpu::Buffer buffer_;
    FrameBlockValues values_;
    shared::FrameConstants before_ = {}; ///< of the previous frame
    bool gammaBefore_ = false;           ///< the previous image is sRGB-encoded
    bool sameView_ = false;
    bool sameProjection_ = false;
};

} // namespace glint::reflect
