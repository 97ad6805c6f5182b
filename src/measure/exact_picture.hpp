// The exact picture of a scene in which everything seen is emission and every mirror perfect: then every right program
// must draw the same, whatever its light model (docs/truth.md).
#pragma once

#include "measure/ray_oracle.hpp"

#include <span>
#include <vector>

namespace glint::measure {

struct ExactPicture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<glm::vec3> radiance;       ///< linear, at pixel centres
    std::vector<glm::vec3> withoutMirrors; ///< the same with black mirrors
    std::vector<uint8_t> bounces;          ///< mirrors met before the end of the path; 0: no mirror
};

/// `worldToClip` is the renderer's own (reversed depth), so that pixel centres and the near plane mean the same. Black
/// background.
/// Errors: InvalidInput names the first material that is neither pure emission nor a perfect mirror.
Result<ExactPicture> exactPicture(const scene::Scene& scene, const scene::Pose& pose, const glm::mat4& worldToClip,
                                  uint32_t width, uint32_t height, uint32_t maxBounces = 16);

/// How far a picture is from the exact one, over the pixels that mirrors change in it.
struct MirrorError {
    uint64_t mirrorPixels = 0;    ///< mirrors change them
    uint64_t wrongPixels = 0;     ///< of these; a channel of the sRGB value is off by more than 24/255
    uint64_t oneBouncePixels = 0; ///< of mirrorPixels: one bounce shows all
    uint64_t oneBounceWrong = 0;
    /// By the bounces that a path takes to its end, from one on.
    struct ByBounces {
        uint64_t pixels = 0;
        uint64_t wrong = 0;
    };
    std::vector<ByBounces> byBounces;
    double share() const { return mirrorPixels ? double(wrongPixels) / double(mirrorPixels) : 0; }
    double oneBounceShare() const { return oneBouncePixels ? double(oneBounceWrong) / double(oneBouncePixels) : 0; }
};

/// `rgba`: linear radiance, four floats a pixel, of the exact picture's size.
MirrorError compareMirrors(const ExactPicture& exact, std::span<const float> rgba);

} // namespace glint::measure
