// URIs in glTF: decodes data URIs, and converts relative URIs to file names for the resolver. Based on: RFC 3986
// (percent-encoding), RFC 2397 (data URIs), RFC 4648 (base64).
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace glint::scene::gltf {

bool isDataUri(std::string_view uri);

/// Errors: InvalidInput without the file's name, which the caller adds.
Result<std::vector<uint8_t>> decodeDataUri(std::string_view uri);

/// "Box%20With%20Spaces.bin" -> "Box With Spaces.bin". A lone % is kept, as names with spaces or percents are often
/// written unencoded. Errors: InvalidInput for schemes and absolute paths, as a model may only read files beside it.
Result<std::string> decodeRelativeUri(std::string_view uri);

} // namespace glint::scene::gltf
