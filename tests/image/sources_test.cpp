// Sources together on whole scenes, held against rays for everything: each of the 32 choices of the five renders, and
// with another one on top the picture is not worse. Rays, one a pixel, add their noise; with sixteen they make it
// better. docs/techniques/composite.md has the figures.
#include "image/job_test.hpp"
#include "render/bake_job.hpp"
#include "render/probe_file.hpp"
#include "support/assets.hpp"
#include "support/temp_folder.hpp"

#include "base/file.hpp"
#include "scene/builtin.hpp"

#include <array>
#include <cmath>

namespace glint::test {
namespace {

constexpr unsigned kScreen = 1, kRays = 2, kPlanar = 4, kProbes = 8, kSky = 16, kSources = 5;

std::string nameOf(unsigned sources) {
    constexpr std::array kNames = {"screen ", "rays ", "planar ", "probes ", "sky "};
    std::string name;
    for (unsigned s = 0; s < kSources; ++s)
        name += (sources >> s & 1) != 0 ? kNames[s] : "";
    return name.empty() ? "none" : name;
}

class SourcesTest : public JobTest {
protected:
    static render::RenderJob makeJob(const std::string& scene) {
        render::RenderJob job;
        job.scene = scene;
        job.width = 160;
        job.height = 90;
        job.display = true;
        job.planar = render::MirrorSearch::Auto;
        job.settings = settingsOf({"rays.bounces=2"});
        return job;
    }

    static std::vector<uint8_t> draw(render::JobSession& session, render::ProgramSettings settings, unsigned sources,
                                     uint32_t frames) {
        Settings& on = settings.reflections;
        on.screen.enabled = (sources & kScreen) != 0;
        on.rays.enabled = (sources & kRays) != 0;
        on.planar.enabled = (sources & kPlanar) != 0;
        on.probes.enabled = (sources & kProbes) != 0;
        on.sky.enabled = (sources & kSky) != 0;
        must(session.setSettings(settings));
        for (uint32_t frame = 0; frame < frames; ++frame)
            must(session.renderFrame(frame));
        return must(session.readView("composite")).rgb8;
    }

    /// Mean difference from the reference in bytes, of every choice of sources.
    static std::array<double, 32> errors(render::RenderJob job) {
        const TempFolder folder;
        render::BakeOptions options;
        options.most = 4;
        options.faceSize = 128;
        const render::ProbeSet set = must(render::runBakeJob(device(), job, options));
        job.probes = folder + "scene.probes";
        EXPECT_TRUE(writeFile(job.probes, render::encodeProbes(set)));
        render::JobSession session = must(render::JobSession::create(device(), job));
        render::ProgramSettings settings = job.settings;
        settings.reflections.rays.samples = 16;
        settings.reflections.rays.accumulate = true;
        const std::vector<uint8_t> reference = draw(session, settings, kRays | kSky, 4);
        std::array<double, 32> out = {};
        for (unsigned sources = 0; sources < out.size(); ++sources) {
            const std::vector<uint8_t> picture = draw(session, job.settings, sources, 1);
            for (size_t i = 0; i < picture.size(); ++i)
                out[sources] += std::abs(int(picture[i]) - int(reference[i]));
            out[sources] /= static_cast<double>(picture.size());
            RecordProperty(nameOf(sources), std::to_string(out[sources]));
        }
        return out;
    }

    static void expectMoreIsNotWorse(const std::array<double, 32>& error) {
        for (unsigned sources = 0; sources < error.size(); ++sources)
            for (const unsigned source : {kScreen, kPlanar, kProbes, kSky}) {
                const unsigned more = sources | source;
                EXPECT_LE(error[more], 1.03 * error[sources] + 0.05) << nameOf(more) << "against " << nameOf(sources);
            }
    }
};

TEST_F(SourcesTest, MoreAreNotWorseInAHall) {
    render::RenderJob job = makeJob("builtin:hall");
    for (const scene::BuiltinInfo& info : scene::builtinScenes()) // lit as our programs light it
        if (info.name == "hall")
            job.settings.render.environment.strength = info.environmentStrength;
    expectMoreIsNotWorse(errors(job));
}

TEST_F(SourcesTest, MoreAreNotWorseInTheOpen) {
    GLINT_NEED_ASSET(path, "scenes/stage1.glb");
    render::RenderJob job = makeJob(path);
    job.camera = (assetsFolder() / "scenes/stage1.camera.json").string();
    job.environment = (assetsFolder() / "env/lebombo_1k.hdr").string();
    job.settings.render.environment.strength = 0.6f;
    expectMoreIsNotWorse(errors(job));
}

} // namespace
} // namespace glint::test
