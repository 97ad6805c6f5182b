#include "lab/measure/truth/job_hits.hpp"

#include "base/assert.hpp"

#include <algorithm>

namespace glint::measure {
namespace {

const std::vector<float>& viewOf(const render::RenderResult& result, std::string_view name) {
    const auto view = std::ranges::find(result.views, name, &render::RenderedView::name);
    GLINT_ASSERT(view != result.views.end(), "the result has no view {}", name);
    return view->rgba;
}

/// The views "reflectivity" and "roughness" as GBufferPicture::material.
std::vector<float> materialOf(const render::RenderResult& result) {
    std::vector<float> material = viewOf(result, "reflectivity");
    const std::vector<float>& roughness = viewOf(result, "roughness");
    for (size_t i = 0; i < material.size(); i += 4)
        material[i + 3] = roughness[i];
    return material;
}

std::vector<float> copyOf(std::span<const float> values) {
    return {values.begin(), values.end()};
}

} // namespace

bool statesCertainty(const render::ProgramSettings& settings) {
    const ScreenSettings& screen = settings.reflections.screen;
    return screen.enabled && screen.march != March::Proxy && screen.resolutionScale >= 1;
}

render::ProgramSettings hitSettings(const render::ProgramSettings& settings) {
    render::ProgramSettings all = settings;
    Settings& reflections = all.reflections;
    reflections.reflect.threshold = 0;
    reflections.reflect.roughnessFadeStart = 1;
    reflections.reflect.maxRoughness = 1;
    reflections.rough.factor = 0;
    reflections.denoise.enabled = false; // rays along the mirror direction
    reflections.blur.strength = 0;
    reflections.debug.certainty = statesCertainty(settings);
    if (reflections.debug.certainty)
        reflections.screen.targetFormat = TargetFormat::Rgba16f; // numbers above 1
    all.render.display.antialias = render::Antialias::None;      // one surface per pixel
    return all;
}

std::vector<std::string> hitViews() {
    return {"depth", "normal", "reflectivity", "ray", "roughness", "color"};
}

render::RenderJob hitJob(const render::RenderJob& job) {
    render::RenderJob traced = job;
    traced.settings = hitSettings(job.settings);
    traced.views = hitViews();
    traced.display = false;
    traced.statistics = true;
    traced.progress = {};
    return traced;
}

Result<HitReport> measureHits(const render::RenderJob& job, const render::RenderResult& result) {
    GLINT_TRY(inputs, render::loadJobInputs(job));
    return TruthKeeper().judge(inputs, render::makeView(inputs.camera, result.width, result.height), result,
                               statesCertainty(job.settings));
}

Result<HitReport> TruthKeeper::judge(const render::JobInputs& inputs, const render::View& view,
                                     const render::RenderResult& traced, bool knowsCertainty) {
    const std::vector<float> material = materialOf(traced);
    const GBufferPicture gbuffer = {viewOf(traced, "depth"), viewOf(traced, "normal"), material};
    if (!oracle_) {
        GLINT_TRY(oracle, RayOracle::create(*inputs.scene, inputs.pose));
        oracle_ = std::move(oracle);
    }
    std::vector<std::vector<float>> now = {copyOf(gbuffer.viewZ), copyOf(gbuffer.normalWS), copyOf(gbuffer.material)};
    if (now != gbuffer_) {
        truths_ = traceTruth(*oracle_, view, gbuffer);
        gbuffer_ = std::move(now);
    }
    std::span<const float> certainty;
    if (knowsCertainty)
        certainty = viewOf(traced, "color");
    return judgeHits(view, gbuffer, truths_, viewOf(traced, "ray"), certainty);
}

} // namespace glint::measure
