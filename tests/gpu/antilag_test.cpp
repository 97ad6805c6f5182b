// denoise.antilag: how fast the mean over frames follows light that changes, and that it forgets nothing else.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <algorithm>
#include <functional>

namespace glint::test {
namespace antilag_test {

constexpr uint32_t kWidth = 60;
constexpr uint32_t kHeight = 40;
constexpr uint32_t kFrames = 24; ///< until the light changes

/// A rough metal floor before a bright wall and a panel that is lit, or not.
class AntilagTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.4f));
        scene_.addQuad({-4, 0, -2}, {8, 0, 0}, {0, 4, 0}, emitting(glm::vec3(0.1f)));
        scene_.addQuad({-3, 0.2, -1.9}, {6, 0, 0}, {0, 3, 0}, lit_);
    }

    Settings denoised(Antilag antilag) const {
        Settings settings = plainSettings();
        settings.denoise.fastFrames = fastFrames_;
        settings.screen.enabled = screenAlone_;
        settings.rays.enabled = !screenAlone_;
        settings.denoise.enabled = true;
        settings.denoise.antilag = antilag;
        settings.denoise.stabilizeSeconds = stabilizeSeconds_;
        settings.reflect.maxRoughness = settings.reflect.roughnessFadeStart = 1;
        return settings;
    }

    /// What frames from `first` on show of the floor, in the mean; `panel` and `step` are the panel's material and the
    /// camera's place by frame.
    std::vector<double> play(Antilag antilag, const std::function<SurfaceMaterial(uint32_t)>& panel, uint32_t frames,
                             uint32_t first, double step = 0) {
        pictures_.clear();
        givenUp_.clear();
        SurfaceScene scene = scene_;
        SurfaceScene::World world = scene.build(gpu(), library(), RayBackend::Bvh);
        Reflections made = reflections(kWidth, kHeight, denoised(antilag));
        if (!screenAlone_)
            must(made.setRays(world.rays, world.surfaces));
        std::vector<double> means;
        for (uint32_t frame = 0; frame < frames; ++frame) {
            SyntheticCamera camera = {.position = {step * frame, 1, 4}, .target = {step * frame, 0.3, 0}};
            scene.materials.back() = panel(frame);
            const SyntheticGBuffer host = SyntheticGBuffer::render(
                gpu(), SurfaceScene::seenBy(screenAlone_ ? scene : scene_), camera, kWidth, kHeight);
            must(made.setInputs(host.gbuffer));
            must(world.surfaces.setMaterials(scene.materials));
            if (panelSize_)
                placePanel(world, panelSize_(frame));
            run([&](VkCommandBuffer commands) {
                world.rays.record(commands);
                world.surfaces.record(commands);
            });
            View view = camera.view(kWidth, kHeight);
            view.frameIndex = frame;
            pictures_.push_back(trace(made, view));
            EXPECT_GT(meanOf(pictures_.back().reflection), 0);
            givenUp_.push_back(meanOf(readView(made, "antilag")));
            if (frame >= first)
                means.push_back(meanOf(pictures_.back().reflection));
        }
        return means;
    }

    /// Scales the panel about its middle.
    void placePanel(SurfaceScene::World& world, float size) const {
        std::vector<RayInstance> instances = scene_.triangles.instances;
        for (const int axis : {0, 1, 2}) {
            instances.back().localToWorld[static_cast<size_t>(5 * axis)] = size;
            instances.back().localToWorld[static_cast<size_t>(12 + axis)] = panelMiddle_[axis] * (1 - size);
        }
        std::vector<SurfaceInstance> surfaces;
        for (uint32_t i = 0; i < instances.size(); ++i)
            surfaces.push_back({instances[i].mesh, i, instances[i].localToWorld});
        must(world.rays.setInstances(instances));
        must(world.surfaces.setInstances(surfaces));
    }

    static double meanOf(const std::vector<float>& rgba) {
        double sum = 0;
        for (size_t i = 0; i < rgba.size(); i += 4)
            sum += rgba[i];
        return sum / (static_cast<double>(rgba.size()) / 4);
    }

    /// The share of a change that shows in each frame from `kFrames` on, the first one after it.
    std::vector<double> reaction(Antilag antilag, bool on) {
        const auto panel = [&](uint32_t frame) { return (frame < kFrames) == on ? blackMatte() : lit_; };
        const auto then = play(
            antilag, [&](uint32_t) { return panel(0); }, kFrames, kFrames - 1);
        const auto now = play(
            antilag, [&](uint32_t) { return panel(kFrames); }, kFrames, kFrames - 1);
        std::vector<double> shares;
        for (const double mean : play(antilag, panel, kFrames + 8, kFrames))
            shares.push_back((mean - then.back()) / (now.back() - then.back()));
        return shares;
    }

    SurfaceMaterial lit_ = emitting(glm::vec3(2));
    int fastFrames_ = 6;
    float stabilizeSeconds_ = 0;
    std::function<float(uint32_t)> panelSize_; ///< by frame; empty: 1
    glm::vec3 panelMiddle_ = {0, 1.7f, -1.9f};
    bool screenAlone_ = false; ///< no rays: the panel shows in the host's picture
    SurfaceScene scene_;
    std::vector<Picture> pictures_; ///< of the last play
    std::vector<double> givenUp_;   ///< of its frames: share of the history, in the mean over all pixels
};

TEST_F(AntilagTest, aViewShowsWhatIsGivenUp) {
    constexpr double kRounding = 1e-6; // of lengths of histories whose quotient should be 1
    const auto panel = [&](uint32_t frame) { return frame < kFrames ? lit_ : blackMatte(); };
    for (const Antilag antilag : {Antilag::Off, Antilag::Mean, Antilag::Gradient}) {
        play(antilag, panel, kFrames + 8, 0);
        for (uint32_t frame = 0; frame < kFrames; ++frame)
            EXPECT_NEAR(givenUp_[frame], 0, kRounding) << frame;
        const double most = *std::max_element(givenUp_.begin() + kFrames, givenUp_.end());
        if (antilag == Antilag::Off)
            EXPECT_LE(most, kRounding);
        else
            EXPECT_GT(most, 0.1); // the floor is two fifths of the picture
        EXPECT_EQ(givenUp_[kFrames] > 0.1, antilag == Antilag::Gradient) << "sentinels see it in the same frame";
    }
}

TEST_F(AntilagTest, withoutItTheMeanLags) {
    EXPECT_LT(reaction(Antilag::Off, false).back(), 0.4); // eight of 32 frames
}

TEST_F(AntilagTest, sentinelsSeeTheLightGoOutAndComeOn) {
    for (const bool on : {false, true}) {
        const std::vector<double> shares = reaction(Antilag::Gradient, on);
        EXPECT_GT(shares[6], 0.9) << (on ? "on" : "off");
        EXPECT_LT(shares[6], 1.1) << (on ? "on" : "off");
    }
}

TEST_F(AntilagTest, whatAppearsBySizeIsLightThatChanges) {
    // Hosts hide things by their size. Followed as motion, a lamp would have the history of the wall behind it.
    SurfaceScene scene;
    scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.4f));
    scene.addQuad({-4, 0, -2}, {8, 0, 0}, {0, 4, 0}, emitting(glm::vec3(0.1f)));
    scene.addQuad({-3, 0.575f, -1.9f}, {6, 0, 0}, {0, 0.25f, 0}, lit_ = emitting(glm::vec3(9)));
    scene_ = scene;
    panelMiddle_ = {0, 0.7f, -1.9f};
    const auto lit = [&](uint32_t) { return lit_; };
    panelSize_ = [](uint32_t) { return 1.0f; };
    const double shown = play(Antilag::Gradient, lit, kFrames, kFrames - 1).back();
    panelSize_ = [](uint32_t frame) { return frame < kFrames ? 0.01f : 1.0f; };
    const std::vector<double> bySize = play(Antilag::Gradient, lit, kFrames + 8, kFrames - 1);
    // The first frame of a lamp that moves has no history, and the next one would take the dark one beside it.
    double most = 0;
    for (size_t i = 1; i < bySize.size(); ++i) {
        const double share = (bySize[i] - bySize[0]) / (shown - bySize[0]);
        EXPECT_GT(share, most - 0.1) << i;
        most = std::max(most, share);
    }
}

TEST_F(AntilagTest, whatIsStabilizedFollowsSentinelsToo) {
    stabilizeSeconds_ = 1;
    for (const bool on : {false, true}) {
        const std::vector<double> shares = reaction(Antilag::Gradient, on);
        EXPECT_GT(shares[6], 0.9) << (on ? "on" : "off");
        EXPECT_LT(shares[6], 1.1) << (on ? "on" : "off");
    }
}

TEST_F(AntilagTest, meansTellLaterOfALargeChange) {
    lit_ = emitting(glm::vec3(0.8f));
    EXPECT_GT(reaction(Antilag::Mean, false).back(), reaction(Antilag::Off, false).back() + 0.2);
}

TEST_F(AntilagTest, aShorterMeanTellsSooner) {
    lit_ = emitting(glm::vec3(0.8f));
    fastFrames_ = 3;
    const double sooner = reaction(Antilag::Mean, false)[4];
    fastFrames_ = 12;
    EXPECT_GT(sooner, reaction(Antilag::Mean, false)[4] + 0.1);
}

TEST_F(AntilagTest, constantLightIsNotForgotten) {
    for (const double step : {0.0, 0.02}) {
        const auto same = [&](uint32_t) { return lit_; };
        play(Antilag::Off, same, 12, 0, step);
        const std::vector<Picture> off = std::move(pictures_);
        play(Antilag::Gradient, same, 12, 0, step);
        for (size_t i = 0; i < off.size(); ++i)
            EXPECT_EQ(pictures_[i].composite, off[i].composite) << i << ", step " << step;
        // Means are compared by their noise: in motion a region may pass four standard deviations by chance, by little.
        const float most = step == 0 ? 0 : 0.005f;
        play(Antilag::Mean, same, 12, 0, step);
        for (size_t i = 0; i < off.size(); ++i)
            for (size_t k = 0; k < off[i].composite.size(); ++k)
                ASSERT_NEAR(pictures_[i].composite[k], off[i].composite[k], most) << i << ", step " << step;
    }
}

/// Without rays sentinels look at places of the host's picture.
TEST_F(AntilagTest, thePictureTellsOfLightThatGoesOutAndComesOn) {
    screenAlone_ = true;
    EXPECT_LT(reaction(Antilag::Off, false).back(), 0.5);
    for (const bool on : {false, true}) {
        const std::vector<double> shares = reaction(Antilag::Gradient, on);
        EXPECT_GT(shares[6], 0.9) << (on ? "on" : "off");
        EXPECT_LT(shares[6], 1.1) << (on ? "on" : "off");
    }
}

TEST_F(AntilagTest, aStillPictureIsNotForgotten) {
    screenAlone_ = true;
    for (const double step : {0.0, 0.02}) {
        const auto same = [&](uint32_t) { return lit_; };
        play(Antilag::Off, same, 12, 0, step);
        const std::vector<Picture> off = std::move(pictures_);
        play(Antilag::Gradient, same, 12, 0, step);
        for (size_t i = 0; i < off.size(); ++i)
            EXPECT_EQ(pictures_[i].composite, off[i].composite) << i << ", step " << step;
    }
}

/// A light that no new path finds is known to the paths that saw it go out.
TEST_F(AntilagTest, aSmallLightComesBackAtOnce) {
    scene_ = {};
    scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.4f));
    scene_.addQuad({-4, 0, -2}, {8, 0, 0}, {0, 4, 0}, emitting(glm::vec3(0.1f)));
    lit_ = emitting(glm::vec3(20));
    scene_.addQuad({-0.1, 0.5, -1.9}, {0.2, 0, 0}, {0, 0.2, 0}, lit_);
    const auto panel = [&](uint32_t frame) { return frame < kFrames || frame >= kFrames + 8 ? lit_ : blackMatte(); };
    const auto lit = play(
        Antilag::Gradient, [&](uint32_t) { return lit_; }, kFrames, kFrames - 1);
    const auto dark = play(
        Antilag::Gradient, [&](uint32_t) { return blackMatte(); }, kFrames, kFrames - 1);
    const auto shown = play(Antilag::Gradient, panel, kFrames + 14, kFrames + 8);
    EXPECT_GT((shown[3] - dark.back()) / (lit.back() - dark.back()), 0.6);
}

} // namespace antilag_test
} // namespace glint::test
