// The plan of a sweep (docs/sweep.md): scenes, sizes, settings and seeds, of which every combination is a job.
#pragma once

#include "base/result.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/job/program_settings.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glint::cli {

struct SweepScene {
    std::string name; ///< in tables; no two scenes share one
    RenderOptions options;
};

struct SweepConfig {
    std::string name; ///< in tables; no two configs share one
    render::SettingsRequest settings;
};

/// By default its noise is that of no config, as in a search.
constexpr uint32_t kSweepReferenceSeed = 0x9e37;

struct SweepReference {
    SweepConfig config;
    std::optional<uint32_t> frames; ///< absent: defaultReferenceFrames
    uint32_t seed = kSweepReferenceSeed;
};

struct SweepMotion {
    std::string path = "pan";
    double speed = 2;             ///< pixels per frame
    std::optional<uint32_t> stop; ///< frame from which the camera stands
    uint32_t frames = 24;
    double fps = 60;
    uint32_t samples = 0; ///< of the reference, which is SweepPlan::reference's config; 0: no reference
};

struct SweepPlan {
    std::vector<SweepScene> scenes;
    std::vector<std::string> sizes; ///< "WIDTHxHEIGHT", or empty: the camera's own
    std::vector<SweepConfig> configs;
    std::vector<uint32_t> seeds;
    std::optional<SweepReference> reference;
    bool stills = true;
    bool hits = true;    ///< stills are compared with exact rays
    uint32_t frames = 5; ///< to time in each still
    std::optional<SweepMotion> motion;

    size_t jobCount() const {
        return scenes.size() * sizes.size() * configs.size() * ((stills ? seeds.size() : 0) + (motion ? 1 : 0));
    }
};

/// More jobs than this are an error: each is a file, and each process of a sweep reads their list.
constexpr size_t kMostSweepJobs = 200000;

/// Settings have not been compared with the table yet: their scene has a part in that. `name` is used in messages.
/// Errors: InvalidInput with the place in the file.
Result<SweepPlan> readSweepPlan(std::string_view text, const std::string& name);

} // namespace glint::cli
