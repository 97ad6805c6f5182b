#include "lab/scene/images/image_file.hpp"

#include "base/file.hpp"

namespace glint::scene {

static constexpr uint64_t kMaxPixels = uint64_t(kMaxImageSide) * kMaxImageSide / 2; // 1.6 GB as floats
static constexpr size_t kLongestFile = size_t(1) << 30;                             // bytes

Result<HdrImage> readHdrImage(const std::string& path) {
    const Result<std::string> file = readFile(path, kLongestFile);
    if (!file)
        return file.error();
    const std::string_view bytes = *file; // GCC 12 warns about uninitialized use of a moved string
    if (bytes.empty())
        return invalidInput("{}: the file is empty", path);
    if (bytes.starts_with("#?"))
        return decodeRadiance(bytes, path, kMaxPixels);
    if (bytes.starts_with("\x76\x2f\x31\x01"))
        return decodeExr(bytes, path, kMaxPixels);
    return invalidInput("{}: neither a Radiance (.hdr) nor an OpenEXR (.exr) picture", path);
}

} // namespace glint::scene
