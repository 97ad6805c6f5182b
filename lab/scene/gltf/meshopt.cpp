#include "lab/scene/gltf/meshopt.hpp"

#include <meshoptimizer.h>

namespace glint::scene::gltf {
namespace {

/// The codecs need at least 2 bits per 16 bytes (attributes) or a byte per triangle, so valid data never grow more than
/// this; a larger size is rejected before allocation.
constexpr uint64_t kMaxGrowth = 64;

struct Request {
    std::string mode;
    std::string filter;
    uint64_t count = 0;
    uint64_t stride = 0;
};

/// Accepts the combinations that the extension allows; the codecs are safe only for these.
bool checkRequest(Diagnostics& diagnostics, const Request& request, uint64_t sourceBytes, size_t viewIndex) {
    const auto fail = [&](const std::string& what) {
        diagnostics.fail("bufferView {}: EXT_meshopt_compression: {}", viewIndex, what);
        return false;
    };
    if (request.mode == "ATTRIBUTES") {
        if (request.stride == 0 || request.stride > 256 || request.stride % 4 != 0)
            return fail(fmt::format("byteStride {} must be a multiple of 4 up to 256", request.stride));
    } else if (request.mode == "TRIANGLES" || request.mode == "INDICES") {
        if (request.stride != 2 && request.stride != 4)
            return fail(fmt::format("byteStride {} must be 2 or 4 for indices", request.stride));
        if (request.mode == "TRIANGLES" && request.count % 3 != 0)
            return fail(fmt::format("count {} is not a multiple of 3", request.count));
    } else {
        return fail(fmt::format("mode \"{}\" is not known", request.mode));
    }
    if (request.filter == "OCTAHEDRAL") {
        if (request.stride != 4 && request.stride != 8)
            return fail("filter OCTAHEDRAL needs byteStride 4 or 8");
    } else if (request.filter == "QUATERNION") {
        if (request.stride != 8)
            return fail("filter QUATERNION needs byteStride 8");
    } else if (request.filter != "EXPONENTIAL" && request.filter != "NONE" && !request.filter.empty()) {
        return fail(fmt::format("filter \"{}\" is not known", request.filter));
    }
    const bool filtered = !request.filter.empty() && request.filter != "NONE";
    if (filtered && request.mode != "ATTRIBUTES")
        return fail(fmt::format("filter {} needs mode ATTRIBUTES", request.filter));
    if (request.count > sourceBytes * kMaxGrowth / request.stride + 256)
        return fail(fmt::format("count {} is more than {} compressed bytes can hold", request.count, sourceBytes));
    return true;
}

void applyFilter(const Request& request, std::vector<uint8_t>& bytes) {
    if (request.filter == "OCTAHEDRAL")
        meshopt_decodeFilterOct(bytes.data(), request.count, request.stride);
    else if (request.filter == "QUATERNION")
        meshopt_decodeFilterQuat(bytes.data(), request.count, request.stride);
    else if (request.filter == "EXPONENTIAL")
        meshopt_decodeFilterExp(bytes.data(), request.count, request.stride);
}

} // namespace

std::vector<uint8_t> decompressMeshopt(Document& document, const JsonObject& compression,
                                       std::span<const uint8_t> source, size_t viewIndex) {
    Request request;
    request.mode = compression.string("mode");
    request.filter = compression.string("filter");
    request.count = compression.requiredCount("count");
    request.stride = compression.requiredCount("byteStride");
    if (document.failed() || !checkRequest(document.diagnostics, request, source.size(), viewIndex))
        return {};
    const uint64_t length = request.count * request.stride;
    if (!document.reserve(length, fmt::format("bufferView {}", viewIndex)))
        return {};

    std::vector<uint8_t> bytes(length);
    int status = 0;
    if (request.count == 0)
        return bytes;
    if (request.mode == "ATTRIBUTES")
        status = meshopt_decodeVertexBuffer(bytes.data(), request.count, request.stride, source.data(), source.size());
    else if (request.mode == "TRIANGLES")
        status = meshopt_decodeIndexBuffer(bytes.data(), request.count, request.stride, source.data(), source.size());
    else
        status = meshopt_decodeIndexSequence(bytes.data(), request.count, request.stride, source.data(), source.size());
    if (status != 0) {
        document.diagnostics.fail("bufferView {}: EXT_meshopt_compression: the compressed data is damaged", viewIndex);
        return {};
    }
    applyFilter(request, bytes);
    return bytes;
}

} // namespace glint::scene::gltf
