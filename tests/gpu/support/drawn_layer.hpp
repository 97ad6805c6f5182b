// A layer of transparent surfaces, drawn ray by ray.
#pragma once

#include "gpu/support/synthetic_gbuffer.hpp"

#include "glint/transparent_layer.hpp"

#include <functional>
#include <optional>

namespace glint::test {

/// The layer's surface at a pixel.
struct LayerSurface {
    double distance = 0; ///< metres along the ray
    glm::dvec3 normalWS = {0, 0, 1};
    glm::vec3 f0 = glm::vec3(0);
    float roughness = 0;
    glm::vec4 radiance = glm::vec4(0, 0, 0, 1);
    glm::vec4 transmittance = glm::vec4(1);
    glm::vec4 absorption = glm::vec4(1, 1, 1, 0);
    float ior = 1.5f;
    float thickness = 0;
    float dispersion = 0;
    BodyShape shape = BodyShape::Straight;
    bool missesCenter = false; ///< the layer misses the pixel's centre but covers a part
    float coverage = 1;        ///< 0: no surface; a layer with 1 everywhere provides no coverage
    float inFront = 0;         ///< part of it that shows another surface, in front, that misses the pixel's centre
};
using LayerScene = std::function<std::optional<LayerSurface>(const glm::dvec3&, const glm::dvec3&)>;

struct DrawnLayer {
    std::vector<gpu::Image> images;
    TransparentLayer layer;

    static DrawnLayer draw(gpu::Context& context, const LayerScene& scene, const SyntheticCamera& camera,
                           uint32_t width, uint32_t height) {
        std::vector<float> depth;
        bool hasParts = false;
        std::vector<glm::vec2> normal, coverage;
        std::vector<glm::vec4> material, radiance, transmittance, absorption, body;
        for (uint32_t i = 0; i < width * height; ++i) {
            const glm::dvec3 origin = camera.originThrough(i % width, i / width, width, height);
            const glm::dvec3 direction = camera.rayThrough(i % width, i / width, width, height);
            const std::optional<LayerSurface> hit = scene(origin, direction);
            const LayerSurface s = hit.value_or(LayerSurface{});
            depth.push_back(hit && !hit->missesCenter
                                ? static_cast<float>(camera.deviceDepth(camera.viewZ(origin + direction * s.distance)))
                                : 0.0f);
            normal.push_back(encodeOctahedral(s.normalWS));
            material.emplace_back(s.f0, s.roughness);
            radiance.push_back(s.radiance);
            transmittance.push_back(s.transmittance);
            absorption.push_back(s.absorption);
            body.emplace_back(s.ior, s.thickness, static_cast<float>(s.shape), s.dispersion);
            coverage.emplace_back(hit ? s.coverage : 0, s.inFront);
            hasParts |= s.coverage < 1 || s.inFront > 0 || s.missesCenter;
        }
        DrawnLayer out;
        const auto upload = [&](const auto& texels, VkFormat format) {
            out.images.push_back(uploadTestImage(context, "test/layer", format, width, height, bytesOf(texels)));
            return asHostImage(out.images.back());
        };
        constexpr VkFormat kFour = VK_FORMAT_R32G32B32A32_SFLOAT;
        out.layer.depth = upload(depth, VK_FORMAT_R32_SFLOAT);
        out.layer.normal = upload(normal, VK_FORMAT_R32G32_SFLOAT);
        out.layer.material = upload(material, kFour);
        out.layer.radiance = upload(radiance, kFour);
        out.layer.transmittance = upload(transmittance, kFour);
        out.layer.absorption = upload(absorption, kFour);
        out.layer.body = upload(body, kFour);
        if (hasParts)
            out.layer.coverage = upload(coverage, VK_FORMAT_R32G32_SFLOAT);
        return out;
    }
};

/// A pane across the view at z, seen from the front.
inline LayerScene pane(double z, const LayerSurface& surface) {
    return [=](const glm::dvec3& origin, const glm::dvec3& direction) -> std::optional<LayerSurface> {
        LayerSurface s = surface;
        s.distance = (z - origin.z) / direction.z;
        return s.distance > 0 ? std::optional(s) : std::nullopt;
    };
}

} // namespace glint::test
