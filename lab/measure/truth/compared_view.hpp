// One view of one scene, opened once, on which configs are measured one after another.
#pragma once

#include "lab/measure/bench/floor_pass.hpp"
#include "lab/measure/truth/comparison.hpp"
#include "lab/measure/truth/job_hits.hpp"
#include "lab/session/reflection_session.hpp"

namespace glint::measure {

/// What a config's image is compared with. All images have one size.
struct ReferenceImages {
    std::vector<uint8_t> displayed;  ///< RGB bytes
    std::vector<float> radiance;     ///< four floats per pixel: linear radiance
    std::vector<float> roughness;    ///< view "roughness", four floats per pixel
    std::vector<float> reflectivity; ///< view "reflectivity", four floats per pixel
};

/// The figures of a config do not depend on the configs measured before it.
class ComparedView {
public:
    /// Reads the scene of the job; its settings are replaced by those of each config. Errors: those of the scene's
    /// readers and the device.
    static Result<ComparedView> open(gpu::Context& context, const render::RenderJob& job);

    uint32_t width() const { return session_.inputs().width; }
    uint32_t height() const { return session_.inputs().height; }
    const std::string& noExact() const { return noExact_; } ///< Comparison::noExact
    const std::vector<uint8_t>& withoutReflections() const { return withoutReflections_; }

    /// Renders the job's number of frames and reads the last one.
    Result<ReferenceImages> drawReference(const ComparedConfig& reference);
    /// Later configs are compared with it. `images` must have the view's size.
    void setReference(const ReferenceImages& images);

    /// Is called with the last frame of the first seed, while the session shows it.
    using Drawn = std::function<Result<void>(render::ReflectionSession&, const render::FrameTimes&)>;

    struct Amount {
        uint32_t frames = 1; ///< as for compareConfigs
        uint32_t seeds = 1;  ///< as for compareConfigs
        bool hits = true;    ///< also trace mirror rays and compare them with the exact ones
    };
    /// `drawn`  may be empty
    Result<ConfigFigures> measure(const ComparedConfig& config, const Amount& amount, const Drawn& drawn = {});

private:
    ComparedView(render::ReflectionSession session, FloorPass floor, uint32_t seed)
        : session_(std::move(session)), floor_(std::move(floor)), seed_(seed) {}
    void makeExactPicture();
    Result<void> useSeed(uint32_t seed);
    Result<render::FrameTimes> timeFrames(EffectTimes& measured, const render::ProgramSettings& settings,
                                          uint32_t frames);
    Result<void> takePictures(ConfigFigures& figures);
    Result<void> addSeed(uint32_t seed, uint32_t frames, ConfigFigures& figures);
    Result<void> measureHits(ConfigFigures& figures);

    render::ReflectionSession session_;
    FloorPass floor_;
    uint32_t seed_; ///< of the session
    std::optional<ExactPicture> exact_;
    std::string noExact_;
    TruthKeeper truth_;
    std::optional<ReferencePicture> reference_;
    std::vector<uint8_t> withoutReflections_;
};

} // namespace glint::measure
