// OpenEXR files of kinds that Glint reads but does not write: several parts, tiles, deep pixels, other compressions.
#pragma once

#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputFile.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfTiledOutputFile.h>

#include <string>
#include <utility>
#include <vector>

namespace glint::test {

/// Name and width * height floats.
using ExrPlane = std::pair<std::string, std::vector<float>>;

struct ExrPart {
    std::string name;
    int width = 0, height = 0;
    std::vector<ExrPlane> planes;
};

inline Imf::Header exrHeader(const ExrPart& part, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    Imf::Header header(part.width, part.height);
    header.compression() = compression;
    for (const auto& [name, plane] : part.planes)
        header.channels().insert(name, Imf::Channel(Imf::FLOAT));
    return header;
}

inline Imf::FrameBuffer exrFrameBuffer(ExrPart& part) {
    Imf::FrameBuffer buffer;
    for (auto& [name, plane] : part.planes)
        buffer.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(plane.data()), sizeof(float),
                                       sizeof(float) * size_t(part.width)));
    return buffer;
}

inline void writeExrFile(const std::string& path, ExrPart part, Imf::Compression compression = Imf::ZIP_COMPRESSION) {
    Imf::OutputFile file(path.c_str(), exrHeader(part, compression));
    file.setFrameBuffer(exrFrameBuffer(part));
    file.writePixels(part.height);
}

inline void writeTiledExr(const std::string& path, ExrPart part, unsigned tile) {
    Imf::Header header = exrHeader(part);
    header.setTileDescription({tile, tile, Imf::ONE_LEVEL});
    Imf::TiledOutputFile file(path.c_str(), header);
    file.setFrameBuffer(exrFrameBuffer(part));
    file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
}

inline void writeMultiPartExr(const std::string& path, std::vector<ExrPart> parts) {
    std::vector<Imf::Header> headers;
    for (const ExrPart& part : parts) {
        headers.push_back(exrHeader(part));
        headers.back().setName(part.name);
        headers.back().setType(Imf::SCANLINEIMAGE);
    }
    Imf::MultiPartOutputFile file(path.c_str(), headers.data(), int(headers.size()));
    for (size_t i = 0; i < parts.size(); ++i) {
        Imf::OutputPart output(file, int(i));
        output.setFrameBuffer(exrFrameBuffer(parts[i]));
        output.writePixels(parts[i].height);
    }
}

/// One sample in each pixel of channel Z.
inline void writeDeepExr(const std::string& path, int width, int height) {
    Imf::Header header(width, height);
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    header.setType(Imf::DEEPSCANLINE);
    header.compression() = Imf::ZIPS_COMPRESSION;
    const size_t pixels = size_t(width) * size_t(height);
    std::vector<unsigned> counts(pixels, 1);
    std::vector<float> depths(pixels, 1.0f);
    std::vector<float*> pointers(pixels);
    for (size_t i = 0; i < pixels; ++i)
        pointers[i] = &depths[i];
    Imf::DeepFrameBuffer buffer;
    buffer.insertSampleCountSlice(Imf::Slice(Imf::UINT, reinterpret_cast<char*>(counts.data()), sizeof(unsigned),
                                             sizeof(unsigned) * size_t(width)));
    buffer.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(pointers.data()), sizeof(float*),
                                      sizeof(float*) * size_t(width), sizeof(float)));
    Imf::DeepScanLineOutputFile file(path.c_str(), header);
    file.setFrameBuffer(buffer);
    file.writePixels(height);
}

} // namespace glint::test
