// Stored values to Glint's conventions, against positions and normals known in advance.
#include "lab/gbuffer_files/gbuffer_pixels.hpp"

#include "tests/support/must.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace glint::scene {
namespace gbuffer_pixels_test {

using test::must;
using testing::HasSubstr;

constexpr uint32_t kWidth = 8, kHeight = 6;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

Camera camera() {
    Camera camera;
    camera.viewToWorld = lookAt({1, 2, 5}, {0.5f, 0.3f, -1});
    camera.fovY = glm::radians(50.0f);
    camera.near = 0.1f;
    camera.far = 40;
    return camera;
}

float expectedZ(uint32_t x, uint32_t y) {
    return 3 + 0.4f * float(x) + 0.25f * float(y);
}

/// World position of a pixel, from the definition of the camera and not from PixelLens.
glm::vec3 worldPosition(const Camera& camera, uint32_t x, uint32_t y) {
    const double tanY = std::tan(double(camera.fovY) / 2), tanX = tanY * kWidth / kHeight;
    const double z = expectedZ(x, y);
    const glm::dvec4 positionVS(((x + 0.5) / kWidth * 2 - 1) * tanX * z, (1 - (y + 0.5) / kHeight * 2) * tanY * z, -z,
                                1);
    return glm::dmat4(camera.viewToWorld) * positionVS;
}

glm::vec3 expectedNormal(uint32_t x, uint32_t y) {
    return glm::normalize(glm::vec3(0.1f * float(x) - 0.3f, 0.8f, 0.2f * float(y) - 0.5f));
}

/// Layers that store the expected surface in Glint's own meaning.
GBufferLayers layers() {
    GBufferLayers layers;
    layers.width = kWidth;
    layers.height = kHeight;
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            layers.depth.push_back(expectedZ(x, y));
            layers.normal.push_back(expectedNormal(x, y));
            layers.color.emplace_back(x, y, 1);
        }
    return layers;
}

GBufferMapping mapping() {
    return must(parseMapping(R"({"depth": "Z", "normal": "N", "roughness": 0.25, "color": "C"})", "m"));
}

void expectSurface(const GBufferPixels& pixels, std::string_view what) {
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x) {
            const size_t i = size_t{y} * kWidth + x;
            ASSERT_NEAR(pixels.viewZ[i], expectedZ(x, y), 2e-4f) << what << " " << x << "," << y;
            ASSERT_LT(glm::length(pixels.normalWS[i] - expectedNormal(x, y)), 1e-5f) << what << " " << x << "," << y;
        }
}

/// Decodes layers of which `change` stores one value in another meaning.
template <class Change>
GBufferPixels decode(std::string_view meaning, const Change& change) {
    GBufferMapping names = must(parseMapping(meaning, "m"));
    GBufferLayers stored = layers();
    for (uint32_t y = 0; y < kHeight; ++y)
        for (uint32_t x = 0; x < kWidth; ++x)
            change(stored, size_t{y} * kWidth + x, x, y);
    return must(decodeLayers(stored, names, camera(), "f.exr"));
}

TEST(GBufferPixels, DepthsOfEveryKind) {
    const Camera lens = camera();
    const double n = lens.near, f = lens.far;
    const auto meaning = [](std::string_view is) {
        return fmt::format(R"({{"depth": {{"layer": "Z", "is": "{}"}}, "normal": "N", "roughness": 0, "color": "C"}})",
                           is);
    };
    expectSurface(decode(meaning("viewZ"), [](auto&, size_t, uint32_t, uint32_t) {}), "viewZ");
    expectSurface(decode(meaning("negativeViewZ"), [](auto& s, size_t i, uint32_t, uint32_t) { s.depth[i] *= -1; }),
                  "negativeViewZ");
    expectSurface(decode(meaning("distance"),
                         [&](auto& s, size_t i, uint32_t x, uint32_t y) {
                             s.depth[i] = glm::distance(worldPosition(lens, x, y), glm::vec3(lens.viewToWorld[3]));
                         }),
                  "distance");
    // f/(f-n) - n f / ((f-n) d), the usual perspective depth with 1 at the far plane
    const auto device = [&](uint32_t x, uint32_t y) { return f / (f - n) - n * f / ((f - n) * expectedZ(x, y)); };
    expectSurface(
        decode(meaning("device"), [&](auto& s, size_t i, uint32_t x, uint32_t y) { s.depth[i] = float(device(x, y)); }),
        "device");
    expectSurface(decode(meaning("reversedDevice"),
                         [&](auto& s, size_t i, uint32_t x, uint32_t y) { s.depth[i] = float(1 - device(x, y)); }),
                  "reversedDevice");
    expectSurface(decode(R"({"metres": 0.01, "depth": "Z", "normal": "N", "roughness": 0, "color": "C"})",
                         [](auto& s, size_t i, uint32_t, uint32_t) { s.depth[i] *= 100; }),
                  "centimetres");
}

TEST(GBufferPixels, PositionsGiveDepth) {
    const Camera lens = camera();
    const auto store = [&](auto& s, size_t i, uint32_t x, uint32_t y) {
        s.depth.clear();
        s.position.resize(s.pixels());
        const glm::vec3 p = worldPosition(lens, x, y), n = expectedNormal(x, y);
        s.position[i] = {p.x, -p.z, p.y}; // Blender's axes
        s.normal[i] = {n.x, -n.z, n.y};
    };
    expectSurface(decode(R"({"axes": "zUp", "position": "P", "normal": "N", "roughness": 0, "color": "C"})", store),
                  "positions with Z up");
}

TEST(GBufferPixels, NormalsOfEveryMeaning) {
    const glm::mat3 worldToView(glm::inverse(camera().viewToWorld));
    const auto meaning = [](std::string_view normal) {
        return fmt::format(R"({{"depth": "Z", "normal": {{"layer": "N", {}}}, "roughness": 0, "color": "C"}})", normal);
    };
    expectSurface(decode(meaning(R"("space": "view")"),
                         [&](auto& s, size_t i, uint32_t, uint32_t) { s.normal[i] = worldToView * s.normal[i]; }),
                  "view");
    expectSurface(decode(meaning(R"("unorm": true)"),
                         [](auto& s, size_t i, uint32_t, uint32_t) { s.normal[i] = s.normal[i] * 0.5f + 0.5f; }),
                  "unorm");
    expectSurface(
        decode(meaning(R"("inward": true)"), [](auto& s, size_t i, uint32_t, uint32_t) { s.normal[i] = -s.normal[i]; }),
        "inward");
    expectSurface(
        decode(meaning(R"("space": "world")"), [](auto& s, size_t i, uint32_t, uint32_t) { s.normal[i] *= 0.7f; }),
        "of another length");
}

TEST(GBufferPixels, RowsFromTheBottom) {
    const auto flip = [](auto& s, size_t i, uint32_t x, uint32_t y) {
        const GBufferLayers whole = layers();
        const size_t other = size_t{kHeight - 1 - y} * kWidth + x;
        s.depth[i] = whole.depth[other];
        s.normal[i] = whole.normal[other];
        s.color[i] = whole.color[other];
    };
    const GBufferPixels pixels =
        decode(R"({"rowsFromBottom": true, "depth": "Z", "normal": "N", "roughness": 0, "color": "C"})", flip);
    expectSurface(pixels, "rows from the bottom");
    EXPECT_EQ(pixels.litRadiance[2 * kWidth + 3], glm::vec3(3, 2, 1));
}

TEST(GBufferPixels, MotionIsPreviousMinusCurrentUV) {
    GBufferLayers stored = layers();
    GBufferMapping names = mapping();
    EXPECT_TRUE(must(decodeLayers(stored, names, camera(), "f")).motionUV.empty());
    stored.motion.assign(stored.pixels(), glm::vec2(2, 3));
    stored.motion[1] = {kNaN, 0};
    EXPECT_EQ(must(decodeLayers(stored, names, camera(), "f")).motionUV[0], glm::vec2(2, 3));
    names.motionInPixels = true;
    names.motionScale = {1, -1}; // as Blender's
    const GBufferPixels pixels = must(decodeLayers(stored, names, camera(), "f"));
    EXPECT_FLOAT_EQ(pixels.motionUV[0].x, 2.0f / kWidth);
    EXPECT_FLOAT_EQ(pixels.motionUV[0].y, -3.0f / kHeight);
    EXPECT_EQ(pixels.motionUV[1], glm::vec2(0));
}

TEST(GBufferPixels, MaterialsAreReflectanceAndRoughness) {
    GBufferLayers stored = layers();
    GBufferMapping names = mapping();
    EXPECT_FLOAT_EQ(must(decodeLayers(stored, names, camera(), "f")).material[0].r, 0.04f);
    EXPECT_FLOAT_EQ(must(decodeLayers(stored, names, camera(), "f")).material[0].a, 0.25f);
    stored.metallic.assign(stored.pixels(), 0.5f);
    stored.baseColor.assign(stored.pixels(), glm::vec3(1, 0.5f, 0));
    stored.ior.assign(stored.pixels(), 1.0f); // no interface: a dielectric that reflects nothing
    stored.roughness.assign(stored.pixels(), 0.75f);
    names.smoothness = true;
    EXPECT_EQ(must(decodeLayers(stored, names, camera(), "f")).material[0], glm::vec4(0.5f, 0.25f, 0, 0.25f));
    stored.f0.assign(stored.pixels(), glm::vec3(0.9f, 2, kNaN));
    EXPECT_EQ(must(decodeLayers(stored, names, camera(), "f")).material[0], glm::vec4(0.9f, 1, 0, 0.25f));
}

TEST(GBufferPixels, WhatIsNoNumberIsBackgroundAndCounted) {
    GBufferLayers stored = layers();
    stored.depth[0] = kNaN;
    stored.depth[1] = std::numeric_limits<float>::infinity();
    stored.depth[2] = 1e10f;
    stored.depth[3] = -1;
    stored.normal[4] = {kNaN, 0, 1};
    stored.normal[5] = glm::vec3(0);
    stored.color[6] = {kNaN, -1, 1e30f};
    stored.coverage.assign(stored.pixels(), 1);
    stored.coverage[7] = 0.4f;
    const GBufferPixels pixels = must(decodeLayers(stored, mapping(), camera(), "f.exr"));
    for (size_t i = 0; i < 8; ++i)
        EXPECT_EQ(pixels.viewZ[i] > 0, i == 6) << i;
    EXPECT_EQ(pixels.surfaces, kWidth * kHeight - 7);
    EXPECT_EQ(pixels.litRadiance[6], glm::vec3(0, 0, 65504));
    EXPECT_THAT(pixels.notes, testing::ElementsAre(HasSubstr("1 of 48 pixels have a depth that is no number"),
                                                   HasSubstr("2 of 48 pixels have a surface without a finite normal"),
                                                   HasSubstr("1 of 48 pixels have a colour")));
}

TEST(GBufferPixels, MaterialsThatAreNoSuchValuesAreCounted) {
    const float infinity = std::numeric_limits<float>::infinity();
    GBufferLayers stored = layers();
    for (std::vector<float>* plane : {&stored.roughness, &stored.metallic})
        plane->assign(stored.pixels(), 0.5f);
    stored.ior.assign(stored.pixels(), 1.5f);
    stored.baseColor.assign(stored.pixels(), glm::vec3(1.0005f)); // rounding
    for (std::vector<glm::vec3>* plane : {&stored.fallbackSpecular, &stored.reference})
        plane->assign(stored.pixels(), glm::vec3(1));
    EXPECT_THAT(must(decodeLayers(stored, mapping(), camera(), "f")).notes, testing::IsEmpty());
    stored.roughness[0] = kNaN;
    stored.roughness[1] = 1e30f;
    stored.metallic[2] = infinity;
    stored.metallic[3] = 1;
    stored.ior[3] = 0; // of a metal, which has none
    stored.ior[4] = 0;
    stored.baseColor[5] = {0, kNaN, 0};
    stored.color[6] = glm::vec3(infinity);
    stored.fallbackSpecular[7] = glm::vec3(1e30f);
    stored.reference[8] = {0, 0, kNaN};
    const GBufferPixels pixels = must(decodeLayers(stored, mapping(), camera(), "f"));
    EXPECT_EQ(pixels.material[0].a, 1);
    EXPECT_EQ(pixels.fallbackSpecular[7], glm::vec3(65504));
    EXPECT_THAT(pixels.notes,
                testing::ElementsAre(HasSubstr("1 of 48 pixels have a colour above 65504"),
                                     HasSubstr("1 of 48 pixels have a fallbackSpecular that is not from 0 to 65504"),
                                     HasSubstr("1 of 48 pixels have a reference that is not from 0 to 65504"),
                                     HasSubstr("2 of 48 pixels have a roughness that is not from 0 to 1"),
                                     HasSubstr("1 of 48 pixels have a metallic that is not from 0 to 1"),
                                     HasSubstr("1 of 48 pixels have a baseColor that is not from 0 to 1"),
                                     HasSubstr("1 of 48 pixels have a ior that is not from 1 to 100")));
}

TEST(GBufferPixels, AnImageWithoutSurfacesIsAnError) {
    GBufferLayers stored = layers();
    stored.depth.assign(stored.pixels(), kNaN);
    const auto pixels = decodeLayers(stored, mapping(), camera(), "f.exr");
    ASSERT_FALSE(pixels.ok());
    EXPECT_EQ(pixels.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(pixels.error().message, HasSubstr("f.exr: no pixel shows a surface: Z declared as viewZ"));
}

} // namespace gbuffer_pixels_test
} // namespace glint::scene
