// Hits beside edges: which surface covers a place between the centres of the pixels that show two of them, for each
// marcher.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include "reflect/trace/technique.hpp"

namespace glint::test {
namespace edge_test {

constexpr uint32_t kWidth = 481;
constexpr uint32_t kHeight = 270;

constexpr glm::vec3 kRed(1, 0, 0);
constexpr glm::vec3 kGreen(0, 1, 0);

/// A mirror at y = 0, as far as the horizon.
std::optional<SyntheticSurface> mirrorFloor(const glm::dvec3& origin, const glm::dvec3& direction) {
    SyntheticSurface floor;
    floor.distance = direction.y < 0 ? -origin.y / direction.y : 1e9;
    floor.f0 = glm::vec3(1);
    if (floor.distance > 1e8 || floor.distance < 1e-6)
        return std::nullopt;
    return floor;
}

/// A mirror floor before two tilted planes of different colours through one point: a ridge or a valley.
struct TwoFaces {
    bool ridge = true;
    glm::dvec3 pointWS = {0.1, 0, -2.5};
    glm::dvec3 normals[2] = {glm::normalize(glm::dvec3(-0.7, 0.1, 1)), glm::normalize(glm::dvec3(0.75, -0.2, 1))};

    std::optional<SyntheticSurface> operator()(const glm::dvec3& origin, const glm::dvec3& direction) const {
        double t[2];
        for (int i = 0; i < 2; ++i)
            t[i] = glm::dot(normals[i], pointWS - origin) / glm::dot(normals[i], direction);
        const int which = (t[0] < t[1]) == ridge ? 1 : 0; // a ridge: in front of both until the farther one
        const bool enters = glm::dot(normals[which], direction) < 0 && t[which] > 1e-6;
        const std::optional<SyntheticSurface> floor = mirrorFloor(origin, direction);
        if (enters && (!floor || t[which] < floor->distance))
            return SyntheticSurface{t[which], normals[which], glm::vec3(0), 0, which == 0 ? kRed : kGreen};
        return floor;
    }
};

/// A mirror floor before a tilted plate with slanted sides.
std::optional<SyntheticSurface> floorAndPlate(const glm::dvec3& origin, const glm::dvec3& direction) {
    const glm::dvec3 normal = glm::normalize(glm::dvec3(0.5, -0.4, 1));
    const glm::dvec3 center(0, 0.7, -2);
    const double t = glm::dot(normal, center - origin) / glm::dot(normal, direction);
    const glm::dvec3 p = origin + direction * t - center;
    const std::optional<SyntheticSurface> floor = mirrorFloor(origin, direction);
    if (t > 1e-6 && (!floor || t < floor->distance) && glm::dot(normal, direction) < 0 &&
        std::abs(p.x + 0.4 * p.y) < 0.5 && std::abs(p.y + 0.25 * p.x) < 0.4)
        return SyntheticSurface{t, normal, glm::vec3(0), 0, kRed};
    return floor;
}

class EdgeTest : public LibraryTest, public testing::WithParamInterface<size_t> {
protected:
    static const reflect::Technique& technique() { return reflect::techniques()[GetParam()]; }

    struct ReflectedRay {
        const SyntheticCamera& camera;
        glm::dvec3 startWS;
        glm::dvec3 dirWS;

        glm::dvec2 at(double distance) const { return camera.project(startWS + dirWS * distance, kWidth, kHeight); }
    };

    /// What the frame shows at the centre of a pixel.
    static std::optional<SyntheticSurface> shownAt(const SyntheticScene& scene, const SyntheticCamera& camera,
                                                   const glm::dvec2& px) {
        return scene(camera.position,
                     camera.rayThrough(static_cast<uint32_t>(px.x), static_cast<uint32_t>(px.y), kWidth, kHeight));
    }

    /// Calls `check(i, end, ray, shown)` for each mirror pixel whose exact ray ends on screen; `shown`: what the frame
    /// shows at the centre of the end's pixel.
    template <class Check>
    static void forEachEnd(const SyntheticScene& scene, const SyntheticCamera& camera, Check check) {
        for (uint32_t i = 0; i < kWidth * kHeight; ++i) {
            const glm::dvec3 direction = camera.rayThrough(i % kWidth, i / kWidth, kWidth, kHeight);
            const auto mirror = scene(camera.position, direction);
            if (!mirror || mirror->f0.x == 0)
                continue;
            const ReflectedRay ray{camera, camera.position + direction * mirror->distance,
                                   direction * glm::dvec3(1, -1, 1)};
            const auto end = scene(ray.startWS, ray.dirWS);
            if (!end)
                continue;
            const glm::dvec2 px = ray.at(end->distance);
            if (px.x < 1 || px.y < 1 || px.x > kWidth - 1.0 || px.y > kHeight - 1.0)
                continue;
            check(i, *end, ray, shownAt(scene, camera, px));
        }
    }
};

TEST_P(EdgeTest, creasesRunBetweenThePixels) {
    const SyntheticCamera camera;
    for (const bool ridge : {true, false}) {
        TwoFaces scene;
        scene.ridge = ridge;
        const Picture picture = trace(scene, camera, kWidth, kHeight, plainSettings(technique().march));
        size_t besides = 0; // the frame shows another face at the centre of the end's pixel
        size_t wrong = 0;
        forEachEnd(scene, camera, [&](uint32_t i, const SyntheticSurface& end, const ReflectedRay&, const auto& shown) {
            if (!picture.hit(i) || !shown || shown->f0.x > 0)
                return;
            besides += shown->radiance != end.radiance;
            wrong += glm::distance(picture.color(i), end.radiance) > 0.1f;
        });
        EXPECT_GT(besides, 20u) << ridge;
        EXPECT_LE(wrong * 10, besides) << ridge; // all of them when each hit takes the colour of its own pixel
    }
}

/// For marchers whose steps are no coarser than a pixel.
class FineEdgeTest : public EdgeTest {};

TEST_P(FineEdgeTest, raysMeetASurfaceUpToWhereTheyLeaveItsPixel) {
    const SyntheticCamera camera;
    const Picture picture = trace(floorAndPlate, camera, kWidth, kHeight, plainSettings(technique().march));
    size_t ends = 0; // in the last pixel on the ray's way that shows the plate
    size_t missed = 0;
    forEachEnd(floorAndPlate, camera,
               [&](uint32_t i, const SyntheticSurface& end, const ReflectedRay& ray, const auto& shown) {
                   if (end.f0.x > 0 || !shown || shown->f0.x > 0)
                       return;
                   const glm::dvec2 endPX = ray.at(end.distance);
                   const glm::dvec2 step = glm::normalize(ray.at(end.distance * 1.01) - endPX);
                   glm::dvec2 next = endPX; // a tenth of a pixel and less beyond the end's pixel
                   while (glm::floor(next) == glm::floor(endPX))
                       next += 0.1 * step;
                   if (shownAt(floorAndPlate, camera, next))
                       return;
                   ++ends;
                   missed += !picture.hit(i);
               });
    EXPECT_GT(ends, 50u);
    EXPECT_LE(missed * 10, ends) << missed << " of " << ends;
}

INSTANTIATE_TEST_SUITE_P(Registry, EdgeTest, testing::ValuesIn(techniquesWith([](const reflect::Technique& technique) {
                             return technique.walks;
                         })),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });
INSTANTIATE_TEST_SUITE_P(Registry, FineEdgeTest,
                         testing::ValuesIn(techniquesWith([](const reflect::Technique& technique) {
                             return technique.march == March::Hiz || technique.march == March::Linear;
                         })),
                         [](const auto& test) { return std::string(reflect::techniques()[test.param].name); });

} // namespace edge_test
} // namespace glint::test
