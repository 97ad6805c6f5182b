#include "gpu/transfer.hpp"

#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <cstring>

namespace glint::gpu {
namespace {

constexpr Use kSampled = {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                          VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};

enum class Channel : uint8_t { Unorm8, Snorm8, Unorm16, Snorm16, Half, Uint16, Uint32, Float };

struct FormatLayout {
    VkFormat format;
    Channel channel;
    uint8_t channels;
};

constexpr FormatLayout kFormats[] = {
    {VK_FORMAT_R8_UNORM, Channel::Unorm8, 1},          {VK_FORMAT_R8G8_UNORM, Channel::Unorm8, 2},
    {VK_FORMAT_R8G8B8A8_UNORM, Channel::Unorm8, 4},    {VK_FORMAT_R8G8B8A8_SRGB, Channel::Unorm8, 4},
    {VK_FORMAT_R8G8B8A8_SNORM, Channel::Snorm8, 4},    {VK_FORMAT_R16_UNORM, Channel::Unorm16, 1},
    {VK_FORMAT_R16G16_UNORM, Channel::Unorm16, 2},     {VK_FORMAT_R16G16B16A16_UNORM, Channel::Unorm16, 4},
    {VK_FORMAT_R16G16_SNORM, Channel::Snorm16, 2},     {VK_FORMAT_R16G16B16A16_SNORM, Channel::Snorm16, 4},
    {VK_FORMAT_R16_SFLOAT, Channel::Half, 1},          {VK_FORMAT_R16G16_SFLOAT, Channel::Half, 2},
    {VK_FORMAT_R16G16B16A16_SFLOAT, Channel::Half, 4}, {VK_FORMAT_R16_UINT, Channel::Uint16, 1},
    {VK_FORMAT_R32_UINT, Channel::Uint32, 1},          {VK_FORMAT_R32G32_UINT, Channel::Uint32, 2},
    {VK_FORMAT_R32G32B32A32_UINT, Channel::Uint32, 4}, {VK_FORMAT_R32_SFLOAT, Channel::Float, 1},
    {VK_FORMAT_R32G32_SFLOAT, Channel::Float, 2},      {VK_FORMAT_R32G32B32A32_SFLOAT, Channel::Float, 4},
    {VK_FORMAT_D32_SFLOAT, Channel::Float, 1},
};

const FormatLayout* layoutOf(VkFormat format) {
    const auto* found = std::find_if(std::begin(kFormats), std::end(kFormats),
                                     [&](const FormatLayout& layout) { return layout.format == format; });
    return found == std::end(kFormats) ? nullptr : found;
}

size_t channelBytes(Channel channel) {
    switch (channel) {
    case Channel::Unorm8:
    case Channel::Snorm8: return 1;
    case Channel::Unorm16:
    case Channel::Snorm16:
    case Channel::Half:
    case Channel::Uint16: return 2;
    case Channel::Uint32:
    case Channel::Float: return 4;
    }
    return 0;
}

template <class T>
T load(const std::byte* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

float channelValue(Channel channel, const std::byte* bytes) {
    switch (channel) {
    case Channel::Unorm8: return static_cast<float>(load<uint8_t>(bytes)) / 255.0f;
    case Channel::Snorm8: return std::max(static_cast<float>(load<int8_t>(bytes)) / 127.0f, -1.0f);
    case Channel::Unorm16: return static_cast<float>(load<uint16_t>(bytes)) / 65535.0f;
    case Channel::Snorm16: return std::max(static_cast<float>(load<int16_t>(bytes)) / 32767.0f, -1.0f);
    case Channel::Half: return glm::unpackHalf1x16(load<uint16_t>(bytes));
    case Channel::Uint16: return static_cast<float>(load<uint16_t>(bytes));
    case Channel::Uint32: return static_cast<float>(load<uint32_t>(bytes));
    case Channel::Float: return load<float>(bytes);
    }
    return 0;
}

} // namespace

size_t bytesPerTexel(VkFormat format) {
    const FormatLayout* layout = layoutOf(format);
    return layout ? channelBytes(layout->channel) * layout->channels : 0;
}

Result<Buffer> uploadBuffer(Context& context, std::string name, std::span<const std::byte> content,
                            VkBufferUsageFlags usage) {
    // An empty buffer cannot be created; a shader that receives "0 elements" never reads the spare one.
    const size_t size = std::max<size_t>(content.size(), 16);
    GLINT_TRY(staging,
              Buffer::create(context, {name + "/staging", size, VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::Upload}));
    if (!content.empty())
        std::memcpy(staging.mapped(), content.data(), content.size());
    GLINT_TRY(buffer, Buffer::create(context, {std::move(name), size, usage | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               BufferHome::Device}));
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        const VkBufferCopy region = {0, 0, size};
        context.api().CmdCopyBuffer(commands, staging.handle(), buffer.handle(), 1, &region);
    }));
    // submitAndWait has waited, but later submissions still need the copy made visible: the state records it as a
    // write.
    buffer.state().writeStages = VK_PIPELINE_STAGE_2_ALL_TRANSFER_BIT;
    buffer.state().writeAccess = VK_ACCESS_2_TRANSFER_WRITE_BIT;
    return buffer;
}

Result<void> uploadImage(Context& context, Image& image, std::span<const std::byte> content) {
    const size_t layerBytes = bytesPerTexel(image.desc().format) * image.width() * image.height();
    if (layerBytes == 0 || content.size() != layerBytes * image.desc().layers)
        return invalidArgument("image '{}' takes {} bytes, {} were given", image.desc().name,
                               layerBytes * image.desc().layers, content.size());
    GLINT_TRY(staging, Buffer::create(context, {image.desc().name + "/staging", content.size(),
                                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT, BufferHome::Upload}));
    std::memcpy(staging.mapped(), content.data(), content.size());
    return context.submitAndWait([&](VkCommandBuffer commands) {
        Frame frame(context, commands);
        for (uint32_t layer = 0; layer < image.desc().layers; ++layer)
            frame.copyFromBuffer(staging, layer * layerBytes, image, 0, layer);
        frame.makeMips(image);
        frame.hand(image, kSampled);
    });
}

Result<std::vector<std::byte>> downloadImage(Context& context, Image& image, uint32_t mip, uint32_t layer) {
    const size_t size =
        bytesPerTexel(image.desc().format) * std::max(image.width() >> mip, 1u) * std::max(image.height() >> mip, 1u);
    if (size == 0)
        return invalidArgument("image '{}': its format {} cannot be read back", image.desc().name,
                               static_cast<int>(image.desc().format));
    GLINT_TRY(readback, Buffer::create(context, {image.desc().name + "/readback", size,
                                                 VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::Readback}));
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        Frame frame(context, commands);
        frame.copyToBuffer(image, mip, layer, readback);
    }));
    const auto* bytes = static_cast<const std::byte*>(readback.mapped());
    return std::vector<std::byte>(bytes, bytes + size);
}

Result<std::vector<std::byte>> downloadBuffer(Context& context, Buffer& buffer) {
    GLINT_TRY(readback, Buffer::create(context, {buffer.name() + "/readback", buffer.size(),
                                                 VK_BUFFER_USAGE_TRANSFER_DST_BIT, BufferHome::Readback}));
    GLINT_CHECK(context.submitAndWait([&](VkCommandBuffer commands) {
        Frame frame(context, commands);
        frame.copyBuffer(buffer, readback);
    }));
    const auto* bytes = static_cast<const std::byte*>(readback.mapped());
    return std::vector<std::byte>(bytes, bytes + buffer.size());
}

Result<std::vector<float>> downloadImageAsFloats(Context& context, Image& image, uint32_t mip, uint32_t layer) {
    GLINT_TRY(bytes, downloadImage(context, image, mip, layer));
    const FormatLayout& layout = *layoutOf(image.desc().format);
    const size_t texelBytes = bytesPerTexel(image.desc().format);
    const size_t channelSize = channelBytes(layout.channel);
    std::vector<float> values;
    values.reserve(bytes.size() / texelBytes * 4);
    for (size_t texel = 0; texel < bytes.size(); texel += texelBytes)
        for (size_t c = 0; c < 4; ++c)
            values.push_back(c < layout.channels ? channelValue(layout.channel, bytes.data() + texel + c * channelSize)
                             : c == 3            ? 1.0f
                                                 : 0.0f);
    return values;
}

} // namespace glint::gpu
