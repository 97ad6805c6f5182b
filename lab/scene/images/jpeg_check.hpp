// Rejects JPEG files that would cause stb_image to write out of bounds.
#pragma once

#include <cstdint>
#include <span>

namespace glint::scene {

/// True if every Huffman table of the file has at most 256 codes. stb_image 2.27, which Debian 12 packages, does not
/// check that and otherwise writes beyond its tables (found by lab/tests/fuzz/gltf_fuzz.cpp). After damage, this scan
/// of the segments resumes in the same way as stb_image, so that it sees every table that stb_image will see. Based on:
/// ITU-T T.81, annex B.
bool jpegTablesFit(std::span<const uint8_t> bytes);

} // namespace glint::scene
