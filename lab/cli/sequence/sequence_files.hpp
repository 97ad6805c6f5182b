// The files of `glint sequence -o`: numbered frames, and a video of them.
#pragma once

#include "lab/cli/render/render_output.hpp"
#include "lab/measure/motion/sequence.hpp"

#include <optional>
#include <string>

namespace glint::cli {

/// "out/frame_%04d.png": a path with the number of the frame in it.
class FramePattern {
public:
    /// Errors: InvalidArgument, naming `-o`, if `text` has no %d or %0Nd, or more than one %, or ends in neither .png
    /// nor .exr.
    static Result<FramePattern> parse(const std::string& text);

    PictureKind kind() const { return kind_; }
    std::string path(uint32_t frame) const;
    std::string folder() const;
    /// The same name in a folder of that one.
    FramePattern inFolder(const std::string& name) const;
    /// "out/frame.mp4".
    std::string video() const;
    const std::string& text() const { return text_; } ///< as programs with printf's numbers read it

private:
    std::string text_;
    size_t numberAt_ = 0;   ///< of the %
    size_t numberSize_ = 0; ///< characters of %d or %0Nd
    int digits_ = 0;        ///< at least so many
    PictureKind kind_ = PictureKind::Png;
};

/// Returns `text` with its %d or %0Nd replaced by a frame's number; unchanged if it has none or several.
std::string numberedPath(const std::string& text, uint32_t frame);

/// PNG: the composite as displayed. EXR: the composite, and the reflected radiance as layer "reflection". Errors: Io.
Result<void> writeFrame(const std::string& path, PictureKind kind, const measure::SequenceFrame& frame);

/// Makes a video of PNG frames with `program`. Errors: NotFound if there is no such program; Io with what it said.
Result<void> writeVideo(const FramePattern& frames, double fps, const std::string& program = "ffmpeg");

} // namespace glint::cli
