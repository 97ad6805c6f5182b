// The colour of a hit where the mirror shows the frame's pixels larger than the eye sees them.
#include "gpu/support/library_test.hpp"

#include <cmath>

namespace glint::test {
namespace hit_color_test {

constexpr double kWallX = -0.5;

/// A wall beside the view, seen nearly edge-on, whose radiance is its distance. A mirror on the right shows the wall
/// from the front: a pixel of the wall fills two to three of the mirror's.
std::optional<SyntheticSurface> wallInMirror(const glm::dvec3& origin, const glm::dvec3& direction) {
    const double toWall = direction.x < 0 ? (kWallX - origin.x) / direction.x : 1e9;
    const glm::dvec3 mirrorNormal = glm::normalize(glm::dvec3(-1, 0, 1));
    const double toMirror = glm::dot(glm::dvec3(0, 0, -2.5) - origin, mirrorNormal) / glm::dot(direction, mirrorNormal);
    SyntheticSurface hit;
    if (toWall < 1e8) {
        hit.distance = toWall;
        hit.normalWS = {1, 0, 0};
        hit.radiance = glm::vec3(float(-(origin + direction * toWall).z));
        return toWall < 100 ? std::optional(hit) : std::nullopt;
    }
    if (toMirror <= 0 || toMirror > 100)
        return std::nullopt;
    hit.distance = toMirror;
    hit.normalWS = mirrorNormal;
    hit.f0 = glm::vec3(1);
    return hit;
}

class HitColorTest : public LibraryTest, public testing::WithParamInterface<March> {};

TEST_P(HitColorTest, MagnifiedTexelsAreBlended) {
    SyntheticCamera camera;
    camera.position = {0, 0, 0};
    camera.target = {0, 0, -1};
    constexpr uint32_t kWidth = 160;
    constexpr uint32_t kHeight = 90;
    const Picture picture = trace(wallInMirror, camera, kWidth, kHeight, plainSettings(GetParam()));
    const double tangent = std::tan(camera.fovY / 2) * kWidth / kHeight;
    double worst = 0;
    size_t compared = 0;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = kWidth / 2; x < kWidth; ++x) {
            const size_t pixel = size_t(y) * kWidth + x;
            if (!picture.hit(pixel))
                continue;
            // The wall's distance at the exact place of the hit.
            const double across = (picture.hitPX(pixel).x / kWidth * 2 - 1) * tangent;
            worst = std::max(worst, std::abs(double(picture.color(pixel).x) - kWallX / across));
            ++compared;
        }
    EXPECT_GT(compared, 2000u);
    // A texel of the wall spans up to 0.1 m: the nearest texel alone would be wrong by half of that. A pixel of the
    // mirror spans 0.028 m; where a texel spans less, the nearest suffices.
    EXPECT_LT(worst, 0.014);
}

INSTANTIATE_TEST_SUITE_P(Marchers, HitColorTest, testing::Values(March::Linear, March::Adaptive, March::Hiz));

} // namespace hit_color_test
} // namespace glint::test
