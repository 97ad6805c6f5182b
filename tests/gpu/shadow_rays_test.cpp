// rays.shadowRays: lights share shadow rays where the denoiser averages, without a change of the mean, and nowhere
// else.
#include "gpu/support/traced_surfaces.hpp"

#include <cmath>

namespace glint::test {
namespace shadow_rays_test {

constexpr uint32_t kSize = 40;
constexpr SyntheticCamera kEye = {.position = {0, 0, 3.5}, .target = {0, 0, 0}, .fovY = 0.55};
constexpr int kOneForEach = 256;

SurfaceMaterial matte() {
    SurfaceMaterial made = blackMatte();
    made.baseColorFactor = {0.6f, 0.6f, 0.6f, 1};
    return made;
}

SurfaceLight pointLight(const glm::vec3& positionWS, const glm::vec3& color) {
    SurfaceLight made;
    made.kind = SurfaceLightKind::Point;
    made.positionWS = {positionWS.x, positionWS.y, positionWS.z};
    made.color = {color.x, color.y, color.z};
    return made;
}

class ShadowRaysTest : public TracedSurfacesTest {
protected:
    /// A metal plate that shows a wall behind the camera, lit by three lamps.
    static SurfaceScene wallUnderThreeLamps(float perceptualRoughness, bool colored) {
        SurfaceScene made;
        made.addQuad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}, whiteMetal(perceptualRoughness));
        made.addQuad({20, -20, 6}, {-40, 0, 0}, {0, 40, 0}, matte());
        made.lights.push_back(pointLight({-3, 1, 4}, colored ? glm::vec3(30, 10, 5) : glm::vec3(30)));
        made.lights.push_back(pointLight({3, 1, 4}, colored ? glm::vec3(5, 20, 40) : glm::vec3(40)));
        made.lights.push_back(pointLight({0, -3, 3}, glm::vec3(25)));
        return made;
    }
    /// Hides the right lamp from most of the wall.
    static void addScreen(SurfaceScene& scene) { scene.addQuad({1.5f, -2, 4}, {0, 4, 0}, {0, 0, 1.5f}, matte()); }

    static Picture settled(const SurfaceScene& scene, int shadowRays, uint32_t frames, bool denoise = true) {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.shadowRays = shadowRays;
        settings.denoise.enabled = denoise;
        settings.denoise.firefly = 0; // takes light, by intent
        return lastFrame(scene, SurfaceScene::seenBy(scene), kEye, kSize, settings, frames);
    }

    static glm::vec3 reflected(const Picture& picture, size_t pixel) {
        return {picture.reflection[pixel * 4], picture.reflection[pixel * 4 + 1], picture.reflection[pixel * 4 + 2]};
    }
    static glm::dvec3 mean(const Picture& picture) {
        glm::dvec3 sum(0);
        for (size_t i = 0; i < picture.pixels(); ++i)
            sum += glm::dvec3(reflected(picture, i));
        return sum / double(picture.pixels());
    }
    /// Root mean square of the difference in green, over the mean.
    static double difference(const Picture& a, const Picture& b) {
        double sum = 0;
        for (size_t i = 0; i < a.pixels(); ++i)
            sum += std::pow(double(reflected(a, i).g) - double(reflected(b, i).g), 2);
        return std::sqrt(sum / double(a.pixels())) / mean(b).g;
    }
};

TEST_F(ShadowRaysTest, theMeanIsThatOfOneRayForEachLight) {
    for (const bool colored : {false, true}) {
        SurfaceScene scene = wallUnderThreeLamps(0.5f, colored);
        addScreen(scene);
        const Picture exact = settled(scene, kOneForEach, 30);
        for (const int shadowRays : {1, 2}) {
            const Picture shared = settled(scene, shadowRays, 30);
            std::cout << shadowRays << ": " << mean(shared).r << " " << mean(shared).b << " for " << mean(exact).r
                      << " " << mean(exact).b << "; difference " << difference(shared, exact) << "\n";
            EXPECT_GT(difference(shared, exact), 1e-4); // it acts
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(mean(shared)[channel], mean(exact)[channel], 0.02 * mean(exact)[channel]);
        }
    }
}

TEST_F(ShadowRaysTest, whereAllLightsAreVisibleThereIsNoNoise) {
    const SurfaceScene scene = wallUnderThreeLamps(0.5f, false);
    EXPECT_LT(difference(settled(scene, 1, 3), settled(scene, kOneForEach, 3)), 2e-3); // rounding to halves
}

TEST_F(ShadowRaysTest, mirrorsAndPicturesWithoutTheDenoiserAreExact) {
    for (const bool denoise : {true, false}) {
        SurfaceScene scene = wallUnderThreeLamps(denoise ? 0.f : 0.5f, true);
        addScreen(scene);
        EXPECT_EQ(settled(scene, 1, 3, denoise).reflection, settled(scene, kOneForEach, 3, denoise).reflection);
    }
}

} // namespace shadow_rays_test
} // namespace glint::test
