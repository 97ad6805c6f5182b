#include "lab/renderer/shadow_maps.hpp"

#include "lab/renderer/frustum.hpp"
#include "lab/renderer/gbuffer.hpp"
#include "lab/scene/camera.hpp"
#include "shared/shadow.h"

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace {

/// Clip space (+Y up) -> the tile's UV (rows from the top); depth stays.
const glm::mat4 kClipToTile = {0.5f, 0, 0, 0, 0, -0.5f, 0, 0, 0, 0, 1, 0, 0.5f, 0.5f, 0, 1};
const glm::mat4 kTileToClip = {2, 0, 0, 0, 0, -2, 0, 0, 0, 0, 1, 0, -1, 1, 0, 1};

/// An orthographic box along the light around the scene's bounding sphere. Its size does not depend on the camera or
/// the light's direction, so that texels do not move.
void placeDirectional(shared::Light& light, const scene::Bounds& bounds, uint32_t tileSize) {
    const glm::vec3 center = (bounds.min + bounds.max) * 0.5f;
    const float radius = std::max(glm::length(bounds.max - bounds.min) * 0.5f, 1e-4f);
    const glm::mat4 lightToWorld = scene::lookAt(center - light.directionWS * radius, center);
    // One texel of margin, so that the filter reaches no edge inside the scene.
    const float halfWidth = radius * (1 + 4 / static_cast<float>(tileSize));
    glm::mat4 viewToClip(1); // reversed, linear: 1 at the near side of the sphere, 0 at the far one
    viewToClip[0][0] = viewToClip[1][1] = 1 / halfWidth;
    viewToClip[2][2] = 1 / (2 * radius);
    viewToClip[3][2] = 1;
    light.worldToShadow = kClipToTile * viewToClip * glm::inverse(lightToWorld);
    light.shadowTexelSize = 2 * halfWidth / static_cast<float>(tileSize);
}

/// A perspective projection that contains the cone; `near` excludes the lamp's own housing.
void placeSpot(shared::Light& light, const scene::Bounds& bounds, uint32_t tileSize) {
    const float cosOuter = -light.spotOffset / light.spotScale;
    const float tanOuter =
        std::min(std::sqrt(std::max(1 - cosOuter * cosOuter, 0.0f)) / std::max(cosOuter, 0.01f), 20.0f);
    const float margin = tanOuter * (1 + 4 / static_cast<float>(tileSize));
    const float near = std::max(glm::length(bounds.max - bounds.min) * 1e-4f, 1e-4f);
    glm::mat4 viewToClip(0); // reversed, infinitely far
    viewToClip[0][0] = viewToClip[1][1] = 1 / margin;
    viewToClip[2][3] = -1;
    viewToClip[3][2] = near;
    const glm::mat4 lightToWorld = scene::lookAt(light.positionWS, light.positionWS + light.directionWS);
    light.worldToShadow = kClipToTile * viewToClip * glm::inverse(lightToWorld);
    light.shadowTexelSize = 2 * margin / static_cast<float>(tileSize);
}

/// Light ends at its range, and so do its shadows.
bool isBeyondRange(const shared::Light& light, const scene::Bounds& boundsWS) {
    const bool ends = light.type != shared::kLightDirectional && light.range > 0;
    const glm::vec3 nearest = glm::clamp(light.positionWS, boundsWS.min, boundsWS.max);
    return ends && glm::distance(nearest, light.positionWS) > light.range;
}

bool canCast(const shared::Light& light) {
    return light.type != shared::kLightPoint;
}

} // namespace

Result<ShadowMaps> ShadowMaps::create(gpu::Context& context, const GpuScene& scene) {
    ShadowMaps result;
    gpu::RasterDesc desc;
    desc.vertexShader = "render/shadow.vert";
    desc.pushSize = sizeof(shared::ShadowDrawConstants);
    desc.depthFormat = kDepthFormat;
    // Reversed depth: the bias moves depth away from the light. The receiver's offset along its normal has the larger
    // effect (lib/shadow.glsl).
    desc.depthBiasConstant = -2;
    desc.depthBiasSlope = -1.5f;
    GLINT_TRY(opaque, gpu::Pipeline::raster(context, desc));
    desc.fragmentShader = "render/shadow_masked.frag";
    desc.tableLayout = scene.textures().layout();
    GLINT_TRY(masked, gpu::Pipeline::raster(context, desc));
    result.opaque_ = std::move(opaque);
    result.masked_ = std::move(masked);
    return result;
}

uint32_t ShadowMaps::casters(const std::vector<shared::Light>& lights) {
    return static_cast<uint32_t>(std::count_if(lights.begin(), lights.end(), canCast));
}

Result<void> ShadowMaps::resize(gpu::Context& context, uint32_t count, uint32_t resolution) {
    VkPhysicalDeviceProperties2 properties = {VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
    context.api().GetPhysicalDeviceProperties2(context.physicalDevice(), &properties);
    const auto columns = static_cast<uint32_t>(std::ceil(std::sqrt(static_cast<float>(std::max(count, 1u)))));
    const uint32_t rows = (std::max(count, 1u) + columns - 1) / columns;
    const uint32_t tile =
        count == 0 ? 1 : std::min(resolution, properties.properties.limits.maxImageDimension2D / columns);
    if (atlas_ && tile == tileSize_ && columns == columns_ && count == tiles_)
        return {};
    GLINT_TRY(atlas, gpu::Image::create(context, {"shadows/atlas", kDepthFormat, columns * tile, rows * tile, 1, 1,
                                                  gpu::ImageShape::Flat,
                                                  VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT |
                                                      VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    atlas_ = std::move(atlas);
    tileSize_ = tile;
    columns_ = columns;
    tiles_ = count;
    return {};
}

void ShadowMaps::place(std::span<shared::Light> lights, const scene::Bounds& boundsWS) const {
    uint32_t tile = 0;
    for (shared::Light& light : lights) {
        light.castsShadow = 0;
        if (!canCast(light) || boundsWS.empty() || tile >= tiles_)
            continue;
        if (light.type == shared::kLightDirectional)
            placeDirectional(light, boundsWS, tileSize_);
        else
            placeSpot(light, boundsWS, tileSize_);
        const glm::vec2 atlasSize(atlas_.width(), atlas_.height());
        const glm::vec2 origin(tile % columns_ * tileSize_, tile / columns_ * tileSize_);
        light.shadowTile = glm::vec4(origin / atlasSize, glm::vec2(static_cast<float>(tileSize_)) / atlasSize);
        light.castsShadow = 1;
        ++tile;
    }
}

void ShadowMaps::draw(gpu::Frame& frame, GpuScene& scene, std::span<const shared::Light> lights,
                      gpu::Buffer& lightBuffer) {
    const auto drawItems = [&](gpu::Draws& draws, SurfaceClass surface) {
        uint32_t tile = 0;
        for (uint32_t light = 0; light < lights.size(); ++light) {
            if (lights[light].castsShadow == 0 || tile >= tiles_)
                continue;
            const Frustum frustum(kTileToClip * lights[light].worldToShadow);
            draws.viewport(tile % columns_ * tileSize_, tile / columns_ * tileSize_, tileSize_, tileSize_);
            ++tile;
            for (uint32_t i = 0; i < scene.items().size(); ++i) {
                const GpuItem& item = scene.items()[i];
                if (item.surface != surface || item.topology != scene::Topology::Triangles ||
                    !frustum.mayShow(item.boundsWS) || isBeyondRange(lights[light], item.boundsWS))
                    continue;
                draws.push(shared::ShadowDrawConstants{i, light});
                draws.drawIndexed(item.indexCount, item.firstIndex, item.vertexOffset);
            }
        }
    };
    gpu::Pass opaque = frame.pass(opaque_);
    scene.bind(opaque).read("lights", lightBuffer).depth(atlas_, true).draw([&](gpu::Draws& draws) {
        drawItems(draws, SurfaceClass::Opaque);
    });
    gpu::Pass masked = frame.pass(masked_);
    scene.bind(masked)
        .read("materials", scene.materials())
        .read("lights", lightBuffer)
        .table(scene.textures().set())
        .depth(atlas_, false)
        .draw([&](gpu::Draws& draws) { drawItems(draws, SurfaceClass::Masked); });
}

} // namespace glint::render
