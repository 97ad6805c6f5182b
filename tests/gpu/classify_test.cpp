// Which pixels need a ray is decided in prepare/classified or, where neighbours are asked, in trace/classify.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <algorithm>
#include <map>

namespace glint::test {
namespace classify_test {

constexpr uint32_t kWidth = 77; // whole tiles neither way
constexpr uint32_t kHeight = 43;

class ClassifyTest : public LibraryTest {
protected:
    /// A floor in stripes: of any roughness, hardly reflecting, and turned so far up that rays return to the eye.
    static std::optional<SyntheticSurface> stripes(const glm::dvec3& origin, const glm::dvec3& direction) {
        auto hit = floorAndWall()(origin, direction);
        if (!hit || hit->f0.x == 0)
            return hit;
        const glm::dvec3 at = origin + direction * hit->distance;
        hit->perceptualRoughness = static_cast<float>(std::abs(std::sin(3 * at.x)));
        if (std::sin(7 * at.z) > 0.5)
            hit->f0 = glm::vec3(0.03f);
        if (std::sin(5 * at.z) > 0.5)
            hit->normalWS = glm::normalize(glm::dvec3(0, 1, 1.5));
        return hit;
    }
    static Settings settings() {
        Settings settings = plainSettings();
        settings.reflect.threshold = 0.04f;
        settings.reflect.maxRoughness = 0.5f;
        settings.fade.facingCamera = true;
        return settings;
    }
};

TEST_F(ClassifyTest, BothPassesFindTheSamePixels) {
    const Picture early = trace(stripes, {}, kWidth, kHeight, settings());
    Settings denoised = settings();
    denoised.denoise.enabled = true;
    denoised.reuse.rate = RayRate::Full;
    const Picture late = trace(stripes, {}, kWidth, kHeight, denoised);
    const auto runs = [](const Picture& picture, std::string_view pass) {
        return std::ranges::count(picture.passTimes, pass, &PassTime::name);
    };
    EXPECT_EQ(runs(early, "prepare/classified"), 1);
    EXPECT_EQ(runs(early, "trace/classify") + runs(early, "prepare/surface"), 0);
    EXPECT_EQ(runs(late, "prepare/classified"), 0);
    EXPECT_EQ(runs(late, "trace/classify") + runs(late, "prepare/surface"), 2);
    const auto rayless = [](uint32_t outcome) {
        return outcome == shared::kOutcomeNone || outcome >= shared::kOutcomeBelowThreshold;
    };
    std::map<uint32_t, size_t> found;
    for (size_t i = 0; i < early.pixels(); ++i) {
        const uint32_t outcome = early.outcome(i);
        ++found[rayless(outcome) ? outcome : shared::kOutcomeHit];
        if (rayless(outcome) || rayless(late.outcome(i))) {
            ASSERT_EQ(outcome, late.outcome(i)) << i % kWidth << "," << i / kWidth;
        }
    }
    for (const uint32_t outcome :
         {shared::kOutcomeHit, shared::kOutcomeBelowThreshold, shared::kOutcomeTooRough, shared::kOutcomeFacingCamera})
        EXPECT_GT(found[outcome], 30u) << outcome;
}

/// A pixel without a ray keeps nothing of what it was in earlier frames.
TEST_F(ClassifyTest, PixelsWithoutARayHaveNoAnswer) {
    Settings all = settings();
    all.reflect.threshold = 0;
    all.reflect.maxRoughness = 1;
    all.fade.facingCamera = false;
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), stripes, camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, all);
    must(made.setInputs(host.gbuffer));
    trace(made, camera.view(kWidth, kHeight));
    must(made.setSettings(settings()));
    const Picture picture = trace(made, camera.view(kWidth, kHeight));
    const Picture fresh = trace(stripes, camera, kWidth, kHeight, settings());
    EXPECT_EQ(picture.weight, fresh.weight);
    EXPECT_EQ(picture.reflection, fresh.reflection);
}

/// Without a reader of the record nothing at all is stored for such a pixel, and what earlier frames left there does
/// not show.
TEST_F(ClassifyTest, NothingStoredLooksLikeNoAnswer) {
    Settings all = settings();
    all.reflect.threshold = 0;
    all.reflect.maxRoughness = 1;
    all.fade.facingCamera = false;
    const SyntheticCamera camera;
    const View view = camera.view(kWidth, kHeight);
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), stripes, camera, kWidth, kHeight);
    const auto make = [&](const Settings& settings, bool statistics) {
        ReflectionsDesc desc = {kWidth, kHeight, settings};
        desc.framesInFlight = 1;
        desc.statistics = statistics;
        Reflections made = must(Reflections::create(library(), desc));
        must(made.setInputs(host.gbuffer));
        return made;
    };
    const auto picture = [&](Reflections& made) {
        HostImage image;
        run([&](VkCommandBuffer commands) { image = made.record(commands, view); });
        return download(gpu(), image);
    };
    Reflections made = make(all, false);
    const std::vector<float> before = picture(made);
    must(made.setSettings(settings()));
    Reflections counting = make(settings(), true);
    const std::vector<float> wanted = picture(counting);
    EXPECT_GT(counting.statistics().rays, 200u);
    EXPECT_EQ(picture(made), wanted);
    EXPECT_NE(before, wanted);
}

/// Views of frames that trace nothing show no leftovers of classification.
TEST_F(ClassifyTest, FramesThatTraceNothingSayTheSameEachTime) {
    Settings nothing = settings();
    nothing.reflect.strength = 0;
    const SyntheticCamera camera;
    const SyntheticGBuffer host = SyntheticGBuffer::render(gpu(), stripes, camera, kWidth, kHeight);
    Reflections made = reflections(kWidth, kHeight, settings());
    must(made.setInputs(host.gbuffer));
    trace(made, camera.view(kWidth, kHeight));
    must(made.setSettings(nothing));
    const Picture first = trace(made, camera.view(kWidth, kHeight));
    for (int i = 0; i < 4; ++i)
        EXPECT_EQ(trace(made, camera.view(kWidth, kHeight)).outcomeColor, first.outcomeColor) << i;
}

} // namespace classify_test
} // namespace glint::test
