// Compares several settings on one view of one scene: the correctness of their rays, their cost, and their images.
#pragma once

#include "gpu/context.hpp"
#include "lab/job/render_job.hpp"
#include "lab/measure/bench/effect_times.hpp"
#include "lab/measure/truth/exact_picture.hpp"
#include "lab/measure/truth/ray_hits.hpp"
#include "lab/measure/truth/reference_error.hpp"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace glint::measure {

/// One `--config`.
struct ComparedConfig {
    std::string name; ///< as the user wrote it
    render::RenderJob job;
};

/// One more rendering of a config, with another seed: shows how far its figures depend on noise.
struct SeedFigures {
    uint32_t seed = 0;
    std::optional<MirrorError> exact;
    std::optional<ReferenceError> reference;
    double floorMultiple = 0;
    std::vector<uint8_t> composite; ///< RGB bytes
};

struct ConfigFigures {
    std::string name;
    render::ProgramSettings settings;
    HitReport hits; ///< measured with every reflective pixel traced along its mirror direction (hitSettings)
    std::optional<MirrorError> exact;
    std::optional<ReferenceError> reference;
    EffectTimes times;
    render::RenderStats stats; ///< of the rendered image, with the thresholds in force
    std::vector<std::string> notes;
    std::vector<uint8_t> composite; ///< RGB bytes
    std::vector<uint8_t> outcome;   ///< RGB bytes
    std::vector<uint8_t> source;    ///< RGB bytes
    std::vector<SeedFigures> seeds; ///< further seeds; the figures above are of the first
};

struct Comparison {
    std::string scene;
    uint32_t width = 0;
    uint32_t height = 0;
    std::string device;
    std::string driver;
    bool software = false;
    std::string reference;                   ///< name of the reference; empty: none
    std::string noExact;                     ///< the reason why there is no exact picture; empty: there is one
    std::vector<uint8_t> withoutReflections; ///< RGB bytes: the frame of the first config without them
    std::vector<uint8_t> referencePicture;   ///< RGB bytes; empty: no reference
    std::vector<ConfigFigures> configs;
};

/// `configs`   at least one; all with the same scene, view and size
/// `reference` rendered with its job's number of frames and compared with each config's image; may be absent
/// `frames`    frames of the effect that are timed for each config, >= 1
/// `progress`  is called with each next step; may be empty
/// `seeds`     each config is rendered and timed with so many seeds, its job's and those after it; >= 1
/// Errors: those of the scene's readers and the device.
Result<Comparison> compareConfigs(gpu::Context& context, const std::vector<ComparedConfig>& configs,
                                  const std::optional<ComparedConfig>& reference, uint32_t frames,
                                  const std::function<void(const std::string&)>& progress = {}, uint32_t seeds = 1);

} // namespace glint::measure
