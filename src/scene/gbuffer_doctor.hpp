// Compares the layers of a G-buffer with each other and with the camera, and names declarations that contradict them:
// "normals agree with space view, not world as declared".
//
// Depth and camera determine a surface's normal. The given normals agree with it only if depth, normals, axes, rows and
// camera all mean what the mapping declares, so each other meaning is tried, and the one that agrees best is named.
#pragma once

#include "scene/gbuffer_pixels.hpp"

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
