// Whole scenes rendered with selected sources of reflections, and the reference: rays for everything.
#pragma once

#include "base/file.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/session/bake_job.hpp"
#include "lab/sources/probe_file.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/assets.hpp"
#include "tests/support/temp_folder.hpp"

namespace glint::test {

constexpr unsigned kScreen = 1, kRays = 2, kPlanar = 4, kProbes = 8, kSky = 16, kSources = 5, kAll = 31;

inline void choose(render::ProgramSettings& settings, unsigned sources) {
    Settings& on = settings.reflections;
    on.screen.enabled = (sources & kScreen) != 0;
    on.rays.enabled = (sources & kRays) != 0;
    on.planar.enabled = (sources & kPlanar) != 0;
    on.probes.enabled = (sources & kProbes) != 0;
    on.sky.enabled = (sources & kSky) != 0;
}

/// Rays for everything; each frame adds `samples` a pixel.
inline render::ProgramSettings referenceOf(render::ProgramSettings settings, uint32_t samples) {
    choose(settings, kRays | kSky);
    settings.reflections.rays.samples = samples;
    settings.reflections.rays.accumulate = true;
    return settings;
}

/// As displayed, with all sources available: planar mirrors are searched for, and two bounces are traced, as probes
/// have them.
inline render::RenderJob hallJob(uint32_t width, uint32_t height) {
    render::RenderJob job;
    job.scene = "builtin:hall";
    job.width = width;
    job.height = height;
    job.display = true;
    job.planar = render::MirrorSearch::Auto;
    job.settings = settingsOf({"rays.bounces=2"});
    job.settings.render.environment.strength = scene::findBuiltin("hall")->environmentStrength; // as in our programs
    return job;
}

/// The same for spheres and a wall on an open floor.
inline render::RenderJob openJob(const std::string& scene, uint32_t width, uint32_t height) {
    render::RenderJob job = hallJob(width, height);
    job.scene = scene;
    job.camera = (assetsFolder() / "scenes/stage1.camera.json").string();
    job.environment = (assetsFolder() / "env/lebombo_1k.hdr").string();
    job.settings.render.environment.strength = 0.6f;
    return job;
}

/// Bakes probes for the job, stores them in `folder` and sets them in the job.
inline void bakeProbes(gpu::Context& device, render::RenderJob& job, const TempFolder& folder) {
    render::BakeOptions options;
    options.most = 4;
    options.faceSize = 128;
    const render::ProbeSet set = must(render::runBakeJob(device, job, options));
    job.probes = folder + "scene.probes";
    EXPECT_TRUE(writeFile(job.probes, render::encodeProbes(set)));
}

} // namespace glint::test
