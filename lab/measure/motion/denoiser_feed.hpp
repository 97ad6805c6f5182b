// What a denoiser reads of a frame, in plain images: the noisy answers of screen and rays before our own denoiser, and
// the surfaces. So that another denoiser can be compared with ours on the same noise.
#pragma once

#include "lab/job/render_job.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::measure {

/// An image of the feed, named as in an EXR file.
struct FeedLayer {
    std::string_view name;
    std::string_view channels; ///< "RGBA", "XY", "Z": one letter each
    bool half = false;         ///< its values are half floats already
    std::string_view unit;
    std::string_view meaning;
};

std::span<const FeedLayer> feedLayers();

/// Names of the views that the feed of frames with these settings is made of.
std::vector<std::string> feedViews(const Settings& settings);

/// `views`  those of feedViews, of one frame with denoising
/// Returns four floats a pixel for each of feedLayers. Pixels that sent no ray have 0 in `noisy` and `hitDistance`.
std::vector<std::vector<float>> feedPixels(std::span<const render::RenderedView> views);

/// The distance to the end of a pixel's ray from image "denoise/gather:sentRay", which has the bits of 1 / distance as
/// an integer. `bits`: that integer as a view shows it, as a float; thereby it has 24 bits, and the distance is right
/// to 2e-5 of its value. 0 if the ray hit nothing, or if none was sent.
float sentDistance(float bits);

} // namespace glint::measure
