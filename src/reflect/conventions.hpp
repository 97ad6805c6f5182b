// A host's camera and conventions, converted once into the constants that every pass reads.
#pragma once

#include "glint/gbuffer.hpp"
#include "glint/view.hpp"
#include "shared/frame_constants.h"

namespace glint::reflect {

/// Everything of FrameConstants that follows from camera, conventions and picture size; the environment and the
/// presence of images are filled in by the frame.
shared::FrameConstants makeFrameConstants(const View& view, const Conventions& conventions, uint32_t width,
                                          uint32_t height);

} // namespace glint::reflect
