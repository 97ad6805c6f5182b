// A G-buffer without a renderer: surfaces are a function of the pixel's ray, so that every answer is known.
#pragma once

#include "glint/glint.hpp"
#include "gpu/support/gpu_test.hpp"

#include <glm/glm.hpp>

#include <functional>
#include <optional>

namespace glint::test {

/// The hit of a camera ray.
struct SyntheticSurface {
    double distance = 0; ///< metres along the ray
    glm::dvec3 normalWS = {0, 1, 0};
    glm::vec3 f0 = glm::vec3(0);
    float perceptualRoughness = 0;
    glm::vec3 radiance = glm::vec3(0);
    float alpha = 1; ///< of litRadiance: Conventions::highlightsInAlpha defines it
};

/// `originWS`, `directionWS` (unit) -> surface, or an empty value for the background.
using SyntheticScene = std::function<std::optional<SyntheticSurface>(const glm::dvec3&, const glm::dvec3&)>;

struct SyntheticCamera {
    glm::dvec3 position = {0, 1, 3};
    glm::dvec3 target = {0, 0.5, 0};
    double fovY = 0.8; ///< radians
    double near = 0.05;
    double orthoHeight = 0; ///< metres; not 0: orthographic
    double far = 50;        ///< orthographic only

    glm::dmat4 worldToView() const;
    glm::dmat4 viewToClip(uint32_t width, uint32_t height) const; ///< reversed; infinite unless orthographic
    View view(uint32_t width, uint32_t height) const;
    double deviceDepth(double viewZ) const;
    double viewZ(const glm::dvec3& positionWS) const;
    /// Origin of the ray through a pixel's centre: the eye, or a point of the eye's plane.
    glm::dvec3 originThrough(uint32_t x, uint32_t y, uint32_t width, uint32_t height) const;
    /// Unit direction of that ray.
    glm::dvec3 rayThrough(uint32_t x, uint32_t y, uint32_t width, uint32_t height) const;
    /// Pixel position of a world point (fractional; centres are at .5).
    glm::dvec2 project(const glm::dvec3& positionWS, uint32_t width, uint32_t height) const;
};

/// The surface of every pixel, row by row.
std::vector<std::optional<SyntheticSurface>> seen(const SyntheticScene& scene, const SyntheticCamera& camera,
                                                  uint32_t width, uint32_t height);

/// The images on the GPU, with Glint's default conventions.
struct SyntheticGBuffer {
    gpu::Image depth;
    gpu::Image normal;
    gpu::Image material;
    gpu::Image litRadiance;
    GBuffer gbuffer;

    static SyntheticGBuffer render(gpu::Context& context, const SyntheticScene& scene, const SyntheticCamera& camera,
                                   uint32_t width, uint32_t height);
};

/// An image with this content, sampled and ready.
gpu::Image uploadTestImage(gpu::Context& context, const char* name, VkFormat format, uint32_t width, uint32_t height,
                           std::span<const std::byte> content);

/// Texels as bytes.
template <class T>
std::span<const std::byte> bytesOf(const std::vector<T>& values) {
    return std::as_bytes(std::span(values));
}

/// Unit vector -> [-1, 1]^2, in double precision.
glm::vec2 encodeOctahedral(const glm::dvec3& n);

Matrix4 toMatrix4(const glm::dmat4& m);

/// The image as a host provides it.
HostImage asHostImage(const gpu::Image& image);

/// One of Glint's images as floats, RGBA.
std::vector<float> download(gpu::Context& context, const HostImage& image);

} // namespace glint::test
