// The oracle of rays sees what the raster pass draws: no back faces of single-sided surfaces, no holes, nothing
// blended.
#include "lab/measure/truth/ray_oracle.hpp"

#include "lab/measure/truth/alpha_cutout.hpp"
#include "lab/scene/builtin/scene_builder.hpp"
#include "lab/scene/builtin/shapes.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace glint::measure {
namespace ray_oracle_test {

using namespace scene::builtin;

/// 2 x 2 texels: opaque where x == y, holes elsewhere.
scene::Image checker() {
    return {"checker", 2, 2, {9, 9, 9, 255, 9, 9, 9, 0, 9, 9, 9, 0, 9, 9, 9, 255}};
}

/// A 2 m square in the plane z = `z` that faces +Z, uv (0, 0) at its top left, over the whole texture.
scene::Geometry square(float z) {
    scene::Geometry g;
    g.positions = {{-1, 1, z}, {-1, -1, z}, {1, -1, z}, {1, 1, z}};
    g.normals.assign(4, {0, 0, 1});
    g.uvs[0] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}};
    g.indices = {0, 1, 2, 0, 2, 3};
    return g;
}

struct Traced {
    scene::Scene scene;
    scene::Pose pose;
    std::optional<RayOracle> oracle;

    explicit Traced(SceneBuilder& builder) : scene(builder.take()) {
        pose = std::move(scene::pose(scene, 0)).value();
        oracle.emplace(std::move(RayOracle::create(scene, pose)).value());
    }
    /// The distance of the hit from z = 5 straight down -Z (or from z = -5 up), 0: none.
    double distance(double x, double y, double side = 1) const {
        const auto hit = oracle->trace({x, y, 5 * side}, {0, 0, -side}, 0);
        return hit ? hit->distance : 0;
    }
};

scene::Material masked(SceneBuilder& b) {
    scene::Material material = dielectric("leaf", glm::vec3(1), 1);
    material.alphaMode = scene::AlphaMode::Mask;
    material.baseColorTexture = b.texture(checker());
    return material;
}

TEST(RayOracle, HolesAndTheBacksOfSingleSidedSurfacesLetRaysThrough) {
    SceneBuilder b("test");
    b.add("leaf", square(2), b.material(masked(b)));
    b.add("wall", square(0), b.material(dielectric("wall", glm::vec3(1), 1)));
    const Traced traced(b);
    EXPECT_DOUBLE_EQ(traced.distance(-0.5, 0.5), 3);  // an opaque texel
    EXPECT_DOUBLE_EQ(traced.distance(0.5, 0.5), 5);   // a hole
    EXPECT_DOUBLE_EQ(traced.distance(-0.5, -0.5), 5); // a hole
    EXPECT_DOUBLE_EQ(traced.distance(0.5, -0.5), 3);
    EXPECT_EQ(traced.distance(-0.5, 0.5, -1), 0); // both from behind
}

TEST(RayOracle, DoubleSidedSurfacesAreMetFromBehindAndBlendedOnesNever) {
    SceneBuilder b("test");
    scene::Material sheet = masked(b);
    sheet.doubleSided = true;
    b.add("sheet", square(0), b.material(sheet));
    scene::Material glass = dielectric("glass", glm::vec3(1), 0);
    glass.alphaMode = scene::AlphaMode::Blend;
    b.add("glass", square(2), b.material(glass));
    const Traced traced(b);
    EXPECT_DOUBLE_EQ(traced.distance(-0.5, 0.5, -1), 5);
    EXPECT_DOUBLE_EQ(traced.distance(-0.5, 0.5), 5);
    EXPECT_EQ(traced.distance(0.5, 0.5, -1), 0);
    const auto hit = traced.oracle->trace({-0.5, 0.5, -5}, {0, 0, 1}, 0);
    EXPECT_FALSE(hit->frontFace);
    EXPECT_EQ(hit->geometricNormalWS, glm::dvec3(0, 0, -1)); // towards where the ray came from
}

TEST(AlphaCutout, FiltersWrapsAndMultipliesAsTheRasterPassDoes) {
    scene::Scene scene;
    scene.images = {checker()};
    scene.textures = {{0, {}}};
    scene::Geometry g = square(0);
    scene::Material material;
    material.alphaMode = scene::AlphaMode::Mask;
    material.baseColorTexture.texture = 0;
    const auto alpha = [&](double u, double v) { return baseAlpha(scene, material, g, {0, u, v}); };
    // The first triangle's corners have uv (0, 0), (0, 1) and (1, 1).
    const auto at = [&](double x, double y) { return alpha(y - x, x); };
    EXPECT_NEAR(at(0.25, 0.25), 1, 1e-6);
    EXPECT_NEAR(at(0.25, 0.75), 0, 1e-6);
    EXPECT_NEAR(at(0.5, 0.5), 0.5, 1e-6); // between four texels
    EXPECT_NEAR(at(0.25, 0.5), 0.5, 1e-6);
    EXPECT_NEAR(at(0, 0.25), 0.5, 1e-6); // half of it beyond the border, which repeats

    scene.textures[0].sampler.wrapU = scene::Wrap::ClampToEdge;
    EXPECT_NEAR(at(0, 0.25), 1, 1e-6);
    scene.textures[0].sampler.wrapU = scene::Wrap::MirroredRepeat;
    EXPECT_NEAR(at(0, 0.25), 1, 1e-6);
    scene.textures[0].sampler.magFilter = scene::Filter::Nearest;
    EXPECT_NEAR(at(0.49, 0.49), 1, 1e-6);
    EXPECT_NEAR(at(0.49, 0.51), 0, 1e-6);

    material.baseColorFactor.a = 0.5f;
    g.colors.assign(4, glm::vec4(1, 1, 1, 0.5f));
    EXPECT_NEAR(at(0.25, 0.25), 0.25, 1e-6);
    EXPECT_TRUE(isHole(scene, material, g, {0, 0, 0.25}));
    material.alphaCutoff = 0.2f;
    EXPECT_FALSE(isHole(scene, material, g, {0, 0, 0.25}));
    material.alphaMode = scene::AlphaMode::Opaque;
    EXPECT_FALSE(isHole(scene, material, g, {0, 0.5, 0.25}));
}

} // namespace ray_oracle_test
} // namespace glint::measure
