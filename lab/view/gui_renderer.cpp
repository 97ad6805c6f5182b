#include "lab/view/gui_renderer.hpp"

#include "gpu/transfer.hpp"
#include "lab/view/shaders.hpp"
#include "shared/gui.h"

#include <imgui.h>

#include <algorithm>
#include <bit>

namespace glint::view {
namespace {

static_assert(sizeof(ImDrawVert) == sizeof(shared::GuiVertex), "ImGui's vertices go to the shader as they are");

gpu::SamplerDesc sampler(VkFilter filter) {
    gpu::SamplerDesc desc;
    desc.magFilter = desc.minFilter = filter;
    desc.mips = false;
    desc.wrapU = desc.wrapV = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    return desc;
}

uint32_t textureNumber(ImTextureID id) {
    return static_cast<uint32_t>(reinterpret_cast<uintptr_t>(id));
}

/// Converts a clip rectangle to pixels of the target; empty ones have no width.
std::array<uint32_t, 4> clipPixels(const ImVec4& clip, const ImVec2& origin, const gpu::Image& target) {
    const auto pixel = [](float value, uint32_t most) {
        return static_cast<uint32_t>(std::clamp(value, 0.0f, static_cast<float>(most)));
    };
    const uint32_t left = pixel(clip.x - origin.x, target.width()), right = pixel(clip.z - origin.x, target.width());
    const uint32_t top = pixel(clip.y - origin.y, target.height()), bottom = pixel(clip.w - origin.y, target.height());
    return {left, top, right > left ? right - left : 0, bottom > top ? bottom - top : 0};
}

} // namespace

Result<GuiRenderer> GuiRenderer::create(gpu::Context& context) {
    GuiRenderer result(context);
    context.addShaders(gpu::shaders::view());
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    GLINT_TRY(font, gpu::Image::create(context, {"view/font", VK_FORMAT_R8G8B8A8_UNORM, static_cast<uint32_t>(width),
                                                 static_cast<uint32_t>(height), 1, 1, gpu::ImageShape::Flat,
                                                 VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
    const size_t bytes = static_cast<size_t>(width) * static_cast<size_t>(height) * 4;
    GLINT_CHECK(gpu::uploadImage(context, font, std::as_bytes(std::span(pixels, bytes))));
    result.font_ = std::move(font);
    ImGui::GetIO().Fonts->SetTexID(reinterpret_cast<ImTextureID>(uintptr_t{kFontTexture}));
    GLINT_CHECK(result.setPictures({}));
    gpu::RasterDesc desc;
    desc.vertexShader = "view/gui.vert";
    desc.fragmentShader = "view/gui.frag";
    desc.pushSize = sizeof(shared::GuiConstants);
    desc.colorFormats = {kFormat};
    desc.blend = gpu::Blend::Premultiplied;
    desc.tableLayout = result.table_.layout();
    GLINT_TRY(pipeline, gpu::Pipeline::raster(context, desc));
    result.pipeline_ = std::move(pipeline);
    GLINT_TRY(timers, gpu::Timers::create(context));
    result.timers_ = std::move(timers);
    return result;
}

Result<void> GuiRenderer::setPictures(std::span<const gpu::Image* const> pictures) {
    std::vector<gpu::TextureTable::Entry> entries = {{&font_, sampler(VK_FILTER_LINEAR)}};
    for (const gpu::Image* picture : pictures) {
        entries.push_back({picture, sampler(VK_FILTER_LINEAR)});
        entries.push_back({picture, sampler(VK_FILTER_NEAREST)});
    }
    // Always the same number of entries, as pipeline layouts include it.
    while (entries.size() < shared::kGuiTextures)
        entries.push_back(entries.front());
    GLINT_TRY(table, gpu::TextureTable::create(*context_, entries));
    table_ = std::move(table);
    textures_ = static_cast<uint32_t>(entries.size());
    return {};
}

Result<void> GuiRenderer::reserve(gpu::Buffer& buffer, const char* name, size_t bytes, VkBufferUsageFlags usage) {
    if (buffer && buffer.size() >= bytes)
        return {};
    GLINT_TRY(made, gpu::Buffer::create(*context_, {name, std::bit_ceil(std::max(bytes, size_t{1} << 16)), usage,
                                                    gpu::BufferHome::Upload}));
    buffer = std::move(made);
    return {};
}

Result<void> GuiRenderer::fill(const ImDrawData& data) {
    const auto vertexCount = static_cast<size_t>(data.TotalVtxCount),
               indexCount = static_cast<size_t>(data.TotalIdxCount);
    GLINT_CHECK(
        reserve(vertices_, "view/vertices", vertexCount * sizeof(ImDrawVert), VK_BUFFER_USAGE_STORAGE_BUFFER_BIT));
    GLINT_CHECK(reserve(indices_, "view/indices", indexCount * sizeof(uint32_t), VK_BUFFER_USAGE_INDEX_BUFFER_BIT));
    auto* vertex = static_cast<ImDrawVert*>(vertices_.mapped());
    auto* index = static_cast<uint32_t*>(indices_.mapped());
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        vertex = std::copy(list.VtxBuffer.begin(), list.VtxBuffer.end(), vertex);
        index = std::copy(list.IdxBuffer.begin(), list.IdxBuffer.end(), index); // widened to 32 bits
    }
    return {};
}

Result<void> GuiRenderer::draw(const ImDrawData& data, gpu::Image& target) {
    GLINT_CHECK(fill(data));
    return context_->submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(*context_, commands, timers_.get());
        const VkClearColorValue black = {{0, 0, 0, 1}};
        frame.pass(pipeline_)
            .read("vertices", vertices_)
            .indices(indices_)
            .table(table_.set())
            .color(target, &black)
            .draw([&](gpu::Draws& draws) {
                uint32_t firstVertex = 0, firstIndex = 0;
                for (int i = 0; i < data.CmdListsCount; ++i) {
                    const ImDrawList& list = *data.CmdLists[i];
                    for (const ImDrawCmd& command : list.CmdBuffer) {
                        const auto [x, y, width, height] = clipPixels(command.ClipRect, data.DisplayPos, target);
                        if (command.UserCallback || width == 0 || height == 0 || command.ElemCount == 0)
                            continue;
                        const shared::GuiConstants constants = {
                            {data.DisplayPos.x, data.DisplayPos.y},
                            {2 / data.DisplaySize.x, 2 / data.DisplaySize.y},
                            std::min(textureNumber(command.GetTexID()), textures_ - 1)};
                        draws.scissor(x, y, width, height)
                            .push(constants)
                            .drawIndexed(command.ElemCount, firstIndex + command.IdxOffset,
                                         static_cast<int32_t>(firstVertex + command.VtxOffset));
                    }
                    firstVertex += static_cast<uint32_t>(list.VtxBuffer.Size);
                    firstIndex += static_cast<uint32_t>(list.IdxBuffer.Size);
                }
            });
    });
}

double GuiRenderer::milliseconds() {
    double sum = 0;
    for (const gpu::PassTime& time : timers_->latest())
        sum += time.milliseconds;
    return sum;
}

} // namespace glint::view
