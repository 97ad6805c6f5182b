// What a surface leaves in the G-buffer: exact colours, coverage, normals, depth and motion.
#include "lab/tests/render/support/render_test.hpp"

namespace glint::test {
namespace surface_test {

class SurfaceTest : public RenderTest {
protected:
    static render::ViewParameters front(float height) { return {orthographicCamera(height), {}, {}, {}}; }
};

TEST_F(SurfaceTest, UnlitShowsItsVertexColors) {
    scene::Geometry geometry = square(1);
    geometry.colors.assign(geometry.positions.size(), glm::vec4(0.25f, 0.5f, 0.75f, 1));
    scene::Material material;
    material.unlit = true;
    material.baseColorFactor = {1, 0.5f, 0.25f, 1};
    SceneParts parts;
    parts.add(geometry, material);
    const Frame frame = draw(parts, front(4), 33, 33);
    EXPECT_EQ(frame.lit.center(), glm::vec3(0.25f, 0.25f, 0.1875f)); // exact in half floats
    EXPECT_EQ(glm::vec3(frame.material.at(16, 16)), glm::vec3(0));
    EXPECT_EQ(glm::vec3(frame.lit.at(1, 1)), glm::vec3(0));
}

TEST_F(SurfaceTest, EmissionIsExact) {
    SceneParts parts;
    parts.add(square(1), emissive({4, 0.5f, 0.125f}));
    EXPECT_EQ(draw(parts, front(4), 33, 33).lit.center(), glm::vec3(4, 0.5f, 0.125f));
}

TEST_F(SurfaceTest, MaskCutsAtItsThreshold) {
    for (const float alpha : {0.49f, 0.51f}) {
        scene::Material material = emissive(glm::vec3(1));
        material.alphaMode = scene::AlphaMode::Mask;
        material.alphaCutoff = 0.5f;
        material.baseColorFactor.a = alpha;
        SceneParts parts;
        parts.add(square(1), material);
        EXPECT_EQ(draw(parts, front(4), 33, 33).lit.center().x, alpha > 0.5f ? 1 : 0);
    }
}

TEST_F(SurfaceTest, BlendingGoesFromFarToNear) {
    const auto pane = [](const glm::vec3& radiance) {
        scene::Material material = emissive(radiance);
        material.alphaMode = scene::AlphaMode::Blend;
        material.baseColorFactor.a = 0.5f;
        return material;
    };
    SceneParts parts; // in the wrong order, so that sorting shows
    parts.add(square(1), pane({0, 1, 0}), glm::translate(glm::mat4(1), glm::vec3(0, 0, 2)));
    parts.add(square(1), pane({1, 0, 0}), glm::translate(glm::mat4(1), glm::vec3(0, 0, 1)));
    parts.add(square(1), emissive({0, 0, 1}));
    EXPECT_EQ(draw(parts, front(4), 33, 33).lit.center(), glm::vec3(0.25f, 0.5f, 0.25f));
}

TEST_F(SurfaceTest, BackFacesShowOnlyWhenDoubleSidedAlsoUnderMirroring) {
    for (const bool doubleSided : {false, true})
        for (const float scaleX : {1.0f, -1.0f})
            for (const bool turned : {false, true}) {
                scene::Material material = emissive(glm::vec3(1));
                material.doubleSided = doubleSided;
                SceneParts parts;
                const glm::mat4 turn = glm::rotate(glm::mat4(1), turned ? glm::pi<float>() : 0.0f, glm::vec3(0, 1, 0));
                parts.add(square(1), material, glm::scale(turn, glm::vec3(scaleX, 1, 1)));
                EXPECT_EQ(draw(parts, front(4), 17, 17).lit.center().x, doubleSided || !turned ? 1 : 0)
                    << doubleSided << scaleX << turned;
            }
}

TEST_F(SurfaceTest, DepthIsReversedAndNormalsAreWorldSpace) {
    SceneParts parts;
    parts.add(square(1), metal(0.5f));
    scene::Camera camera;
    camera.viewToWorld = scene::lookAt({0, 0, 2}, glm::vec3(0));
    camera.near = 0.1f;
    const Frame frame = draw(parts, {camera, {}, {}, {}}, 33, 33);
    EXPECT_NEAR(frame.depth.center().x, 0.05f, 1e-6f); // near / viewZ
    EXPECT_EQ(frame.normal.center(), glm::vec3(0));    // octahedral +Z
    EXPECT_NEAR(frame.material.at(16, 16).a, 0.5f, 1e-3f);
}

TEST_F(SurfaceTest, MotionIsPreviousMinusCurrentWithoutJitter) {
    SceneParts parts;
    parts.add(square(8), metal(0.5f));
    render::ViewParameters view = front(4);
    view.prevCamera = view.camera;
    view.prevCamera->viewToWorld[3].x += 1; // the camera was one metre to the right: the picture was to the left
    view.jitterPX = {0.3f, -0.2f};
    view.prevJitterPX = {-0.1f, 0.4f};
    const glm::vec3 motion = draw(parts, view, 64, 64).motion.center();
    EXPECT_NEAR(motion.x, -0.25f, 1e-4f);
    EXPECT_NEAR(motion.y, 0, 1e-4f);
    EXPECT_NEAR(motion.z, 0, 1e-4f);
}

TEST_F(SurfaceTest, MotionTellsDepth) {
    SceneParts parts;
    parts.add(square(8), metal(0.5f));
    scene::Camera perspective;
    perspective.viewToWorld = scene::lookAt({0, 0, 2}, glm::vec3(0));
    for (const scene::Camera& camera : {perspective, front(4).camera}) {
        render::ViewParameters view = {camera, camera, {}, {}};
        view.prevCamera->viewToWorld[3].z += 0.5f; // the camera was half a metre farther away
        EXPECT_NEAR(draw(parts, view, 64, 64).motion.center().z, 0.5f, 1e-3f) << camera.orthographic;
    }
}

/// Hosts hide things by a scale of almost 0. A thing that appears so, or goes, does not move.
TEST_F(SurfaceTest, WhatAppearsByItsSizeHasNoMotion) {
    SceneParts parts;
    parts.add(square(1), metal(0.5f));
    const auto motionAfter = [&](float scaleBefore) {
        scene::Pose pose = must(scene::pose(parts.scene, 0));
        const glm::mat4 now = pose.items[0].localToWorld;
        pose.items[0].localToWorld =
            glm::scale(glm::translate(glm::mat4(1), glm::vec3(-0.5f, 0, 0)), glm::vec3(scaleBefore)) * now;
        render::Renderer renderer =
            must(render::Renderer::create(gpu(), parts.scene, pose, must(render::Environment::createNone(gpu())), {}));
        must(renderer.resize(64, 64, {}));
        const auto drawFrame = [&] {
            render::ViewParameters view = front(4);
            view.prevCamera = view.camera;
            run([&](VkCommandBuffer commands) {
                gpu::Frame frame(gpu(), commands);
                renderer.drawOpaque(frame, view);
            });
        };
        drawFrame();
        pose.items[0].localToWorld = now;
        must(renderer.setPose(parts.scene, pose));
        drawFrame();
        return Picture{64, 64, must(gpu::downloadImageAsFloats(gpu(), renderer.gbuffer().motion))}.center().x;
    };
    EXPECT_NEAR(motionAfter(1), -0.125f, 1e-3f) << "half a metre of four";
    EXPECT_LT(motionAfter(0.8f), -0.1f) << "half of its volume";
    EXPECT_EQ(motionAfter(0.5f), 0) << "an eighth";
    EXPECT_EQ(motionAfter(1e-3f), 0);
    EXPECT_EQ(motionAfter(2), 0) << "it shrinks";
}

TEST_F(SurfaceTest, OddSizesAndEmptyScenesAreDrawn) {
    SceneParts empty;
    empty.scene.scenes.emplace_back();
    for (const glm::uvec2 size : {glm::uvec2(1, 1), glm::uvec2(17, 9), glm::uvec2(1, 300)})
        for (const float value : draw(empty, {}, size.x, size.y).lit.texels)
            ASSERT_EQ(value, 0);
}

TEST_F(SurfaceTest, SameInputSameBits) {
    SceneParts parts;
    parts.add(ball(1), metal(0.3f));
    const auto sky = environmentPicture(64, [](const glm::vec3& d) { return glm::abs(d) * 3.0f; });
    EXPECT_EQ(draw(parts, front(3), 65, 33, sky).lit.texels, draw(parts, front(3), 65, 33, sky).lit.texels);
}

TEST_F(SurfaceTest, ImpossibleSizesAreErrors) {
    SceneParts empty;
    empty.scene.scenes.emplace_back();
    const scene::Pose pose = must(scene::pose(empty.scene, 0));
    render::Renderer renderer =
        must(render::Renderer::create(gpu(), empty.scene, pose, must(render::Environment::createNone(gpu())), {}));
    for (const glm::uvec2 size : {glm::uvec2(0, 5), glm::uvec2(1 << 20, 1)}) {
        const Result<void> resized = renderer.resize(size.x, size.y);
        ASSERT_FALSE(resized);
        EXPECT_EQ(resized.error().code, ErrorCode::InvalidArgument);
    }
}

} // namespace surface_test
} // namespace glint::test
