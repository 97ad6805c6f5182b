// The tests' own shaders: tests/gpu/shaders, a separate set from the library's.
#pragma once

#include "gpu/shader.hpp"

namespace glint::gpu::shaders {
std::span<const EmbeddedShader> test();
} // namespace glint::gpu::shaders
