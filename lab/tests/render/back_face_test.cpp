// How far back things reach: depth of the nearest surfaces that face away from the camera.
#include "lab/tests/render/support/render_test.hpp"

namespace glint::test {
namespace back_face_test {

/// Of orthographicCamera(): near 0.1 m unless the camera says otherwise, far 100 m, reversed and linear.
float depthAt(const scene::Camera& camera, float viewZ) {
    return (camera.far - viewZ) / (camera.far - camera.near);
}

class BackFaceTest : public RenderTest {
protected:
    static Picture backs(const SceneParts& parts, const scene::Camera& camera, uint32_t width, uint32_t height,
                         uint32_t downsample = 0, bool transparents = true) {
        render::GBufferOptions options;
        options.backFaces = true;
        options.backFaceDownsample = downsample;
        options.backFaceTransparents = transparents;
        return draw(parts, {camera, {}, {}, {}}, width, height, {}, {}, options).backDepth;
    }
};

TEST_F(BackFaceTest, ABallEndsAtItsFarSide) {
    SceneParts parts;
    parts.add(ball(1), metal(0.5f));
    const scene::Camera flat = orthographicCamera(4);
    const Picture picture = backs(parts, flat, 65, 65);
    EXPECT_NEAR(picture.center().x, depthAt(flat, 11), 1e-5f);
    EXPECT_EQ(picture.at(1, 1).x, 0) << "nothing is there";

    scene::Camera camera;
    camera.viewToWorld = scene::lookAt({0, 0, 4}, glm::vec3(0));
    camera.near = 0.1f;
    EXPECT_NEAR(backs(parts, camera, 65, 65).center().x, 0.1f / 5, 1e-5f);
}

TEST_F(BackFaceTest, TheNearestBackFaceWins) {
    SceneParts parts;
    parts.add(ball(1), metal(0.5f));
    parts.add(ball(1), metal(0.5f), glm::translate(glm::mat4(1), glm::vec3(0, 0, -5)));
    const scene::Camera camera = orthographicCamera(4);
    EXPECT_NEAR(backs(parts, camera, 65, 65).center().x, depthAt(camera, 11), 1e-5f);
}

TEST_F(BackFaceTest, ASheetsBackIsWhereItsFrontIs) {
    scene::Material sheet = metal(0.5f);
    sheet.doubleSided = true;
    SceneParts parts;
    parts.add(square(1), sheet, glm::rotate(glm::mat4(1), 0.7f, glm::vec3(1, 0.5f, 0)));
    scene::Camera camera;
    camera.viewToWorld = scene::lookAt({0.3f, 0.2f, 4}, glm::vec3(0));
    render::GBufferOptions options;
    options.backFaces = true;
    const Frame frame = draw(parts, {camera, {}, {}, {}}, 65, 65, {}, {}, options);
    EXPECT_EQ(frame.backDepth.texels, frame.depth.texels) << "bit for bit";
    EXPECT_GT(frame.depth.center().x, 0);

    SceneParts single;
    single.add(square(1), metal(0.5f));
    EXPECT_EQ(backs(single, orthographicCamera(4), 33, 33).center().x, 0) << "it has no back";
}

TEST_F(BackFaceTest, MirroredTransformsKeepTheirSides) {
    SceneParts parts;
    parts.add(ball(1), metal(0.5f), glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1)));
    const scene::Camera camera = orthographicCamera(4);
    EXPECT_NEAR(backs(parts, camera, 65, 65).center().x, depthAt(camera, 11), 1e-5f);
}

TEST_F(BackFaceTest, AlphaTestsCut) {
    for (const float alpha : {0.4f, 0.6f}) {
        scene::Material material = metal(0.5f);
        material.alphaMode = scene::AlphaMode::Mask;
        material.alphaCutoff = 0.5f;
        material.baseColorFactor.a = alpha;
        SceneParts parts;
        parts.add(ball(1), material);
        EXPECT_EQ(backs(parts, orthographicCamera(4), 33, 33).center().x > 0, alpha > 0.5f);
    }
}

TEST_F(BackFaceTest, TransparentSurfacesAreSolidIfAsked) {
    scene::Material blended = metal(0.5f);
    blended.alphaMode = scene::AlphaMode::Blend;
    blended.baseColorFactor.a = 0.3f;
    scene::Material glass = matte(glm::vec3(1));
    glass.transmissionFactor = 1;
    const scene::Camera camera = orthographicCamera(4);
    for (const scene::Material& material : {blended, glass}) {
        SceneParts parts;
        parts.add(ball(1), material);
        EXPECT_NEAR(backs(parts, camera, 33, 33, 0, true).center().x, depthAt(camera, 11), 1e-4f);
        EXPECT_EQ(backs(parts, camera, 33, 33, 0, false).center().x, 0);
    }
}

TEST_F(BackFaceTest, CoarserIsSmallerRoundedUp) {
    SceneParts parts;
    parts.add(ball(1), metal(0.5f));
    const scene::Camera camera = orthographicCamera(4);
    for (const uint32_t n : {0u, 1u, 3u, 8u}) {
        const Picture picture = backs(parts, camera, 65, 33, n);
        EXPECT_EQ(picture.width, (65 + n) / (n + 1));
        EXPECT_EQ(picture.height, (33 + n) / (n + 1));
        EXPECT_NEAR(picture.center().x, depthAt(camera, 11), 5e-3f); // pixels lie beside the ball's axis
    }
    EXPECT_EQ(backs(parts, camera, 1, 1, 8).width, 1u);
}

TEST_F(BackFaceTest, SettingsDecide) {
    Settings settings;
    settings.screen.thicknessMode = ThicknessMode::Constant;
    EXPECT_FALSE(render::gbufferOptions(settings, render::Antialias::None).backFaces);
    settings.screen.thicknessMode = ThicknessMode::Backface;
    settings.screen.backfaceDownsample = 3;
    settings.screen.backfaceTransparents = false;
    render::GBufferOptions wanted;
    wanted.backFaces = true;
    wanted.backFaceDownsample = 3;
    wanted.backFaceTransparents = false;
    EXPECT_EQ(render::gbufferOptions(settings, render::Antialias::None), wanted);
    settings.screen.enabled = false;
    EXPECT_FALSE(render::gbufferOptions(settings, render::Antialias::None).backFaces) << "nobody would read them";
}

} // namespace back_face_test
} // namespace glint::test
