// Compares the layers of a G-buffer file with each other and with the camera, by the rules of check/rules.hpp.
#pragma once

#include "lab/gbuffer_files/gbuffer_pixels.hpp"

#include <string>
#include <vector>

namespace glint::scene {

struct GBufferHealth {
    double normalsAgree = 0; ///< share of tested pixels whose normal is within 10 degrees of depth's, as declared
    uint64_t tested = 0;     ///< pixels
    std::vector<std::string> findings; ///< one line each; empty: nothing contradicts the declarations
};

/// Tests some 20000 pixels of each layer. Finds nothing in an image without a flat or smooth surface, and cannot tell
/// meanings apart that are equal in this image (view and world normals of a camera that is not rotated).
///
/// `previous`  null, or the camera of the frame before, which motion is compared with
GBufferHealth examine(const GBufferLayers& layers, const GBufferMapping& mapping, const Camera& camera,
                      const Camera* previous = nullptr);

} // namespace glint::scene
