// The pictures that `--view` chooses from: the frame itself and what the reflections know about it.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace glint::render {

/// What a view's values are, which decides how they become visible.
enum class ViewKind {
    Radiance,  ///< linear and scene-referred: exposed and tone-mapped
    Fraction,  ///< [0, 1], or colours for people: as they are
    Direction, ///< unit vectors: (x + 1) / 2
    Distance,  ///< metres, 0: none: white near, black far
    Count,     ///< whole numbers: from blue to red, on a logarithmic scale
};

struct ViewInfo {
    std::string_view name;
    ViewKind kind = ViewKind::Radiance;
    std::string_view channels; ///< those that mean something, named as in an EXR file: "RGBA", "XYZ", "Z"
    std::string_view meaning;
};

/// "composite", the frame itself, is the first.
std::span<const ViewInfo> viewList();

/// Errors: InvalidArgument with the nearest name and all of them.
Result<const ViewInfo*> findView(std::string_view name);

/// Makes RGB bytes of a view's RGBA values, for every kind but Radiance, which the display pass shows. NaN is magenta.
std::vector<uint8_t> displayBytes(ViewKind kind, std::span<const float> rgba);

} // namespace glint::render
