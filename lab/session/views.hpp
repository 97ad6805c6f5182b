// The views that `--view` selects from: the frame itself and intermediate images of the reflections.
#pragma once

#include "base/result.hpp"
#include "lab/renderer/gbuffer.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::gpu {
class Image;
}

namespace glint::render {

/// The kind of a view's values, which determines how they are displayed.
enum class ViewKind {
    Radiance,  ///< linear and scene-referred: exposed and tone-mapped
    Fraction,  ///< [0, 1], or debug colours: displayed unchanged
    Direction, ///< unit vectors: (x + 1) / 2
    Distance,  ///< metres, 0: none: white is near, black is far
    Count,     ///< integers: blue to red, on a logarithmic scale
    Motion,    ///< signed, small: grey is none, the root shows pixels as well as large movements
};

struct ViewInfo {
    std::string_view name;
    ViewKind kind = ViewKind::Radiance;
    std::string_view channels; ///< the meaningful channels, named as in an EXR file: "RGBA", "XYZ", "Z"
    std::string_view meaning;
    std::string_view value = {};          ///< of the library's views: the shader's expression (shared/views.h)
    gpu::Image GBuffer::*drawn = nullptr; ///< the view is this image of our renderer
};

/// The frame and our renderer's images, then the library's views. The first is "composite", the frame itself.
std::span<const ViewInfo> viewList();

/// Returns docs/views.md.
std::string viewsPage();

/// A name with a colon is an image that a pass wrote, "trace/hiz:radianceWeight"; the frame checks that it exists.
/// Errors: InvalidArgument with the nearest name and all names.
Result<const ViewInfo*> findView(std::string_view name);

/// Converts a view's RGBA values to RGB bytes, for every kind except Radiance, which the display pass shows. NaN is
/// magenta.
std::vector<uint8_t> displayBytes(ViewKind kind, std::span<const float> rgba);

} // namespace glint::render
