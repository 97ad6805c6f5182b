// The channels of an OpenEXR file as planes of floats, by name: what other renderers write beside their pictures.
#pragma once

#include "base/result.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint::scene {

/// Maximum number of parts, and of channels of one part.
constexpr int kMaxExrParts = 64;
constexpr int kMaxExrChannels = 256;

/// A file with one or several parts; scanlines or tiles (level 0); any compression that OpenEXR knows; half, float or
/// uint. Deep parts have no channels here: `deepParts` counts them. In a file with several parts a channel's name
/// begins with that of its part.
class ExrChannels {
public:
    /// Errors name the file: NotFound, Io; InvalidInput as decode.
    static Result<ExrChannels> open(const std::string& path);
    /// `name` is used in error messages. Errors: InvalidInput for another format, a damaged or truncated file, more
    /// than `maxPixels`, or parts of different sizes.
    static Result<ExrChannels> decode(std::string bytes, std::string name, uint64_t maxPixels);

    const std::string& name() const { return name_; }
    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    const std::vector<std::string>& names() const { return names_; } ///< unique, "ViewLayer.Depth.Z"
    int deepParts() const { return deepParts_; }

    /// Returns a plane for each of the given indices of names(): width * height floats, rows from the top. Values are
    /// as stored: NaN and infinity may occur. Errors: InvalidInput for damaged pixels and subsampled channels.
    Result<std::vector<std::vector<float>>> read(std::span<const size_t> channels) const;

private:
    struct Place {
        int part = 0;
        std::string channel; ///< name inside the part
    };

    Result<void> readHeaders(uint64_t maxPixels);
    Result<void> readPart(int part, std::span<const size_t> channels, std::vector<std::vector<float>>& planes) const;

    std::string bytes_;
    std::string name_;
    uint32_t width_ = 0;
    uint32_t height_ = 0;
    std::vector<std::string> names_;
    std::vector<Place> places_; ///< of each name
    int deepParts_ = 0;
};

} // namespace glint::scene
