// A host with several views (two eyes, a split screen, a mirror camera) and one Reflections: what they may share.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

namespace glint::test {
namespace several_views_test {

constexpr uint32_t kWidth = 96;
constexpr uint32_t kHeight = 64;

class SeveralViewsTest : public LibraryTest {
protected:
    struct Eye {
        SyntheticCamera camera;
        SyntheticGBuffer host;
    };

    static Eye eyeAt(double x) {
        SyntheticCamera camera;
        camera.position.x = x;
        return {camera, SyntheticGBuffer::render(gpu(), floorAndWall(), camera, kWidth, kHeight)};
    }

    /// Records one of the host's views and returns its picture.
    static std::vector<float> record(Reflections& reflections, const Eye& eye, uint64_t frame) {
        must(reflections.setInputs(eye.host.gbuffer));
        View view = eye.camera.view(kWidth, kHeight);
        view.frameIndex = static_cast<uint32_t>(frame);
        view.frameNumber = frame;
        return trace(reflections, view).composite;
    }

    const Eye left_ = eyeAt(-0.4);
    const Eye right_ = eyeAt(0.4);
};

TEST_F(SeveralViewsTest, MayShareReflectionsThatKeepNothing) {
    Settings settings = plainSettings();
    settings.rough.factor = 0.2f; // noise by frame and pixel
    settings.blur.strength = 0.1f;
    Reflections shared = reflections(kWidth, kHeight, settings);
    Reflections leftAlone = reflections(kWidth, kHeight, settings);
    Reflections rightAlone = reflections(kWidth, kHeight, settings);
    for (uint64_t frame = 1; frame <= 4; ++frame) {
        EXPECT_EQ(record(shared, left_, frame), record(leftAlone, left_, frame)) << frame;
        EXPECT_EQ(record(shared, right_, frame), record(rightAlone, right_, frame)) << frame;
    }
    EXPECT_NE(record(shared, left_, 5), record(shared, right_, 5));
}

TEST_F(SeveralViewsTest, NeedTheirOwnWhereAFrameIsKept) {
    Settings settings = plainSettings();
    settings.screen.colorSource = ColorSource::Previous;
    Reflections leftOwn = reflections(kWidth, kHeight, settings);
    Reflections rightOwn = reflections(kWidth, kHeight, settings);
    Reflections shared = reflections(kWidth, kHeight, settings);
    record(leftOwn, left_, 1); // the first frame has no past
    record(rightOwn, right_, 1);
    const std::vector<float> left = record(leftOwn, left_, 2);
    const std::vector<float> right = record(rightOwn, right_, 2);
    for (uint64_t frame = 3; frame <= 5; ++frame) {
        // The scene rests, so a view of its own shows the same in each frame.
        EXPECT_EQ(record(leftOwn, left_, frame), left);
        EXPECT_EQ(record(rightOwn, right_, frame), right);
        // Shared, the frame before is the other eye's: another picture, but a sound one.
        for (const Eye* eye : {&left_, &right_})
            for (float value : record(shared, *eye, frame))
                ASSERT_TRUE(std::isfinite(value));
    }
}

} // namespace several_views_test
} // namespace glint::test
