// Accessors: typed arrays over buffer views, in any of glTF's component types, strided, normalized, sparse or absent.
// Based on: glTF 2.0 specification, section 3.6.2, "Accessors".
#pragma once

#include "lab/scene/gltf/document.hpp"

#include <span>
#include <vector>

namespace glint::scene::gltf {

/// Checks the header of every accessor, and that its bytes lie inside its view.
void readAccessors(Document& document);

uint32_t componentBytes(ComponentType type);
/// Returns the bytes of one tightly packed element; columns of matrices begin at multiples of four bytes.
uint32_t elementBytes(ComponentType type, const ElementShape& shape);
std::string shapeName(const ElementShape& shape);

/// Returns all components as floats, element after element; normalized integers become [0, 1] or [-1, 1]. Empty after
/// an error in the file; otherwise count * components long.
std::vector<float> readFloats(Document& document, const Accessor& accessor);
/// As above for data from another source (Draco): tightly packed elements in the accessor's component type.
std::vector<float> readFloats(Document& document, const Accessor& accessor, std::span<const uint8_t> packed);

/// Returns components as unsigned integers: indices and joints. Other component types are an error.
std::vector<uint32_t> readIntegers(Document& document, const Accessor& accessor);
std::vector<uint32_t> readIntegers(Document& document, const Accessor& accessor, std::span<const uint8_t> packed);

/// Returns the accessor at `key`, which must have one of `shapes`; null if absent or after an error in the file.
const Accessor* findAccessor(Document& document, const JsonObject& object, const char* key,
                             std::initializer_list<ElementShape> shapes);

inline constexpr ElementShape kScalar{1, 1};
inline constexpr ElementShape kVec2{2, 1};
inline constexpr ElementShape kVec3{3, 1};
inline constexpr ElementShape kVec4{4, 1};
inline constexpr ElementShape kMat4{4, 4};

} // namespace glint::scene::gltf
