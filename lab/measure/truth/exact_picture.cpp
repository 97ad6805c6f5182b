#include "lab/measure/truth/exact_picture.hpp"

#include <algorithm>
#include <cmath>

namespace glint::measure {
namespace {

enum class Kind : uint8_t { Emission, Mirror };

Result<Kind> classify(const scene::Scene& scene, int index) {
    const scene::Material& material = scene.materials[static_cast<size_t>(index)];
    const bool textured = material.baseColorTexture.texture >= 0 || material.emissiveTexture.texture >= 0 ||
                          material.metallicRoughnessTexture.texture >= 0 || material.normalTexture.texture >= 0;
    const bool black = glm::vec3(material.baseColorFactor) == glm::vec3(0) && material.specularFactor == 0;
    if (!textured && black && material.transmissionFactor == 0 && material.clearcoatFactor == 0)
        return Kind::Emission;
    const bool white = glm::vec3(material.baseColorFactor) == glm::vec3(1);
    if (!textured && white && material.metallicFactor == 1 && material.roughnessFactor == 0 &&
        material.emissiveFactor == glm::vec3(0))
        return Kind::Mirror;
    return invalidInput("{}: material '{}' is neither pure emission nor a perfect mirror, so no exact picture exists",
                        scene.name, material.name);
}

float srgb(float linear) {
    const float x = std::clamp(linear, 0.0f, 1.0f);
    return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f; // IEC 61966-2-1
}

/// Camera rays through the pixels of a picture, and the pixels that points fall into.
class PictureRays {
public:
    PictureRays(const glm::mat4& worldToClip, uint32_t width, uint32_t height)
        : worldToClip_(worldToClip), clipToWorld_(glm::inverse(worldToClip_)), size_(width, height) {}

    struct Ray {
        glm::dvec3 originWS; ///< on the near plane
        glm::dvec3 directionWS;
    };

    /// `pixel`: from the top left, centres at .5.
    Ray through(const glm::dvec2& pixel) const {
        const glm::dvec2 ndc(pixel.x / size_.x * 2 - 1, 1 - pixel.y / size_.y * 2);
        const glm::dvec3 origin = unproject(ndc, 1); // reversed depth
        return {origin, glm::normalize(unproject(ndc, 0.5) - origin)};
    }

    /// Nothing where the camera does not look.
    std::optional<glm::dvec2> pixelOf(const glm::dvec3& positionWS) const {
        const glm::dvec4 clip = worldToClip_ * glm::dvec4(positionWS, 1);
        const glm::dvec2 pixel = glm::dvec2(clip.x / clip.w + 1, 1 - clip.y / clip.w) * 0.5 * size_;
        const bool inside =
            clip.w > 0 && clip.z <= clip.w && pixel.x >= 0 && pixel.y >= 0 && pixel.x < size_.x && pixel.y < size_.y;
        return inside ? std::optional(pixel) : std::nullopt;
    }

private:
    glm::dvec3 unproject(const glm::dvec2& ndc, double depth) const {
        const glm::dvec4 point = clipToWorld_ * glm::dvec4(ndc, depth, 1);
        return glm::dvec3(point) / point.w;
    }

    glm::dmat4 worldToClip_;
    glm::dmat4 clipToWorld_;
    glm::dvec2 size_;
};

/// Whether the camera's first hit along its ray to `positionWS` is there.
bool isSeen(const RayOracle& oracle, const PictureRays& rays, const glm::dvec2& pixel, const glm::dvec3& positionWS) {
    const PictureRays::Ray ray = rays.through(pixel);
    const double distance = glm::length(positionWS - ray.originWS);
    const std::optional<OracleHit> hit = oracle.trace(ray.originWS, ray.directionWS, 0);
    return hit && hit->distance > distance - 1e-3 * (1 + distance);
}

/// Largest difference of the channels' sRGB values, [0, 1].
float srgbDifference(const glm::vec3& a, const glm::vec3& b) {
    float largest = 0;
    for (int c = 0; c < 3; ++c)
        largest = std::max(largest, std::abs(srgb(a[c]) - srgb(b[c])));
    return largest;
}

} // namespace

Result<ExactPicture> exactPicture(const scene::Scene& scene, const scene::Pose& pose, const glm::mat4& worldToClip,
                                  uint32_t width, uint32_t height, uint32_t maxBounces) {
    std::vector<Kind> kinds(scene.materials.size(), Kind::Emission);
    for (const scene::DrawItem& item : pose.items) {
        if (item.material < 0)
            return invalidInput("{}: a surface has the default material, so no exact picture exists", scene.name);
        GLINT_TRY(kind, classify(scene, item.material));
        kinds[static_cast<size_t>(item.material)] = kind;
    }
    GLINT_TRY(oracle, RayOracle::create(scene, pose));

    ExactPicture picture;
    picture.width = width;
    picture.height = height;
    const PictureRays rays(worldToClip, width, height);
    std::vector<std::optional<glm::dvec2>> ends; // of paths of one bounce, in pixels, where the camera sees them
    for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
            auto [origin, direction] = rays.through(glm::dvec2(x, y) + 0.5);
            glm::vec3 radiance(0);
            uint8_t bounces = 0;
            double minDistance = 0;
            std::optional<glm::dvec2> end;
            for (;;) {
                const std::optional<OracleHit> hit = oracle.trace(origin, direction, minDistance);
                if (!hit)
                    break;
                if (kinds[static_cast<size_t>(hit->material)] == Kind::Emission) {
                    radiance = scene.materials[static_cast<size_t>(hit->material)].emissiveFactor;
                    end = bounces == 1 ? rays.pixelOf(hit->positionWS) : std::nullopt;
                    if (end && !isSeen(oracle, rays, *end, hit->positionWS))
                        end.reset();
                    break;
                }
                if (bounces == maxBounces)
                    break;
                ++bounces;
                origin = hit->positionWS;
                direction = glm::normalize(glm::reflect(direction, hit->normalWS));
                // Starts behind the mirror itself, by the uncertainty of single precision at this distance.
                minDistance = 1e-4 * (1 + 0.1 * hit->distance);
            }
            picture.radiance.push_back(radiance);
            picture.withoutMirrors.push_back(bounces == 0 ? radiance : glm::vec3(0));
            picture.bounces.push_back(bounces);
            ends.push_back(end);
        }
    for (const std::optional<glm::dvec2>& end : ends) {
        picture.endSeen.push_back(end ? 1 : 0);
        picture.readInFrame.push_back(
            end ? picture.withoutMirrors[static_cast<size_t>(end->y) * width + static_cast<size_t>(end->x)]
                : glm::vec3(0));
    }
    return picture;
}

MirrorError compareMirrors(const ExactPicture& exact, std::span<const float> rgba) {
    constexpr float kChanged = 0.5f / 255;
    constexpr float kWrong = 24.0f / 255;
    MirrorError error;
    for (size_t i = 0; i < exact.radiance.size() && 4 * i + 2 < rgba.size(); ++i) {
        if (srgbDifference(exact.radiance[i], exact.withoutMirrors[i]) <= kChanged)
            continue;
        const glm::vec3 drawn(rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]);
        const bool wrong = srgbDifference(exact.radiance[i], drawn) > kWrong;
        ++error.mirrorPixels;
        error.wrongPixels += wrong;
        if (error.byBounces.size() < exact.bounces[i])
            error.byBounces.resize(exact.bounces[i]);
        MirrorError::ByBounces& alike = error.byBounces[exact.bounces[i] - 1u];
        ++alike.pixels;
        alike.wrong += wrong;
        if (exact.bounces[i] == 1) {
            ++error.oneBouncePixels;
            error.oneBounceWrong += wrong;
            const bool wrongInFrame = srgbDifference(exact.radiance[i], exact.readInFrame[i]) > kWrong;
            error.oneBounceWrongInFrame += wrongInFrame;
            error.oneBounceUnseen += wrongInFrame && !exact.endSeen[i];
        }
    }
    return error;
}

} // namespace glint::measure
