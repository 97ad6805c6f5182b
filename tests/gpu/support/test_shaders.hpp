// The tests' own shaders: tests/gpu/shaders, a set beside the library's.
#pragma once

#include "gpu/shader.hpp"

namespace glint::gpu::shaders {
std::span<const EmbeddedShader> test();
} // namespace glint::gpu::shaders
