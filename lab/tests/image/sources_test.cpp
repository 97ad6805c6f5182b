// Combined sources on whole scenes, against rays for everything: each of the 32 combinations of the five renders, and
// adding a source does not make the image worse. Rays, one a pixel, add their noise; with sixteen they improve the
// image. docs/techniques/composite.md has the figures.
#include "lab/tests/image/source_choices.hpp"

#include <array>
#include <cmath>

namespace glint::test {
namespace sources_test {

std::string nameOf(unsigned sources) {
    constexpr std::array kNames = {"screen ", "rays ", "planar ", "probes ", "sky "};
    std::string name;
    for (unsigned s = 0; s < kSources; ++s)
        name += (sources >> s & 1) != 0 ? kNames[s] : "";
    return name.empty() ? "none" : name;
}

class SourcesTest : public JobTest {
protected:
    static std::vector<uint8_t> draw(render::ReflectionSession& session, const render::ProgramSettings& settings,
                                     uint32_t frames) {
        must(session.setSettings(settings));
        for (uint32_t frame = 0; frame < frames; ++frame)
            must(session.renderFrame(frame));
        return must(session.readView("composite")).rgb8;
    }

    /// Mean differences from the reference in bytes.
    struct Errors {
        std::array<double, 32> of = {}; ///< every choice of sources
        double manyRays = 0;            ///< all of them, with 16 rays a pixel
    };

    static Errors errors(render::RenderJob job) {
        const TempFolder folder;
        bakeProbes(device(), job, folder);
        render::ReflectionSession session = must(render::openJob(device(), job));
        const std::vector<uint8_t> reference = draw(session, referenceOf(job.settings, 16), 4);
        const auto errorOf = [&](unsigned sources, int samples, const std::string& name) {
            render::ProgramSettings settings = job.settings;
            settings.reflections.fade.uncertain = false; // what that gives to the next source is a bet, and may be lost
            choose(settings, sources);
            settings.reflections.rays.samples = samples;
            const std::vector<uint8_t> picture = draw(session, settings, 1);
            double sum = 0;
            for (size_t i = 0; i < picture.size(); ++i)
                sum += std::abs(int(picture[i]) - int(reference[i]));
            RecordProperty(name, std::to_string(sum / static_cast<double>(picture.size())));
            return sum / static_cast<double>(picture.size());
        };
        Errors out;
        for (unsigned sources = 0; sources < out.of.size(); ++sources)
            out.of[sources] = errorOf(sources, 1, nameOf(sources));
        out.manyRays = errorOf(kAll, 16, "all with 16 rays");
        return out;
    }

    static void expectMoreIsNotWorse(const Errors& error) {
        for (unsigned sources = 0; sources < error.of.size(); ++sources)
            for (const unsigned source : {kScreen, kPlanar, kProbes, kSky}) {
                const unsigned more = sources | source;
                EXPECT_LE(error.of[more], 1.03 * error.of[sources] + 0.05)
                    << nameOf(more) << "against " << nameOf(sources);
            }
        EXPECT_LT(error.manyRays, error.of[kAll & ~kRays]);
    }
};

TEST_F(SourcesTest, MoreAreNotWorseInAHall) {
    expectMoreIsNotWorse(errors(hallJob(96, 54)));
}

TEST_F(SourcesTest, MoreAreNotWorseInTheOpen) {
    GLINT_NEED_ASSET(path, "scenes/stage1.glb");
    expectMoreIsNotWorse(errors(openJob(path, 96, 54)));
}

} // namespace sources_test
} // namespace glint::test
