// Files of baked probes: what was written comes back, and every kind of damage is one clear line.
#include "lab/sources/probe_file.hpp"

#include "base/file.hpp"
#include "base/hash.hpp"
#include "lab/sources/scene_hash.hpp"
#include "tests/support/temp_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <limits>
#include <random>

namespace glint::render {
namespace probe_file_test {

using testing::HasSubstr;

BakedProbe bakedProbe(uint32_t faceSize, uint32_t seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0, 1);
    BakedProbe baked;
    Probe& probe = baked.probe;
    probe.capturePositionWS = {unit(random), unit(random), unit(random)};
    probe.strength = 1 + unit(random);
    probe.weight = unit(random);
    probe.shape = ProbeShape::Sphere;
    probe.influence = {{1, 2, 3}, {0, 0.6f, 0, 0.8f}, {4, 5, 6}};
    probe.proxy = ProbeProxy::Sphere;
    probe.proxyVolume = {{-1, -2, -3}, {0.8f, 0, 0.6f, 0}, {7, 8, 9}};
    probe.alphaIsInverseDistance = seed % 2 == 1;
    for (size_t face = 0; face < 6; ++face) {
        probe.blendDistance[face] = unit(random);
        probe.blendNormalDistance[face] = unit(random);
        probe.faceFade[face] = unit(random);
    }
    baked.faceSize = faceSize;
    for (size_t i = 0; i < probeTexels(faceSize); ++i)
        baked.texels.push_back(random());
    return baked;
}

ProbeSet someProbes() {
    return {"scenes/room.glb", 0x1234567890abcdefull, 42, {bakedProbe(16, 1), bakedProbe(32, 2)}};
}

/// With the checksum and the size set right again, so that what is behind them is looked at.
std::string resealed(std::string bytes) {
    const std::string body = bytes.substr(48);
    const uint64_t size = body.size();
    std::memcpy(&bytes[32], &size, 8);
    const uint64_t hash = Hash().text(body).result();
    std::memcpy(&bytes[40], &hash, 8);
    return bytes;
}

std::string errorOf(std::string_view bytes) {
    const auto set = decodeProbes(bytes, "room.probes");
    if (set)
        return "";
    EXPECT_EQ(set.error().code, ErrorCode::InvalidInput); // the program's exit code 2
    EXPECT_EQ(set.error().message.find('\n'), std::string::npos);
    EXPECT_THAT(set.error().message, HasSubstr("room.probes"));
    return set.error().message;
}

TEST(ProbeFile, whatIsWrittenComesBack) {
    const ProbeSet set = someProbes();
    const std::string bytes = encodeProbes(set);
    const auto back = decodeProbes(bytes, "room.probes");
    ASSERT_TRUE(back) << back.error().message;
    EXPECT_EQ(back->scene, set.scene);
    EXPECT_EQ(back->sceneHash, set.sceneHash);
    EXPECT_EQ(back->lightHash, set.lightHash);
    ASSERT_EQ(back->probes.size(), 2u);
    EXPECT_EQ(encodeProbes(*back), bytes); // every number of every probe
    EXPECT_EQ(back->probes[1].probe.faceFade, set.probes[1].probe.faceFade);
    EXPECT_EQ(back->probes[1].texels, set.probes[1].texels);
    const auto none = decodeProbes(encodeProbes({"x", 1, 2, {}}), "none.probes");
    ASSERT_TRUE(none);
    EXPECT_TRUE(none->probes.empty());
}

TEST(ProbeFile, everyTruncationIsNoticed) {
    const std::string bytes = encodeProbes({"room.glb", 1, 2, {bakedProbe(16, 3)}});
    for (size_t size = 0; size < bytes.size(); size += size < 400 ? 1 : 97)
        ASSERT_NE(errorOf(std::string_view(bytes).substr(0, size)), "") << size;
    EXPECT_THAT(errorOf(std::string_view(bytes).substr(0, 30)), HasSubstr("header"));
    EXPECT_THAT(errorOf(std::string_view(bytes).substr(0, bytes.size() - 1)), HasSubstr("bytes of probes"));
    EXPECT_THAT(errorOf(bytes + "x"), HasSubstr("bytes of probes"));
    EXPECT_THAT(errorOf(""), HasSubstr("not a file of probes"));
}

TEST(ProbeFile, everyFlippedByteIsNoticed) {
    const std::string bytes = encodeProbes({"room.glb", 1, 2, {bakedProbe(16, 3)}});
    for (size_t i = 0; i < bytes.size(); i += i < 300 ? 1 : 61) {
        if (i >= 16 && i < 32)
            continue; // the hashes: another scene's or light's, which checkProbesFit notices
        std::string damaged = bytes;
        damaged[i] = static_cast<char>(damaged[i] ^ 0x10);
        ASSERT_NE(errorOf(damaged), "") << "byte " << i;
    }
}

TEST(ProbeFile, otherFilesAndVersionsAreNamed) {
    std::string bytes = encodeProbes(someProbes());
    EXPECT_THAT(errorOf("glTF" + bytes), HasSubstr("not a file of probes"));
    bytes[8] = 9;
    EXPECT_THAT(errorOf(bytes), HasSubstr("format version 9, this Glint reads version 2"));
}

/// Also with a right checksum, as a hostile file has.
TEST(ProbeFile, numbersThatCannotBeAreNoticed) {
    const std::string bytes = encodeProbes({"r", 1, 2, {bakedProbe(16, 3)}});
    const size_t first = 48 + 4 + 1; // the first probe's numbers
    const auto spoilt = [&](size_t at, uint32_t word) {
        std::string damaged = bytes;
        std::memcpy(&damaged[at], &word, 4);
        return errorOf(resealed(damaged));
    };
    EXPECT_EQ(errorOf(resealed(bytes)), "");
    EXPECT_THAT(spoilt(first, 0x7fc00000), HasSubstr("probe 0 is damaged")); // NaN
    EXPECT_THAT(spoilt(first + 20, 2), HasSubstr("probe 0 is damaged"));     // a shape that is none
    const size_t faceSize = bytes.size() - probeTexels(16) * 8 - 4;
    for (const uint32_t size : {0u, 8u, 24u, 2048u, 0xffffffffu})
        EXPECT_THAT(spoilt(faceSize, size), HasSubstr("damaged")) << size;
    EXPECT_THAT(spoilt(faceSize, 1024), HasSubstr("the file ends before them"));
    EXPECT_THAT(spoilt(12, 2), HasSubstr("probe 1"));         // more probes than there are
    EXPECT_THAT(spoilt(12, 0), HasSubstr("follow its last")); // fewer
    EXPECT_THAT(spoilt(12, 0xffffffff), HasSubstr("at most"));
    EXPECT_THAT(spoilt(48, 0xffffffff), HasSubstr("name of its scene"));
    EXPECT_THAT(spoilt(48, 4000), testing::Not("")); // a name that swallows the probe
}

TEST(ProbeFile, noBytesDoHarm) {
    const std::string bytes = encodeProbes({"room.glb", 1, 2, {bakedProbe(16, 3)}});
    std::mt19937 random(5);
    for (int i = 0; i < 3000; ++i) {
        std::string damaged = bytes.substr(0, i % 2 == 0 ? bytes.size() : 48 + random() % 400);
        for (int k = 0; k < 3; ++k)
            damaged[8 + random() % (damaged.size() - 8)] = static_cast<char>(random());
        static_cast<void>(decodeProbes(damaged, "x"));
        static_cast<void>(decodeProbes(resealed(damaged), "x"));
    }
}

TEST(ProbeFile, anotherSceneOrLightDoesNotFit) {
    const ProbeSet set = someProbes();
    EXPECT_TRUE(checkProbesFit(set, set.sceneHash, set.lightHash, "scenes/room.glb", "room.probes"));
    const auto scene = checkProbesFit(set, 7, set.lightHash, "scenes/hall.glb", "room.probes");
    ASSERT_FALSE(scene);
    EXPECT_EQ(scene.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(scene.error().message, HasSubstr("scenes/room.glb"));
    EXPECT_THAT(scene.error().message, HasSubstr("scenes/hall.glb"));
    const auto light = checkProbesFit(set, set.sceneHash, 7, "scenes/room.glb", "room.probes");
    ASSERT_FALSE(light);
    EXPECT_THAT(light.error().message, HasSubstr("light"));
}

TEST(SceneHash, tellsScenesMomentsAndLightsApart) {
    const auto inputsOf = [](const std::string& scene, const std::string& environment, double time = 0) {
        RenderJob job;
        job.scene = scene;
        job.environment = environment;
        job.time = time;
        return std::move(loadJobInputs(job)).value();
    };
    JobInputs mirror = inputsOf("builtin:mirror", "none");
    const auto hashOf = [](const JobInputs& inputs) { return sceneHash(*inputs.scene, inputs.pose); };
    EXPECT_EQ(hashOf(mirror), hashOf(inputsOf("builtin:mirror", "sky")));
    EXPECT_NE(hashOf(mirror), hashOf(inputsOf("builtin:exact", "none")));
    const uint64_t before = hashOf(mirror);
    mirror.scene->materials[0].roughnessFactor += 0.001f;
    EXPECT_NE(hashOf(mirror), before);
    mirror.scene->materials[0].roughnessFactor -= 0.001f;
    mirror.pose.items[0].localToWorld[3][1] += 0.001f;
    EXPECT_NE(hashOf(mirror), before);

    RenderSettings settings;
    const JobInputs sky = inputsOf("builtin:mirror", "sky");
    const uint64_t light = lightHash(sky, settings);
    EXPECT_NE(light, lightHash(mirror, settings)); // without an environment
    settings.display.exposure = 1;                 // is not light
    EXPECT_EQ(light, lightHash(sky, settings));
    settings.analyticSky.elevation += 1;
    EXPECT_NE(light, lightHash(sky, settings));
    settings = {};
    settings.environment.strength = 2;
    EXPECT_NE(light, lightHash(sky, settings));
}

} // namespace probe_file_test
} // namespace glint::render
