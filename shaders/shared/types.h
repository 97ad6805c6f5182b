// The types that C++ and GLSL share, so that a struct is written once. Blocks use `scalar` layout: a float3 has 12
// bytes in both languages.
#ifndef GLINT_SHARED_TYPES_H
#define GLINT_SHARED_TYPES_H

#ifdef __cplusplus

#include <glm/glm.hpp>

#include <cstdint>

#define GLINT_SHARED_BEGIN namespace glint::shared {
#define GLINT_SHARED_END }

namespace glint::shared {
using float2 = glm::vec2;
using float3 = glm::vec3;
using float4 = glm::vec4;
using float4x4 = glm::mat4;
using int2 = glm::ivec2;
using int4 = glm::ivec4;
using uint = uint32_t;
using uint2 = glm::uvec2;
using uint3 = glm::uvec3;
using uint4 = glm::uvec4;
} // namespace glint::shared

#define GLINT_CONSTANT(type, name, value) inline constexpr type name = value

#else

#define GLINT_SHARED_BEGIN
#define GLINT_SHARED_END

#define float2 vec2
#define float3 vec3
#define float4 vec4
#define float4x4 mat4
#define int2 ivec2
#define int4 ivec4
#define uint2 uvec2
#define uint3 uvec3
#define uint4 uvec4

#define GLINT_CONSTANT(type, name, value) const type name = value

#endif
#endif
