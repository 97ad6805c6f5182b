// Keeps JPEG files away from stb_image that would make it write out of bounds.
#pragma once

#include <cstdint>
#include <span>

namespace glint::scene {

/// Whether every Huffman table of the file has at most 256 codes. stb_image 2.27, which Debian 12 packages, trusts
/// that and writes beyond its tables otherwise (found by tests/fuzz/gltf_fuzz.cpp). The walk over the segments resumes
/// after damage in the same way as stb_image's, so that it sees every table which stb_image will see.
/// Based on: ITU-T T.81, annex B.
bool jpegTablesFit(std::span<const uint8_t> bytes);

} // namespace glint::scene
