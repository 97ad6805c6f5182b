// SPDX-License-Identifier: MIT
// The host's images that Glint writes its results to.
#pragma once

#include "glint/gbuffer.hpp"

namespace glint {

/// Images of the host for the results of Reflections::record. By default the result is an image of Glint's.
///
/// Each has the size of the Reflections, format VK_FORMAT_R16G16B16A16_SFLOAT, one sample, a 2D view of one mip, and
/// the usage STORAGE and SAMPLED. It is in the stated layout when Reflections records anything, and is
/// left in that layout. It must not be an image of the G-buffer.
struct Outputs {
    /// The image with reflections. With screen.colorSource previous the next frame reads it again, so its reflections
    /// show what the host draws over the image.
    HostImage composite;
    /// Reflections alone, for a host with a composite of its own: rgb is the reflected radiance times its weight,
    /// linear and without the material's response; a is the weight, the fraction of the host's fallback that the
    /// radiance replaces. Without `composite`, Glint makes no image with reflections.
    HostImage reflection;
};

} // namespace glint
