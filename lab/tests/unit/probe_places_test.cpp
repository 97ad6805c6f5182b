// Probes placed by hand: what the file says comes through, and what it cannot mean is named.
#include "lab/sources/probe_places.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glint::render {
namespace probe_places_test {

using testing::HasSubstr;

std::string errorOf(const std::string& text) {
    const auto places = parseProbePlaces(text, "room.json");
    if (places)
        return "";
    EXPECT_EQ(places.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(places.error().message, HasSubstr("room.json"));
    return places.error().message;
}

std::string probeWith(const std::string& more) {
    return R"({"probes": [{"position": [1, 2, 3], "influence": {"center": [0, 1, 0], "halfExtents": [4, 2, 6]})" +
           more + "}]}";
}

TEST(ProbePlaces, everyKeyComesThrough) {
    const auto places = parseProbePlaces(
        probeWith(R"(, "blendDistance": 0.5, "blendNormalDistance": [1, 2, 3, 4, 5, 6], "faceFade": [1, 0, 1, 0, 1, 0],
                     "proxy": {"shape": "sphere", "center": [7, 8, 9], "radius": 5, "rotation": [0, 1, 0, 0]},
                     "strength": 2, "weight": 0.5)"),
        "room.json");
    ASSERT_TRUE(places) << places.error().message;
    ASSERT_EQ(places->size(), 1u);
    const Probe& probe = places->front().probe;
    EXPECT_FALSE(places->front().fitsProxy);
    EXPECT_EQ(probe.capturePositionWS, (std::array<float, 3>{1, 2, 3}));
    EXPECT_EQ(probe.shape, ProbeShape::Box);
    EXPECT_EQ(probe.influence.halfExtents, (std::array<float, 3>{4, 2, 6}));
    EXPECT_EQ(probe.blendDistance[5], 0.5f);
    EXPECT_EQ(probe.blendNormalDistance[5], 6.0f);
    EXPECT_EQ(probe.faceFade[1], 0.0f);
    EXPECT_EQ(probe.proxy, ProbeProxy::Sphere);
    EXPECT_EQ(probe.proxyVolume.halfExtents[0], 5.0f);
    EXPECT_EQ(probe.proxyVolume.rotation[1], 1.0f);
    EXPECT_EQ(probe.strength, 2.0f);
    EXPECT_EQ(probe.weight, 0.5f);
    EXPECT_TRUE(parseProbePlaces(probeWith(""), "room.json")->front().fitsProxy);
    EXPECT_EQ(parseProbePlaces(probeWith(R"(, "proxy": {"shape": "none"})"), "room.json")->front().probe.proxy,
              ProbeProxy::Infinite);
}

TEST(ProbePlaces, mistakesAreNamed) {
    EXPECT_THAT(errorOf("{"), HasSubstr("parse error"));
    EXPECT_THAT(errorOf("[]"), HasSubstr("must be"));
    EXPECT_THAT(errorOf(R"({"probes": []})"), HasSubstr("1 to"));
    EXPECT_THAT(errorOf(R"({"probes": [3]})"), HasSubstr("probe 0"));
    EXPECT_THAT(errorOf(R"({"probes": [{"influence": {}}]})"), HasSubstr("\"position\" is missing"));
    EXPECT_THAT(errorOf(R"({"probes": [{"position": [0, 0, 0]}]})"), HasSubstr("\"influence\" is missing"));
    EXPECT_THAT(errorOf(probeWith(R"(, "wieght": 1)")), HasSubstr("\"wieght\" is unknown"));
    EXPECT_THAT(errorOf(probeWith(R"(, "blendDistance": [1, 2])")), HasSubstr("6 numbers"));
    EXPECT_THAT(errorOf(probeWith(R"(, "weight": "much")")), HasSubstr("a number"));
    EXPECT_THAT(errorOf(probeWith(R"(, "strength": 1e300)")), HasSubstr("a number"));
    EXPECT_THAT(errorOf(probeWith(R"(, "proxy": {"shape": "cone"})")), HasSubstr("shape"));
    EXPECT_THAT(errorOf(probeWith(R"(, "proxy": {"shape": "sphere", "center": [0, 0, 0]})")), HasSubstr("radius"));
    EXPECT_THAT(errorOf(probeWith(R"(, "proxy": 5)")), HasSubstr("proxy"));
}

} // namespace probe_places_test
} // namespace glint::render
