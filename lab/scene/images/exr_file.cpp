// Reads and writes OpenEXR images. The OpenEXR library throws; no exception leaves this file.
#include "base/assert.hpp"
#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/scene/images/exr_stream.hpp"
#include "lab/scene/images/image_file.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <set>

namespace glint::scene {
namespace {

/// The prefix under which the file has R, G and B: "" or that of its first layer with all three, "sky.".
Result<std::string> findColor(const Imf::ChannelList& channels, std::string_view name) {
    const auto hasColor = [&](const std::string& prefix) {
        return channels.findChannel(prefix + "R") && channels.findChannel(prefix + "G") &&
               channels.findChannel(prefix + "B");
    };
    if (hasColor(""))
        return std::string();
    std::set<std::string> layers;
    channels.layers(layers);
    for (const std::string& layer : layers) {
        if (hasColor(layer + "."))
            return layer + ".";
    }
    std::vector<std::string> names;
    for (auto it = channels.begin(); it != channels.end(); ++it)
        names.emplace_back(it.name());
    return invalidInput("{}: no R, G and B channels; it has {}", name, printable(joinText(names, ", "), 200));
}

/// Checks the header before the library allocates memory for it.
Result<void> checkHeader(std::string_view bytes, const std::string& name, uint64_t maxPixels) {
    ExrStream stream(bytes, name);
    char start[8]; // magic number, version and flags
    stream.read(start, sizeof start);
    int version = 0;
    std::memcpy(&version, start + 4, sizeof version);
    Imf::Header header;
    header.readFrom(stream, version);
    const Imath::Box2i window = header.dataWindow();
    const int64_t width = int64_t(window.max.x) - window.min.x + 1;
    const int64_t height = int64_t(window.max.y) - window.min.y + 1;
    if (width < 1 || height < 1)
        return invalidInput("{}: the picture has no pixels", name);
    if (width > kMaxImageSide || height > kMaxImageSide || uint64_t(width * height) > maxPixels)
        return invalidInput("{}: {} x {} pixels are too many, at most {} a side and {} in all are read", name, width,
                            height, kMaxImageSide, maxPixels);
    constexpr int kMaxChannels = 256; // limits a row's buffer; enough for many layers
    int channels = 0;
    for (auto it = header.channels().begin(); it != header.channels().end(); ++it)
        ++channels;
    if (channels > kMaxChannels)
        return invalidInput("{}: more than {} channels", name, kMaxChannels);
    return {};
}

Result<HdrImage> readPixels(std::string_view bytes, const std::string& name) {
    ExrStream stream(bytes, name);
    Imf::InputFile file(stream);
    GLINT_TRY(prefix, findColor(file.header().channels(), name));
    const Imath::Box2i window = file.header().dataWindow();

    HdrImage image;
    image.width = uint32_t(window.max.x - window.min.x + 1);
    image.height = uint32_t(window.max.y - window.min.y + 1);
    image.rgb.resize(size_t(image.width) * image.height);
    Imf::FrameBuffer frameBuffer;
    for (int i = 0; i < 3; ++i) {
        const std::string channel = prefix + "RGB"[i];
        const Imf::Channel& stored = file.header().channels()[channel];
        if (stored.xSampling != 1 || stored.ySampling != 1)
            return invalidInput("{}: channel {} is subsampled, which is not supported", name, printable(channel));
        frameBuffer.insert(channel, Imf::Slice::Make(Imf::FLOAT, &image.rgb[0][i], window, sizeof(glm::vec3),
                                                     sizeof(glm::vec3) * image.width));
    }
    file.setFrameBuffer(frameBuffer);
    file.readPixels(window.min.y, window.max.y);
    for (glm::vec3& pixel : image.rgb)
        pixel = {asEnvironmentRadiance(pixel.r), asEnvironmentRadiance(pixel.g), asEnvironmentRadiance(pixel.b)};
    return image;
}

Error exrError(ErrorCode code, const std::string& name, const std::exception& exception) {
    return makeError(code, "{}: OpenEXR: {}", name, printable(exception.what(), 200));
}

// ---------------------------------------------------------------- writing

/// One channel of the file, stored separately.
struct Plane {
    std::string name;
    std::vector<half> halves;
    std::vector<float> floats;
};

Plane makePlane(const ExrLayer& layer, size_t channel, size_t pixelCount) {
    Plane plane;
    plane.name = layer.name.empty() ? std::string() : layer.name + ".";
    plane.name += layer.channels[channel];
    const auto at = [&](size_t i) { return layer.pixels[i * layer.stride + channel]; };
    if (layer.half) {
        plane.halves.reserve(pixelCount);
        for (size_t i = 0; i < pixelCount; ++i)
            plane.halves.emplace_back(std::clamp(at(i), -kMaxRadiance, kMaxRadiance));
    } else {
        plane.floats.reserve(pixelCount);
        for (size_t i = 0; i < pixelCount; ++i)
            plane.floats.push_back(at(i));
    }
    return plane;
}

} // namespace

Result<HdrImage> decodeExr(std::string_view bytes, std::string_view name, uint64_t maxPixels) {
    const std::string nameText(name);
    try {
        GLINT_CHECK(checkHeader(bytes, nameText, maxPixels));
        return readPixels(bytes, nameText);
    } catch (const std::exception& exception) {
        return exrError(ErrorCode::InvalidInput, nameText, exception);
    }
}

Result<void> writeExr(const std::string& path, uint32_t width, uint32_t height, std::span<const ExrLayer> layers) {
    const size_t pixelCount = size_t(width) * height;
    std::vector<Plane> planes;
    std::set<std::string> names;
    for (const ExrLayer& layer : layers) {
        GLINT_ASSERT(layer.stride >= layer.channels.size() && layer.pixels.size() >= pixelCount * layer.stride,
                     "layer '{}': {} floats for {} pixels", layer.name, layer.pixels.size(), pixelCount);
        for (size_t channel = 0; channel < layer.channels.size(); ++channel) {
            planes.push_back(makePlane(layer, channel, pixelCount));
            if (!names.insert(planes.back().name).second)
                return invalidArgument("{}: two layers have the channel {}", path, planes.back().name);
        }
    }

    FileInMaking making(path);
    try {
        Imf::Header header{int(width), int(height)}; // ZIP compression is the default
        Imf::FrameBuffer frameBuffer;
        for (Plane& plane : planes) {
            const bool isHalf = plane.floats.empty();
            const Imf::PixelType type = isHalf ? Imf::HALF : Imf::FLOAT;
            const size_t size = isHalf ? sizeof(half) : sizeof(float);
            char* const base =
                isHalf ? reinterpret_cast<char*>(plane.halves.data()) : reinterpret_cast<char*>(plane.floats.data());
            header.channels().insert(plane.name, Imf::Channel(type));
            frameBuffer.insert(plane.name, Imf::Slice(type, base, size, size * width));
        }
        Imf::OutputFile file(making.temporaryPath().c_str(), header);
        file.setFrameBuffer(frameBuffer);
        file.writePixels(int(height));
    } catch (const std::exception& exception) {
        return exrError(ErrorCode::Io, path, exception);
    }
    return making.commit();
}

} // namespace glint::scene
