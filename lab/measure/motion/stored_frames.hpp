// Frames of a sequence that another program made, read from OpenEXR files instead of being rendered: the reflections of
// another denoiser, to be measured as our own are.
#pragma once

#include "base/result.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace glint::measure {

/// A frame with one seed; four floats a pixel, rows from the top, finite.
struct StoredFrame {
    std::vector<float> reflection; ///< reflected radiance times weight, before the material's response
    std::vector<float> composite;  ///< the frame; empty if the files have none
};

/// A file's layer `reflection` (R, G, B) is the reflection, and its R, G, B outside of layers is the composite. In a
/// file without that layer, R, G, B is the reflection.
class StoredFrames {
public:
    /// `files`: by seed (one or two), then by frame; as many of each. Reads the first frame of each seed, whose layers
    /// and size all others must have. Errors: NotFound names the first file that is missing; InvalidInput.
    static Result<StoredFrames> open(std::vector<std::vector<std::string>> files);

    size_t seeds() const { return files_.size(); }
    size_t frames() const { return files_.front().size(); }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    bool hasComposite() const { return hasComposite_; }

    /// Errors name the file: those of OpenEXR, another size, a missing layer, a value that is no finite number.
    Result<StoredFrame> read(size_t seed, size_t frame) const;

private:
    std::vector<std::vector<std::string>> files_;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    bool hasLayer_ = false; ///< layer `reflection`
    bool hasComposite_ = false;
};

} // namespace glint::measure
