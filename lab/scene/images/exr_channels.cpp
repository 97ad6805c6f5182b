// The OpenEXR library throws; no exception leaves this file. Every header is checked before the library allocates
// memory for its pixels.
#include "lab/scene/images/exr_channels.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/scene/images/exr_stream.hpp"
#include "lab/scene/images/image_file.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>
#include <ImfPartType.h>
#include <ImfTileDescription.h>
#include <ImfVersion.h>

#include <algorithm>
#include <exception>

namespace glint::scene {
namespace {

constexpr size_t kLongestExrFile = size_t{4} << 30; ///< bytes
constexpr uint64_t kMaxExrPixels = uint64_t{kMaxImageSide} * kMaxImageSide / 2;
constexpr uint64_t kMaxExrFloats = uint64_t{1} << 30; ///< read at once: 4 GiB

Error damaged(const std::string& name, const std::exception& exception) {
    return invalidInput("{}: OpenEXR: {}", name, printable(exception.what(), 200));
}

bool isDeep(const Imf::Header& header, int version) {
    return Imf::isNonImage(version) || (header.hasType() && Imf::isDeepData(header.type()));
}

bool equal(const Imath::Box2i& a, const Imath::Box2i& b) {
    return a.min.x == b.min.x && a.min.y == b.min.y && a.max.x == b.max.x && a.max.y == b.max.y;
}

/// The image is the display window, which is what the camera sees. A cropped or larger data window would shift it.
Result<void> checkWindow(const Imf::Header& header, const std::string& name, uint64_t maxPixels) {
    const Imath::Box2i& window = header.dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1;
    const int64_t height = int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1)
        return invalidInput("{}: the picture has no pixels", name);
    if (width > kMaxImageSide || height > kMaxImageSide || uint64_t(width) * uint64_t(height) > maxPixels)
        return invalidInput("{}: {} x {} pixels are too many, at most {} a side and {} in all are read", name, width,
                            height, kMaxImageSide, maxPixels);
    const Imath::Box2i& display = header.displayWindow();
    if (!equal(window, display))
        return invalidInput("{}: its data window ({}, {} to {}, {}) is not its display window ({}, {} to {}, {}): "
                            "render without a crop region or overscan",
                            name, window.min.x, window.min.y, window.max.x, window.max.y, display.min.x, display.min.y,
                            display.max.x, display.max.y);
    if (header.hasTileDescription()) {
        const Imf::TileDescription& tiles = header.tileDescription();
        if (tiles.xSize < 1 || tiles.ySize < 1 || tiles.xSize > kMaxImageSide || tiles.ySize > kMaxImageSide)
            return invalidInput("{}: tiles of {} x {} pixels, at most {} a side are read", name, tiles.xSize,
                                tiles.ySize, kMaxImageSide);
    }
    return {};
}

/// Returns the headers in the file's order, as the library itself parses them.
Result<std::vector<Imf::Header>> parseHeaders(std::string_view bytes, const std::string& name, int& version) {
    ExrStream stream(bytes, name);
    char start[8]; // magic number, version and flags
    stream.read(start, sizeof start);
    std::memcpy(&version, start + 4, sizeof version);
    std::vector<Imf::Header> headers;
    for (;;) {
        Imf::Header header;
        header.readFrom(stream, version);
        if (header.readsNothing()) // the empty header that ends a list of parts
            break;
        headers.push_back(std::move(header));
        if (!Imf::isMultiPart(version))
            break;
        if (headers.size() > size_t{kMaxExrParts})
            return invalidInput("{}: more than {} parts", name, kMaxExrParts);
    }
    if (headers.empty())
        return invalidInput("{}: the file has no parts", name);
    return headers;
}

/// "ViewLayer.Depth" and "Z" become "ViewLayer.Depth.Z"; a channel that bears its part's name keeps it once.
std::string fullName(const std::string& part, const std::string& channel) {
    return part.empty() || channel.starts_with(part + ".") ? channel : part + "." + channel;
}

} // namespace

Result<ExrChannels> ExrChannels::open(const std::string& path) {
    GLINT_TRY(bytes, readFile(path, kLongestExrFile));
    return decode(std::move(bytes), printable(path), kMaxExrPixels);
}

Result<ExrChannels> ExrChannels::decode(std::string bytes, std::string name, uint64_t maxPixels) {
    ExrChannels file;
    file.bytes_ = std::move(bytes);
    file.name_ = std::move(name);
    if (!std::string_view(file.bytes_).starts_with("\x76\x2f\x31\x01"))
        return invalidInput("{}: is not an OpenEXR file", file.name_);
    try {
        GLINT_CHECK(file.readHeaders(maxPixels));
    } catch (const std::exception& exception) {
        return damaged(file.name_, exception);
    }
    return file;
}

Result<void> ExrChannels::readHeaders(uint64_t maxPixels) {
    int version = 0;
    GLINT_TRY(headers, parseHeaders(bytes_, name_, version));
    for (size_t part = 0; part < headers.size(); ++part) {
        const Imf::Header& header = headers[part];
        if (isDeep(header, version)) {
            ++deepParts_;
            continue;
        }
        GLINT_CHECK(checkWindow(header, name_, maxPixels));
        const Imath::Box2i& window = header.dataWindow();
        const auto width = uint32_t(window.max.x - window.min.x + 1);
        const auto height = uint32_t(window.max.y - window.min.y + 1);
        if (!names_.empty() && (width != width_ || height != height_))
            return invalidInput("{}: its parts have different sizes, {}x{} and {}x{}: all layers of a frame must have "
                                "one size",
                                name_, width_, height_, width, height);
        width_ = width;
        height_ = height;
        const std::string partName =
            Imf::isMultiPart(version) && header.hasName() ? std::string(header.name()) : std::string();
        int count = 0;
        for (auto it = header.channels().begin(); it != header.channels().end(); ++it) {
            if (++count > kMaxExrChannels)
                return invalidInput("{}: more than {} channels", name_, kMaxExrChannels);
            std::string full = fullName(partName, it.name());
            if (std::ranges::find(names_, full) != names_.end())
                continue; // two parts with one channel, as the eyes of a stereo picture: the first counts
            names_.push_back(std::move(full));
            places_.push_back({static_cast<int>(part), it.name()});
        }
    }
    if (names_.empty())
        return invalidInput("{}: {}", name_,
                            deepParts_ > 0 ? "its pixels are deep, which is not read: flatten it"
                                           : "it has no channels");
    return {};
}

Result<std::vector<std::vector<float>>> ExrChannels::read(std::span<const size_t> channels) const {
    const uint64_t pixels = uint64_t{width_} * height_;
    if (pixels * channels.size() > kMaxExrFloats)
        return invalidInput("{}: {} channels of {}x{} pixels are too many to read at once", name_, channels.size(),
                            width_, height_);
    std::vector<std::vector<float>> planes(channels.size());
    try {
        for (int part = 0; part < kMaxExrParts; ++part)
            GLINT_CHECK(readPart(part, channels, planes));
    } catch (const std::exception& exception) {
        return damaged(name_, exception);
    }
    return planes;
}

Result<void> ExrChannels::readPart(int part, std::span<const size_t> channels,
                                   std::vector<std::vector<float>>& planes) const {
    if (std::ranges::none_of(channels, [&](size_t channel) { return places_[channel].part == part; }))
        return {};
    ExrStream stream(bytes_, name_);
    Imf::MultiPartInputFile file(stream);
    Imf::InputPart input(file, part);
    const Imath::Box2i window = input.header().dataWindow();
    Imf::FrameBuffer frameBuffer;
    for (size_t i = 0; i < channels.size(); ++i) {
        const Place& place = places_[channels[i]];
        if (place.part != part)
            continue;
        const Imf::Channel& stored = input.header().channels()[place.channel];
        if (stored.xSampling != 1 || stored.ySampling != 1)
            return invalidInput("{}: channel {} is subsampled, which is not supported", name_,
                                printable(names_[channels[i]]));
        planes[i].resize(size_t{width_} * height_);
        frameBuffer.insert(place.channel, Imf::Slice::Make(Imf::FLOAT, planes[i].data(), window, sizeof(float),
                                                           sizeof(float) * width_));
    }
    input.setFrameBuffer(frameBuffer);
    input.readPixels(window.min.y, window.max.y);
    return {};
}

} // namespace glint::scene
