// Converts a host's camera and conventions once to the constants that every pass reads.
#pragma once

#include "glint/gbuffer.hpp"
#include "glint/view.hpp"
#include "shared/frame_constants.h"

namespace glint::reflect {

/// Fills everything in FrameConstants that follows from camera, conventions and image size. The frame fills in the
/// environment and which images are present.
shared::FrameConstants makeFrameConstants(const View& view, const Conventions& conventions, uint32_t width,
                                          uint32_t height);

} // namespace glint::reflect
