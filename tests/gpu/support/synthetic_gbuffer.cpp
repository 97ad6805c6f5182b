#include "gpu/support/synthetic_gbuffer.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>

namespace glint::test {

glm::vec2 encodeOctahedral(const glm::dvec3& n) {
    const double sum = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
    glm::dvec2 p(n.x / sum, n.y / sum);
    if (n.z < 0)
        p = glm::dvec2((1 - std::abs(p.y)) * (p.x >= 0 ? 1 : -1), (1 - std::abs(p.x)) * (p.y >= 0 ? 1 : -1));
    return glm::vec2(p);
}

Matrix4 toMatrix4(const glm::dmat4& m) {
    const glm::mat4 single(m);
    Matrix4 out;
    std::copy_n(glm::value_ptr(single), 16, out.begin());
    return out;
}

glm::dmat4 SyntheticCamera::worldToView() const {
    return glm::lookAt(position, target, glm::dvec3(0, 1, 0));
}

glm::dmat4 SyntheticCamera::viewToClip(uint32_t width, uint32_t height) const {
    glm::dmat4 m(0);
    if (orthoHeight > 0) {
        m[0].x = 2 / (orthoHeight * width / height);
        m[1].y = 2 / orthoHeight;
        m[2].z = 1 / (far - near);
        m[3].z = far / (far - near);
        m[3].w = 1;
        return m;
    }
    const double f = 1 / std::tan(fovY / 2);
    m[0].x = f * height / width;
    m[1].y = f;
    m[2].w = -1;
    m[3].z = near;
    return m;
}

View SyntheticCamera::view(uint32_t width, uint32_t height) const {
    View view;
    view.worldToView = toMatrix4(worldToView());
    view.viewToClip = toMatrix4(viewToClip(width, height));
    return view;
}

double SyntheticCamera::deviceDepth(double viewZ) const {
    return orthoHeight > 0 ? (far - viewZ) / (far - near) : near / viewZ;
}

double SyntheticCamera::viewZ(const glm::dvec3& positionWS) const {
    return -(worldToView() * glm::dvec4(positionWS, 1)).z;
}

glm::dvec3 SyntheticCamera::originThrough(uint32_t x, uint32_t y, uint32_t width, uint32_t height) const {
    if (orthoHeight == 0)
        return position;
    const double ndcX = 2 * (x + 0.5) / width - 1;
    const double ndcY = 1 - 2 * (y + 0.5) / height;
    const glm::dvec3 offsetVS = glm::dvec3(ndcX * width / height, ndcY, 0) * (orthoHeight / 2);
    return position + glm::dmat3(glm::inverse(worldToView())) * offsetVS;
}

glm::dvec3 SyntheticCamera::rayThrough(uint32_t x, uint32_t y, uint32_t width, uint32_t height) const {
    if (orthoHeight > 0)
        return glm::normalize(target - position);
    const double tangent = std::tan(fovY / 2);
    const double ndcX = 2 * (x + 0.5) / width - 1;
    const double ndcY = 1 - 2 * (y + 0.5) / height;
    const glm::dvec3 directionVS(ndcX * tangent * width / height, ndcY * tangent, -1);
    return glm::normalize(glm::dmat3(glm::inverse(worldToView())) * directionVS);
}

glm::dvec2 SyntheticCamera::project(const glm::dvec3& positionWS, uint32_t width, uint32_t height) const {
    const glm::dvec4 clip = viewToClip(width, height) * worldToView() * glm::dvec4(positionWS, 1);
    return {(clip.x / clip.w * 0.5 + 0.5) * width, (0.5 - clip.y / clip.w * 0.5) * height};
}

gpu::Image uploadTestImage(gpu::Context& context, const char* name, VkFormat format, uint32_t width, uint32_t height,
                           std::span<const std::byte> content) {
    gpu::Image image = must(gpu::Image::create(
        context, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    must(gpu::uploadImage(context, image, content));
    return image;
}

HostImage asHostImage(const gpu::Image& image) {
    HostImage host = {image.handle(), image.view(), image.desc().format, image.width(), image.height()};
    host.samples = image.desc().samples;
    host.usage = image.desc().usage;
    host.mips = image.desc().mips;
    host.viewType = image.desc().shape == gpu::ImageShape::Cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
    return host;
}

std::vector<float> download(gpu::Context& context, const HostImage& image) {
    gpu::ResourceState state;
    state.layout = image.layout;
    gpu::Image borrowed = gpu::Image::borrow(
        image.image, image.view, {"download", image.format, image.width, image.height, 1, 1, gpu::ImageShape::Flat, 0},
        state);
    std::vector<float> values = must(gpu::downloadImageAsFloats(context, borrowed));
    // Return the image in its original state.
    must(context.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(context, commands);
        frame.hand(borrowed, {VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, VK_ACCESS_2_MEMORY_READ_BIT, image.layout});
    }));
    return values;
}

std::vector<std::optional<SyntheticSurface>> seen(const SyntheticScene& scene, const SyntheticCamera& camera,
                                                  uint32_t width, uint32_t height) {
    std::vector<std::optional<SyntheticSurface>> pixels;
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x)
            pixels.push_back(scene(camera.originThrough(x, y, width, height), camera.rayThrough(x, y, width, height)));
    return pixels;
}

SyntheticGBuffer SyntheticGBuffer::render(gpu::Context& context, const SyntheticScene& scene,
                                          const SyntheticCamera& camera, uint32_t width, uint32_t height) {
    std::vector<float> depth;
    std::vector<glm::vec2> normal;
    std::vector<glm::vec4> material;
    std::vector<glm::vec4> lit;
    const glm::dmat3 worldToView(camera.worldToView());
    const std::vector<std::optional<SyntheticSurface>> pixels = seen(scene, camera, width, height);
    for (uint32_t i = 0; i < width * height; ++i) {
        const glm::dvec3 direction = camera.rayThrough(i % width, i / width, width, height);
        const SyntheticSurface surface = pixels[i].value_or(SyntheticSurface{});
        const double viewZ = -(worldToView * direction).z * surface.distance;
        depth.push_back(pixels[i] ? static_cast<float>(camera.deviceDepth(viewZ)) : 0.0f);
        normal.push_back(encodeOctahedral(surface.normalWS));
        material.emplace_back(surface.f0, surface.perceptualRoughness);
        lit.emplace_back(surface.radiance, surface.alpha);
    }
    SyntheticGBuffer out;
    out.depth = uploadTestImage(context, "test/depth", VK_FORMAT_R32_SFLOAT, width, height, bytesOf(depth));
    out.normal = uploadTestImage(context, "test/normal", VK_FORMAT_R32G32_SFLOAT, width, height, bytesOf(normal));
    out.material =
        uploadTestImage(context, "test/material", VK_FORMAT_R32G32B32A32_SFLOAT, width, height, bytesOf(material));
    out.litRadiance = uploadTestImage(context, "test/lit", VK_FORMAT_R32G32B32A32_SFLOAT, width, height, bytesOf(lit));
    out.gbuffer.depth = asHostImage(out.depth);
    out.gbuffer.normal = asHostImage(out.normal);
    out.gbuffer.material = asHostImage(out.material);
    out.gbuffer.litRadiance = asHostImage(out.litRadiance);
    return out;
}

} // namespace glint::test
