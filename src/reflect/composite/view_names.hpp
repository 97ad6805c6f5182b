// The debug views that the library offers, by name.
#pragma once

#include "shared/views.h"

#include <array>
#include <string_view>

namespace glint::reflect {

#define GLINT_VIEW_NAME(name, kind, channels, meaning, value) std::string_view(#name),
inline constexpr auto kViewNames = std::to_array({GLINT_VIEWS(GLINT_VIEW_NAME)});
#undef GLINT_VIEW_NAME

} // namespace glint::reflect
