// Where probes are put: in the open, in sight of what needs them; and the boxes that stand for what they see.
#include "lab/sources/probe_placing.hpp"

#include <glm/gtc/constants.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::render {
namespace probe_placing_test {

/// A box seen from outside or inside, as one geometry.
scene::Geometry boxOf(const glm::vec3& low, const glm::vec3& high) {
    scene::Geometry g;
    for (int corner = 0; corner < 8; ++corner)
        g.positions.emplace_back(corner & 1 ? high.x : low.x, corner & 2 ? high.y : low.y, corner & 4 ? high.z : low.z);
    g.indices = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                 2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    return g;
}

scene::Pose poseOf(const std::vector<scene::Geometry>& parts) {
    scene::Pose pose;
    for (const scene::Geometry& part : parts) {
        scene::DrawItem item;
        item.geometry = &part;
        pose.items.push_back(item);
        for (const glm::vec3& p : part.positions) {
            pose.boundsWS.min = glm::min(pose.boundsWS.min, p);
            pose.boundsWS.max = glm::max(pose.boundsWS.max, p);
        }
    }
    return pose;
}

/// On the floor at y = 0 between two corners, a need every half metre.
std::vector<ReflectiveNeed> floorNeeds(const glm::vec2& low, const glm::vec2& high) {
    std::vector<ReflectiveNeed> needs;
    for (float z = low.y; z <= high.y; z += 0.5f)
        for (float x = low.x; x <= high.x; x += 0.5f)
            needs.push_back({{x, 0, z}, {0, 1, 0}, {0, 1, 0}, 1});
    return needs;
}

TEST(FreeSpace, knowsWallsRoomAndSight) {
    const std::vector<scene::Geometry> parts = {boxOf({-3, 0, -3}, {3, 3, 3}), boxOf({-0.2f, 0, -3}, {0.2f, 2, 3})};
    const scene::Pose pose = poseOf(parts);
    const FreeSpace space = FreeSpace::build(pose, {{-3.55f, -0.55f, -3.55f}, {3.45f, 3.45f, 3.45f}}, 70);
    const auto cellAt = [&](const glm::vec3& p) {
        return glm::ivec3(glm::floor((p - space.center({0, 0, 0})) / space.cellSize() + 0.5f));
    };
    EXPECT_TRUE(space.solid(cellAt({-3, 1, 0})));
    EXPECT_TRUE(space.solid(cellAt({1, 0, 1})));
    EXPECT_FALSE(space.solid(cellAt({1.5f, 1.5f, 0})));
    EXPECT_NEAR(space.clearance(cellAt({1.5f, 1.5f, 0})), 1.3, 0.25); // to the middle wall
    EXPECT_TRUE(space.sees({1, 0.1f, 0}, {2, 2.5f, 1}, 0.2f));
    EXPECT_FALSE(space.sees({1, 1, 0}, {-1, 1, 0}, 0.2f)); // through the middle wall
    EXPECT_TRUE(space.sees({1, 2.6f, 0}, {-1, 2.6f, 0}, 0.2f));
}

TEST(ProbePlacing, twoRoomsGetAProbeEach) {
    // A wall from floor to ceiling parts the rooms; both floors reflect.
    const std::vector<scene::Geometry> parts = {boxOf({-6, 0, -3}, {6, 3, 3}), boxOf({-0.2f, 0, -3}, {0.2f, 3, 3})};
    const scene::Pose pose = poseOf(parts);
    std::vector<ReflectiveNeed> needs = floorNeeds({-5, -2}, {-1, 2});
    const std::vector<ReflectiveNeed> right = floorNeeds({1, -2}, {5, 2});
    needs.insert(needs.end(), right.begin(), right.end());
    const FreeSpace space = FreeSpace::build(pose, probeDomain(needs, pose.boundsWS), 64);
    const std::vector<PlacedProbe> probes = placeProbes(space, needs, 8);
    ASSERT_GE(probes.size(), 2u);
    EXPECT_LT(probes[0].positionWS.x * probes[1].positionWS.x, 0); // on both sides
    for (const PlacedProbe& probe : probes) {
        EXPECT_GT(probe.positionWS.y, 0.3f);
        EXPECT_LT(probe.positionWS.y, 2.7f);
        EXPECT_GT(std::abs(probe.positionWS.x), 0.5f);
        // What it serves lies on its side.
        EXPECT_GT(probe.needsWS.min.x * probe.positionWS.x, 0);
        EXPECT_GT(probe.needsWS.max.x * probe.positionWS.x, 0);
    }
    EXPECT_EQ(placeProbes(space, needs, 1).size(), 1u);
    EXPECT_TRUE(placeProbes(space, {}, 8).empty());
    EXPECT_TRUE(probeDomain({}, pose.boundsWS).empty());
}

TEST(ProbePlacing, needsAreGatheredByPlaceAndFacing) {
    std::vector<ReflectiveNeed> needs(100, {{0.1f, 0, 0.1f}, {0, 1, 0}, {0, 1, 0}, 2});
    needs.push_back({{0.1f, 0, 0.1f}, {0, -1, 0}, {0, -1, 0}, 1});
    needs.push_back({{5, 0, 0}, {0, 1, 0}, {0, 1, 0}, 3});
    const std::vector<ReflectiveNeed> gathered = gatherNeeds(needs, 1, 10);
    ASSERT_EQ(gathered.size(), 3u);
    EXPECT_FLOAT_EQ(gathered[0].weight, 200);
    EXPECT_FLOAT_EQ(gathered[1].weight, 3);
    EXPECT_EQ(gatherNeeds(needs, 1, 2).size(), 2u);
}

/// What a probe at `from` sees of a box from inside, through a hole in it: nothing.
std::vector<SeenDistance> seenIn(const scene::Bounds& room, const glm::vec3& from, bool openAbove) {
    std::vector<SeenDistance> seen;
    constexpr int kRays = 6000; // evenly over the sphere: Fibonacci's spiral
    for (int i = 0; i < kRays; ++i) {
        const float y = 1 - 2 * (static_cast<float>(i) + 0.5f) / kRays;
        const float phi = static_cast<float>(i) * 2.399963f;
        const float r = std::sqrt(1 - y * y);
        const glm::vec3 d(r * std::cos(phi), y, r * std::sin(phi));
        float t = 1e30f;
        int met = 0;
        for (int axis = 0; axis < 3; ++axis)
            if (const float to = ((d[axis] > 0 ? room.max : room.min)[axis] - from[axis]) / d[axis]; to < t) {
                t = to;
                met = axis;
            }
        if (openAbove && met == 1 && d.y > 0)
            t = std::numeric_limits<float>::infinity();
        seen.push_back({d, t, 4 * glm::pi<float>() / kRays});
    }
    return seen;
}

TEST(ProbePlacing, theProxyOfARoomIsTheRoom) {
    const scene::Bounds room = {{-2, 0, -9}, {3, 2.8f, 4}};
    const glm::vec3 from(0.5f, 1.5f, 1);
    std::vector<SeenDistance> seen = seenIn(room, from, false);
    // A third of what it sees is hidden by things in the room.
    for (size_t i = 0; i < seen.size(); i += 3)
        seen[i].distance *= 0.5f;
    const scene::Bounds box = fitProxyBox(from, seen, 200);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(box.min[axis], room.min[axis], 0.15) << axis;
        EXPECT_NEAR(box.max[axis], room.max[axis], 0.15) << axis;
    }
    const scene::Bounds open = fitProxyBox(from, seenIn(room, from, true), 200);
    EXPECT_GT(open.max.y, 50); // the sky is far away
    EXPECT_NEAR(open.min.y, 0, 0.1);
    EXPECT_NEAR(open.min.x, -2, 0.15);
}

TEST(ProbePlacing, whereNeedsLookCountsMore) {
    const scene::Bounds room = {{-2, 0, -2}, {2, 3, 2}};
    std::vector<SeenDistance> seen = seenIn(room, {0, 1, 0}, false);
    const std::vector<ReflectiveNeed> needs = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 5}};
    const float even = seen[0].weight;
    weighByNeeds(seen, needs);
    for (const SeenDistance& ray : seen) {
        if (ray.directionWS.x > 0.99f) {
            EXPECT_NEAR(ray.weight, even * 1.1f, even * 0.1f);
        } else if (ray.directionWS.x < 0) {
            EXPECT_FLOAT_EQ(ray.weight, even * 0.1f);
        }
    }
}

} // namespace probe_placing_test
} // namespace glint::render
