// The exact picture of a scene in which every visible surface is emission or a perfect mirror: every correct renderer
// must produce it, whatever its light model (docs/truth.md).
#pragma once

#include "lab/measure/truth/ray_oracle.hpp"

#include <span>
#include <vector>

namespace glint::measure {

struct ExactPicture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> radiance;       ///< linear, at pixel centres
    std::vector<glm::vec3> withoutMirrors; ///< as `radiance`, with black mirrors
    std::vector<uint8_t> bounces;          ///< mirrors hit before the end of the path; 0: no mirror
    /// For paths of one bounce that end on a surface: what the camera's picture without mirrors shows at the path's
    /// end, in the pixel into which it falls; black where the end is hidden or outside of the picture, and for other
    /// paths. Screen space cannot do better for a single ray, except by guessing what the picture does not show.
    std::vector<glm::vec3> readInFrame;
    std::vector<uint8_t> endSeen; ///< 1 where the camera sees the end of such a path
};

/// `worldToClip` is the renderer's own matrix (reversed depth), so that pixel centres and the near plane agree. The
/// background is black. Errors: InvalidInput names the first material that is neither pure emission nor a perfect
/// mirror.
Result<ExactPicture> exactPicture(const scene::Scene& scene, const scene::Pose& pose, const glm::mat4& worldToClip,
                                  uint32_t width, uint32_t height, uint32_t maxBounces = 16);

/// The error of an image against the exact one, over the pixels that mirrors change in it.
struct MirrorError {
    uint64_t mirrorPixels = 0;    ///< pixels that mirrors change
    uint64_t wrongPixels = 0;     ///< of mirrorPixels: a channel of the sRGB value is off by more than 24/255
    uint64_t oneBouncePixels = 0; ///< of mirrorPixels: one bounce reaches the end of the path
    uint64_t oneBounceWrong = 0;
    uint64_t oneBounceWrongInFrame = 0; ///< of oneBouncePixels: ExactPicture::readInFrame is wrong in the same sense
    uint64_t oneBounceUnseen = 0;       ///< of oneBounceWrongInFrame: the end of the path is hidden or off screen
    /// By the number of bounces of a path, from one on.
    struct ByBounces {
        uint64_t pixels = 0;
        uint64_t wrong = 0;
    };
    std::vector<ByBounces> byBounces;
    double share() const { return mirrorPixels ? double(wrongPixels) / double(mirrorPixels) : 0; }
    double oneBounceShare() const { return oneBouncePixels ? double(oneBounceWrong) / double(oneBouncePixels) : 0; }
    double inFrameShare() const {
        return oneBouncePixels ? double(oneBounceWrongInFrame) / double(oneBouncePixels) : 0;
    }
    double unseenShare() const { return oneBouncePixels ? double(oneBounceUnseen) / double(oneBouncePixels) : 0; }
};

/// `rgba`: linear radiance, four floats per pixel, of the exact picture's size.
MirrorError compareMirrors(const ExactPicture& exact, std::span<const float> rgba);

} // namespace glint::measure
