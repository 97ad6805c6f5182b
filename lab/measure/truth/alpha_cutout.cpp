#include "lab/measure/truth/alpha_cutout.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

int64_t wrapped(int64_t texel, int64_t size, scene::Wrap wrap) {
    switch (wrap) {
    case scene::Wrap::ClampToEdge: return std::clamp<int64_t>(texel, 0, size - 1);
    case scene::Wrap::Repeat: return ((texel % size) + size) % size;
    case scene::Wrap::MirroredRepeat: break;
    }
    const int64_t twice = ((texel % (2 * size)) + 2 * size) % (2 * size);
    return twice < size ? twice : 2 * size - 1 - twice;
}

double texelAlpha(const scene::Image& image, const scene::Sampler& sampler, int64_t x, int64_t y) {
    const auto column = static_cast<size_t>(wrapped(x, image.width, sampler.wrapU));
    const auto row = static_cast<size_t>(wrapped(y, image.height, sampler.wrapV));
    return image.rgba[4 * (row * image.width + column) + 3] / 255.0;
}

double sampleAlpha(const scene::Image& image, const scene::Sampler& sampler, const glm::dvec2& uv) {
    constexpr double kFarthest = 1e6; // repeats; beyond this, texel indices are meaningless
    const glm::dvec2 texel = glm::clamp(uv, -kFarthest, kFarthest) * glm::dvec2(image.width, image.height);
    if (sampler.magFilter == scene::Filter::Nearest)
        return texelAlpha(image, sampler, static_cast<int64_t>(std::floor(texel.x)),
                          static_cast<int64_t>(std::floor(texel.y)));
    const glm::dvec2 corner = glm::floor(texel - 0.5);
    const glm::dvec2 t = texel - 0.5 - corner;
    const auto x = static_cast<int64_t>(corner.x), y = static_cast<int64_t>(corner.y);
    const double above = glm::mix(texelAlpha(image, sampler, x, y), texelAlpha(image, sampler, x + 1, y), t.x);
    const double below = glm::mix(texelAlpha(image, sampler, x, y + 1), texelAlpha(image, sampler, x + 1, y + 1), t.x);
    return glm::mix(above, below, t.y);
}

template <class T>
T interpolated(const std::vector<T>& values, const scene::Geometry& geometry, const TrianglePoint& point,
               const T& absent) {
    if (values.empty())
        return absent;
    const uint32_t* corner = geometry.indices.data() + point.firstIndex;
    const auto u = static_cast<float>(point.u), v = static_cast<float>(point.v);
    return values[corner[0]] * (1 - u - v) + values[corner[1]] * u + values[corner[2]] * v;
}

double textureAlpha(const scene::Scene& scene, const scene::TextureSlot& slot, const scene::Geometry& geometry,
                    const TrianglePoint& point) {
    if (slot.texture < 0)
        return 1;
    const scene::Texture& texture = scene.textures[static_cast<size_t>(slot.texture)];
    if (texture.image < 0)
        return 1;
    const scene::Image& image = scene.images[static_cast<size_t>(texture.image)];
    if (image.rgba.empty())
        return 1;
    const size_t set = std::min<size_t>(slot.texCoord, scene::kMaxTexCoords - 1);
    const glm::vec2 uv = interpolated(geometry.uvs[set], geometry, point, glm::vec2(0));
    return sampleAlpha(image, texture.sampler, glm::dvec2(slot.uvTransform * glm::vec3(uv, 1)));
}

} // namespace

double baseAlpha(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
                 const TrianglePoint& point) {
    const glm::vec4 color = interpolated(geometry.colors, geometry, point, glm::vec4(1));
    return static_cast<double>(material.baseColorFactor.a) * static_cast<double>(color.a) *
           textureAlpha(scene, material.baseColorTexture, geometry, point);
}

bool isHole(const scene::Scene& scene, const scene::Material& material, const scene::Geometry& geometry,
            const TrianglePoint& point) {
    return material.alphaMode == scene::AlphaMode::Mask &&
           baseAlpha(scene, material, geometry, point) < static_cast<double>(material.alphaCutoff);
}

} // namespace glint::measure
