// Several settings on one view of one scene: how right their rays are, what they cost, and their pictures.
#pragma once

#include "gpu/context.hpp"
#include "measure/effect_times.hpp"
#include "measure/exact_picture.hpp"
#include "measure/ray_hits.hpp"
#include "render/render_job.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// One `--config`.
struct ComparedConfig {
    std::string name; ///< as it was written
    render::RenderJob job;
};

/// How far a picture is from the reference's.
struct ReferenceError {
    double psnr = 0;        ///< dB, of all pixels (measure::psnr)
    double psnrMirrors = 0; ///< dB, of mirrors: what reflects with perceptual roughness up to 0.01
    double relativeMse = 0; ///< of all pixels
    double relativeMseMirrors = 0;
    uint64_t mirrorPixels = 0;
};

struct ConfigFigures {
    std::string name;
    render::ProgramSettings settings;
    measure::HitReport hits; ///< with every reflective pixel traced along its mirror direction (hitSettings)
    std::optional<measure::MirrorError> exact;
    std::optional<ReferenceError> reference;
    measure::EffectTimes times;
    render::RenderStats stats; ///< of the picture itself, thresholds in force
    std::vector<std::string> notes;
    std::vector<uint8_t> composite; ///< RGB bytes
    std::vector<uint8_t> outcome;   ///< RGB bytes
};

struct Comparison {
    std::string scene;
    uint32_t width = 0;
    uint32_t height = 0;
    std::string device;
    std::string driver;
    bool software = false;
    std::string reference; ///< its name; empty: there is none
    std::string noExact;   ///< why there is no exact picture; empty: there is one
    std::vector<ConfigFigures> configs;
};

/// `configs`   at least one; all of them the same scene, view and size
/// `reference` what their pictures are held against, with its job's number of frames; may be absent
/// `frames`    of the effect that are timed for each config, >= 1
/// `progress`  is told what comes next; may be empty
/// Errors: as the scene's readers and the device give them.
Result<Comparison> compareConfigs(gpu::Context& context, const std::vector<ComparedConfig>& configs,
                                  const std::optional<ComparedConfig>& reference, uint32_t frames,
                                  const std::function<void(const std::string&)>& progress = {});

} // namespace glint::cli
