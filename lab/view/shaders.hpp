// The viewer's own shaders, embedded in its library (cmake/GlintShaders.cmake).
#pragma once

#include "gpu/shader.hpp"

namespace glint::gpu::shaders {
std::span<const EmbeddedShader> view();
} // namespace glint::gpu::shaders
