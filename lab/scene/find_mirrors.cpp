#include "lab/scene/find_mirrors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

namespace glint::render {
namespace {

constexpr float kSmooth = 0.35f;       ///< perceptual roughness, at most
constexpr float kLarge = 0.004f;       ///< of the square of the scene's diagonal
constexpr float kFilled = 0.1f;        ///< minimum fraction of its rectangle that a mirror covers
constexpr float kSamePlane = 2e-4f;    ///< of the scene's diagonal
constexpr float kSameNormal = 1e-4f;   ///< 1 - cosine: 0.8 degrees
constexpr float kWorthMerging = 0.02f; ///< of kLarge: smaller pieces are not merged

/// Triangles in one plane.
struct Patch {
    glm::vec3 normal = glm::vec3(0);
    float offset = 0; ///< dot(normal, position)
    double area = 0;
    bool named = false;
    std::vector<glm::vec3> corners; ///< three per triangle

    void add(const Patch& other) {
        area += other.area;
        named |= other.named;
        corners.insert(corners.end(), other.corners.begin(), other.corners.end());
    }
};

/// Mean of a texture channel over some of its texels.
float meanOf(const scene::Image& image, size_t channel) {
    const size_t texels = image.rgba.size() / 4;
    // Odd, so that images with sides of 2^n are not always sampled in the same columns.
    const size_t step = (texels / 4096) | 1;
    double sum = 0;
    size_t count = 0;
    for (size_t i = 0; i < texels; i += step, ++count)
        sum += image.rgba[i * 4 + channel];
    return count == 0 ? 1 : static_cast<float>(sum / (255.0 * static_cast<double>(count)));
}

class Finder {
public:
    Finder(const scene::Scene& scene, const scene::Pose& pose, MirrorSearch search)
        : scene_(scene), pose_(pose), search_(search) {
        const scene::Bounds& all = pose.boundsWS;
        diagonal_ = all.empty() ? 0 : glm::length(all.max - all.min);
        for (const scene::Material& material : scene.materials)
            wanted_.push_back(wants(material));
    }

    std::vector<PlanarMirror> run(size_t most) {
        if (!(diagonal_ > 0))
            return {};
        for (const scene::DrawItem& item : pose_.items)
            addItem(item);
        std::vector<Patch> patches = merged();
        std::vector<PlanarMirror> mirrors;
        for (const Patch& patch : patches) {
            if (mirrors.size() >= most)
                break;
            if (const std::optional<PlanarMirror> mirror = rectangle(patch))
                mirrors.push_back(*mirror);
        }
        return mirrors;
    }

private:
    enum class Wanted { No, IfLarge, Named };

    /// Of the smoothest lobe.
    float roughnessOf(const scene::Material& material) const {
        const auto mean = [&](const scene::TextureSlot& slot, size_t channel) {
            if (slot.texture < 0)
                return 1.0f;
            const int image = scene_.textures[static_cast<size_t>(slot.texture)].image;
            return image < 0 ? 1.0f : meanOf(scene_.images[static_cast<size_t>(image)], channel);
        };
        const float coat = material.clearcoatFactor > 0
                               ? material.clearcoatRoughnessFactor * mean(material.clearcoatRoughnessTexture, 1)
                               : 1.0f;
        if (material.specularGlossiness)
            return std::min(1 - material.glossinessFactor * mean(material.specularGlossinessTexture, 3), coat);
        return std::min(material.roughnessFactor * mean(material.metallicRoughnessTexture, 1), coat);
    }

    Wanted wants(const scene::Material& material) const {
        if (search_ == MirrorSearch::None || material.alphaMode == scene::AlphaMode::Blend ||
            material.transmissionFactor > 0)
            return Wanted::No;
        if (material.planarMirror)
            return *material.planarMirror ? Wanted::Named : Wanted::No;
        const bool looks = search_ == MirrorSearch::Auto && !material.unlit && roughnessOf(material) <= kSmooth;
        return looks ? Wanted::IfLarge : Wanted::No;
    }

    void addItem(const scene::DrawItem& item) {
        const scene::Geometry& g = *item.geometry;
        if (item.material < 0 || g.topology != scene::Topology::Triangles)
            return;
        const Wanted wanted = wanted_[static_cast<size_t>(item.material)];
        if (wanted == Wanted::No)
            return;
        const bool twoSided = scene_.materials[static_cast<size_t>(item.material)].doubleSided;
        const float winding = glm::determinant(glm::mat3(item.localToWorld)) < 0 ? -1.0f : 1.0f;
        const auto at = [&](size_t i) {
            return glm::vec3(item.localToWorld * glm::vec4(g.positions[g.indices[i]], 1));
        };
        for (size_t i = 0; i + 2 < g.indices.size(); i += 3) {
            const std::array<glm::vec3, 3> corners = {at(i), at(i + 1), at(i + 2)};
            const glm::vec3 across = glm::cross(corners[1] - corners[0], corners[2] - corners[0]) * winding;
            addTriangle(corners, across, wanted == Wanted::Named);
            if (twoSided)
                addTriangle(corners, -across, wanted == Wanted::Named);
        }
    }

    void addTriangle(const std::array<glm::vec3, 3>& corners, const glm::vec3& across, bool named) {
        const float twice = glm::length(across);
        if (!(twice > 1e-12f * diagonal_ * diagonal_) || !std::isfinite(twice))
            return;
        Patch patch;
        patch.normal = across / twice;
        patch.offset = glm::dot(patch.normal, corners[0]);
        patch.area = 0.5 * static_cast<double>(twice);
        patch.named = named;
        patch.corners.assign(corners.begin(), corners.end());
        const glm::ivec3 direction(glm::round(patch.normal * 512.0f));
        const Key key = {direction.x, direction.y, direction.z,
                         static_cast<int>(std::lround(patch.offset / (4 * kSamePlane * diagonal_)))};
        const auto [found, isNew] = patches_.try_emplace(key, patch);
        if (!isNew)
            found->second.add(patch);
    }

    /// Merges patches of neighbouring keys that are in one plane; returns the best first.
    std::vector<Patch> merged() {
        const double large = static_cast<double>(kLarge) * diagonal_ * diagonal_;
        std::vector<Patch> pieces;
        for (auto& [key, patch] : patches_)
            if (patch.named || patch.area >= kWorthMerging * large)
                pieces.push_back(std::move(patch));
        const auto better = [](const Patch& a, const Patch& b) {
            return a.named != b.named ? a.named : a.area > b.area;
        };
        std::ranges::stable_sort(pieces, better);
        std::vector<Patch> result;
        for (const Patch& piece : pieces) {
            const auto same = std::ranges::find_if(result, [&](const Patch& other) {
                return 1 - glm::dot(other.normal, piece.normal) < kSameNormal &&
                       std::abs(glm::dot(other.normal, piece.corners[0]) - other.offset) < kSamePlane * diagonal_;
            });
            if (same != result.end())
                same->add(piece);
            else
                result.push_back(piece);
        }
        std::erase_if(result, [&](const Patch& patch) { return !patch.named && patch.area < large; });
        std::ranges::stable_sort(result, better);
        return result;
    }

    /// Extent in the patch's plane, along `tangent`.
    struct Extent {
        glm::vec3 tangent;
        glm::vec2 low = glm::vec2(std::numeric_limits<float>::max());
        glm::vec2 high = glm::vec2(std::numeric_limits<float>::lowest());
        float area() const { return (high.x - low.x) * (high.y - low.y); }
    };
    static Extent extentAlong(const Patch& patch, const glm::vec3& tangent) {
        const glm::vec3 bitangent = glm::cross(patch.normal, tangent);
        Extent extent = {tangent};
        for (const glm::vec3& corner : patch.corners) {
            const glm::vec2 at(glm::dot(corner, tangent), glm::dot(corner, bitangent));
            extent.low = glm::min(extent.low, at);
            extent.high = glm::max(extent.high, at);
        }
        return extent;
    }

    /// Returns the smallest rectangle around all corners with a side along one of the first triangles' edges. Returns
    /// no value if the triangles fill too little of it, as the tops of many objects of one height would.
    std::optional<PlanarMirror> rectangle(const Patch& patch) const {
        constexpr size_t kMostEdges = 12;
        std::optional<Extent> best;
        for (size_t i = 0; i < std::min(patch.corners.size(), kMostEdges); ++i) {
            const glm::vec3 edge = patch.corners[i % 3 == 2 ? i - 2 : i + 1] - patch.corners[i];
            const glm::vec3 along = edge - patch.normal * glm::dot(edge, patch.normal);
            if (!(glm::dot(along, along) > 0))
                continue;
            const Extent extent = extentAlong(patch, glm::normalize(along));
            if (!best || extent.area() < best->area())
                best = extent;
        }
        if (!best || (!patch.named && patch.area < static_cast<double>(kFilled * best->area())))
            return std::nullopt;
        const glm::vec2 half = glm::max((best->high - best->low) * 0.5f, glm::vec2(1e-6f * diagonal_));
        const glm::vec2 middle = (best->low + best->high) * 0.5f;
        const glm::vec3 center =
            best->tangent * middle.x + glm::cross(patch.normal, best->tangent) * middle.y + patch.normal * patch.offset;
        PlanarMirror mirror;
        mirror.centerWS = {center.x, center.y, center.z};
        mirror.normalWS = {patch.normal.x, patch.normal.y, patch.normal.z};
        mirror.tangentWS = {best->tangent.x, best->tangent.y, best->tangent.z};
        mirror.halfExtents = {half.x, half.y};
        return mirror;
    }

    using Key = std::array<int, 4>;

    const scene::Scene& scene_;
    const scene::Pose& pose_;
    MirrorSearch search_;
    float diagonal_ = 0;
    std::vector<Wanted> wanted_; ///< by material
    std::map<Key, Patch> patches_;
};

} // namespace

std::vector<PlanarMirror> findMirrors(const scene::Scene& scene, const scene::Pose& pose, MirrorSearch search,
                                      size_t most) {
    if (search == MirrorSearch::None)
        return {};
    return Finder(scene, pose, search).run(std::min<size_t>(most, kMaxPlanarMirrors));
}

} // namespace glint::render
