// A mirror shows a rough surface as bright as an eye behind the mirror sees it: a path's further bounces weigh the
// directions of a lobe as its first bounce does.
#include "gpu/support/scenes.hpp"
#include "gpu/support/traced_surfaces.hpp"

#include <cmath>

namespace glint::test {
namespace seen_in_mirrors_test {

constexpr uint32_t kSize = 48;
constexpr float kWallZ = 5;
constexpr SyntheticCamera kEye = {.position = {0, 0, 3.5}, .target = {0, 0, 0}, .fovY = 0.55};
constexpr SyntheticCamera kEyeBehind = {.position = {0, 0, -3.5}, .target = {0, 0, 0}, .fovY = 0.55};

/// A rough metal wall, lit from the side: facets hinder light that comes along the wall.
SurfaceScene wallBesideALamp(float perceptualRoughness) {
    SurfaceScene made;
    made.addQuad({20, -20, kWallZ}, {-40, 0, 0}, {0, 40, 0}, whiteMetal(perceptualRoughness));
    made.addQuad({6, -20, 0}, {0, 0, kWallZ}, {0, 40, 0}, emitting({1, 1, 1}));
    return made;
}

class SeenInMirrorsTest : public TracedSurfacesTest {
protected:
    static Settings pathsOfTwo() {
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.bounces = 2;
        settings.rays.regularization = 0;
        settings.rays.reuseLight = false;
        return settings;
    }
    static Settings many(bool sampleLights) {
        Settings settings = pathsOfTwo();
        settings.rays.samples = 256; // standard error 0.3 %
        settings.rays.sampleLights = sampleLights;
        return settings;
    }

    /// Mean over the picture of the light that is reflected to the camera, in the last frame.
    static double meanReflection(const SurfaceScene& scene, const SyntheticScene& shown, const SyntheticCamera& camera,
                                 const Settings& settings, uint32_t frames = 1) {
        const Picture picture = lastFrame(scene, shown, camera, kSize, settings, frames);
        double sum = 0;
        for (size_t i = 0; i < picture.reflection.size(); i += 4)
            sum += double(picture.reflection[i]) / double(picture.pixels());
        return sum;
    }
};

TEST_F(SeenInMirrorsTest, roughSurfacesAreAsBrightAsWithoutTheMirror) {
    for (const float perceptualRoughness : {0.5f, 0.9f})
        for (const bool sampleLights : {false, true}) {
            const SurfaceScene scene = wallBesideALamp(perceptualRoughness);
            const double inMirror = meanReflection(scene, flatMirror, kEye, many(sampleLights));
            const double direct = meanReflection(scene, SurfaceScene::seenBy(scene), kEyeBehind, many(sampleLights));
            std::cout << "roughness " << perceptualRoughness << ": " << inMirror << " in the mirror, " << direct
                      << " without it\n";
            EXPECT_NEAR(inMirror, direct, 0.01 * direct) << perceptualRoughness << " " << sampleLights;
        }
}

/// Neighbours' rays count by what the facets let pass, and a ratio of such sums is biased where that depends on the
/// light: over frames the sums are divided, and not the ratios averaged.
TEST_F(SeenInMirrorsTest, theDenoiserKeepsThatBrightness) {
    Settings denoised = pathsOfTwo();
    denoised.denoise.enabled = true;
    denoised.denoise.firefly = 0; // takes light, by intent
    for (const float perceptualRoughness : {0.7f, 0.9f}) {
        const SurfaceScene scene = wallBesideALamp(perceptualRoughness);
        const SyntheticScene wall = SurfaceScene::seenBy(scene);
        const double truth = meanReflection(scene, wall, kEyeBehind, many(false));
        const double direct = meanReflection(scene, wall, kEyeBehind, denoised, 30);
        const double inMirror = meanReflection(scene, flatMirror, kEye, denoised, 30);
        std::cout << "roughness " << perceptualRoughness << ": " << truth << ", denoised " << direct
                  << ", in the mirror " << inMirror << "\n";
        EXPECT_NEAR(direct, truth, 0.02 * truth) << perceptualRoughness;
        EXPECT_NEAR(inMirror, truth, 0.03 * truth) << perceptualRoughness;
    }
}

} // namespace seen_in_mirrors_test
} // namespace glint::test
