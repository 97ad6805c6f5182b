#include "lab/tune/frame_work.hpp"

namespace glint::tune {
namespace {

/// Below about this perceptual roughness the denoiser passes reflections untouched (docs/techniques/rough.md).
constexpr float kMirrorRoughness = 0.016f;

double trianglesOf(const scene::Pose& pose) {
    double indices = 0;
    for (const scene::DrawItem& item : pose.items)
        indices += static_cast<double>(item.geometry->indices.size());
    return indices / 3;
}

} // namespace

Result<RoughShare> roughShare(render::ReflectionSession& session) {
    GLINT_TRY(roughness, session.readView("roughness"));
    GLINT_TRY(reflectivity, session.readView("reflectivity"));
    RoughShare share;
    const double pixel = 4 / static_cast<double>(roughness.rgba.size());
    for (size_t i = 0; i < roughness.rgba.size(); i += 4)
        if (reflectivity.rgba[i] > 0 && roughness.rgba[i] > kMirrorRoughness)
            share.add(roughness.rgba[i], pixel);
    return share;
}

FrameWork frameWork(const Settings& settings, const render::ReflectionSession& session, const render::FrameTimes& times,
                    bool drawn, const RoughShare& rough) {
    FrameWork work;
    work.settings = &settings;
    work.stats = session.stats();
    work.pixels = double(session.inputs().width) * session.inputs().height;
    work.rough = rough;
    work.triangles = trianglesOf(session.inputs().pose);
    work.lights = static_cast<double>(session.inputs().pose.lights.size());
    for (const auto& [name, milliseconds] : times.effectPasses)
        work.passes.push_back(name);
    for (const auto& [name, milliseconds] : times.hostPasses)
        if (drawn && name.starts_with("render/back_faces"))
            work.passes.push_back(name);
    return work;
}

} // namespace glint::tune
