// Which flat surfaces become planar mirrors.
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/find_mirrors.hpp"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace find_mirrors_test {

/// A square of `side` metres about the origin in the plane y = 0, of `cells` squares a side, facing up.
scene::Geometry square(float side, int cells) {
    scene::Geometry g;
    for (int z = 0; z <= cells; ++z)
        for (int x = 0; x <= cells; ++x)
            g.positions.push_back((glm::vec3(float(x), 0, float(z)) / float(cells) - glm::vec3(0.5f, 0, 0.5f)) * side);
    const auto at = [&](int x, int z) { return static_cast<uint32_t>(z * (cells + 1) + x); };
    for (int z = 0; z < cells; ++z)
        for (int x = 0; x < cells; ++x)
            for (const uint32_t i :
                 {at(x, z), at(x, z + 1), at(x + 1, z), at(x + 1, z), at(x, z + 1), at(x + 1, z + 1)})
                g.indices.push_back(i);
    return g;
}

class FindMirrors : public testing::Test {
protected:
    FindMirrors() {
        scene_.materials.resize(2);
        scene_.materials[0].roughnessFactor = 0.1f;
        scene_.materials[1].roughnessFactor = 0.8f;
        pose_.boundsWS = {glm::vec3(-5, 0, -5), glm::vec3(5, 3, 5)};
    }
    void add(const scene::Geometry& geometry, int material, const glm::mat4& localToWorld = glm::mat4(1)) {
        scene::DrawItem item;
        item.geometry = &geometry;
        item.material = material;
        item.localToWorld = localToWorld;
        pose_.items.push_back(item);
    }
    std::vector<PlanarMirror> find(MirrorSearch search = MirrorSearch::Auto, size_t most = 8) const {
        return findMirrors(scene_, pose_, search, most);
    }

    scene::Scene scene_;
    scene::Pose pose_;
    scene::Geometry floor_ = square(10, 7);
    scene::Geometry tile_ = square(1, 1);
};

TEST_F(FindMirrors, aSmoothFloorIsOneWithItsTrueOutline) {
    const float angle = 0.3f;
    add(floor_, 0, glm::rotate(glm::mat4(1), angle, glm::vec3(0, 1, 0)));
    const std::vector<PlanarMirror> mirrors = find();
    ASSERT_EQ(mirrors.size(), 1u);
    EXPECT_NEAR(mirrors[0].normalWS[1], 1, 1e-6);
    EXPECT_NEAR(mirrors[0].centerWS[0], 0, 1e-4);
    EXPECT_NEAR(mirrors[0].centerWS[2], 0, 1e-4);
    EXPECT_NEAR(mirrors[0].halfExtents[0], 5, 1e-3);
    EXPECT_NEAR(mirrors[0].halfExtents[1], 5, 1e-3);
    const double turn = std::atan2(-double(mirrors[0].tangentWS[2]), double(mirrors[0].tangentWS[0]));
    EXPECT_NEAR(std::abs(std::remainder(turn - double(angle), 1.5707963)), 0, 1e-4); // along its sides
    EXPECT_TRUE(find(MirrorSearch::None).empty());
    EXPECT_TRUE(find(MirrorSearch::Named).empty());
}

TEST_F(FindMirrors, roughSmallAndClearSurfacesAreNone) {
    add(floor_, 1);
    add(tile_, 0, glm::translate(glm::mat4(1), {0, 1, 0}) * glm::scale(glm::mat4(1), glm::vec3(0.5f)));
    EXPECT_TRUE(find().empty());
    scene_.materials[1].roughnessFactor = 0.1f;
    EXPECT_EQ(find().size(), 1u);
    scene_.materials[1].transmissionFactor = 1;
    EXPECT_TRUE(find().empty());
}

TEST_F(FindMirrors, aTexturesMeanCounts) {
    scene::Image image;
    image.width = image.height = 64;
    image.rgba.assign(64 * 64 * 4, 20);
    for (size_t row = 0; row < 64; ++row) // a rough joint in every column that a careless step of 64 would hit
        image.rgba[row * 64 * 4 + 1] = 255;
    scene_.images.push_back(image);
    scene_.textures.push_back({0, {}});
    scene_.materials[1].roughnessFactor = 1;
    scene_.materials[1].metallicRoughnessTexture.texture = 0;
    add(floor_, 1);
    EXPECT_EQ(find().size(), 1u);
}

TEST_F(FindMirrors, coplanarPiecesAreOneAndBothSidesOfASheetAreTwo) {
    for (const float x : {-3.f, -1.5f, 0.f, 1.5f, 3.f})
        add(tile_, 0, glm::translate(glm::mat4(1), {x, 1, 0}));
    std::vector<PlanarMirror> mirrors = find();
    ASSERT_EQ(mirrors.size(), 1u);
    EXPECT_NEAR(std::max(mirrors[0].halfExtents[0], mirrors[0].halfExtents[1]), 3.5, 1e-4);
    scene_.materials[0].doubleSided = true;
    mirrors = find();
    ASSERT_EQ(mirrors.size(), 2u);
    EXPECT_NEAR(mirrors[0].normalWS[1], -mirrors[1].normalWS[1], 1e-6);
}

TEST_F(FindMirrors, aMirroredInstanceFacesTheWayItIsSeen) {
    add(floor_, 0, glm::scale(glm::mat4(1), {-1, 1, 1})); // a flip across x: its triangles turn the other way round
    const std::vector<PlanarMirror> mirrors = find();
    ASSERT_EQ(mirrors.size(), 1u);
    EXPECT_NEAR(mirrors[0].normalWS[1], 1, 1e-6);
}

TEST_F(FindMirrors, theSceneHasTheLastWord) {
    scene_.materials[0].planarMirror = false;
    scene_.materials[1].planarMirror = true;
    add(floor_, 0);
    add(tile_, 1, glm::translate(glm::mat4(1), {0, 1, 0}) * glm::scale(glm::mat4(1), glm::vec3(0.1f)));
    for (const MirrorSearch search : {MirrorSearch::Named, MirrorSearch::Auto}) {
        const std::vector<PlanarMirror> mirrors = find(search);
        ASSERT_EQ(mirrors.size(), 1u);
        EXPECT_NEAR(mirrors[0].halfExtents[0], 0.05, 1e-5);
    }
}

TEST_F(FindMirrors, namedOnesComeFirstThenTheLargest) {
    scene_.materials[1].planarMirror = true;
    add(tile_, 0, glm::translate(glm::mat4(1), {0, 2, 0}) * glm::scale(glm::mat4(1), glm::vec3(3)));
    add(floor_, 0);
    add(tile_, 1, glm::translate(glm::mat4(1), {0, 1, 0}));
    const std::vector<PlanarMirror> mirrors = find(MirrorSearch::Auto, 2);
    ASSERT_EQ(mirrors.size(), 2u);
    EXPECT_NEAR(mirrors[0].halfExtents[0], 0.5, 1e-5);
    EXPECT_NEAR(mirrors[1].halfExtents[0], 5, 1e-3);
}

TEST_F(FindMirrors, brokenGeometryIsNone) {
    scene::Geometry broken = square(4, 1);
    broken.positions[0].x = std::numeric_limits<float>::quiet_NaN();
    scene::Geometry flat = square(0, 3);
    add(broken, 0);
    add(flat, 0);
    for (const PlanarMirror& mirror : find())
        for (const float value : mirror.halfExtents)
            EXPECT_TRUE(std::isfinite(value));
    pose_.boundsWS = {};
    EXPECT_TRUE(find().empty());
}

TEST(FindMirrorsOf, theHallItsFloorAndTheMirrorOnItsWall) {
    const auto scene = scene::builtinScene("hall");
    ASSERT_TRUE(scene);
    const auto pose = scene::pose(*scene, 0);
    ASSERT_TRUE(pose);
    const std::vector<PlanarMirror> mirrors = findMirrors(*scene, *pose, MirrorSearch::Auto, 8);
    ASSERT_FALSE(mirrors.empty());
    EXPECT_NEAR(mirrors[0].normalWS[1], 1, 1e-5); // the floor is by far the largest
    const bool wall = std::ranges::any_of(mirrors, [](const PlanarMirror& mirror) {
        return std::abs(mirror.normalWS[0]) > 0.999f && std::abs(mirror.centerWS[0]) > 5;
    });
    EXPECT_TRUE(wall);
}

} // namespace find_mirrors_test
} // namespace glint::render
