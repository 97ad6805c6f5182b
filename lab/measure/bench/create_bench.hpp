// Measures what a host pays for creating the library's objects: the first time, with a pipeline cache, and once more.
#pragma once

#include "glint/settings.hpp"
#include "gpu/context.hpp"
#include "lab/measure/bench/effect_times.hpp"

#include <functional>
#include <string>
#include <vector>

namespace glint::measure {

struct CreatePlan {
    struct Config {
        std::string name;
        Settings settings;
    };
    std::vector<Config> configs;
    uint32_t width = 1280; ///< pixels
    uint32_t height = 720;
    uint32_t repeats = 5; ///< of each measurement but the first creation; >= 1
};

/// Wall-clock milliseconds of the calls, which compile on all cores. Medians, but for `firstMs`.
struct CreateTimes {
    double firstMs = 0;  ///< on a Context without pipelines, with an empty VkPipelineCache
    double cachedMs = 0; ///< on a new Context, with the pipeline cache that the first creation filled
    double againMs = 0;  ///< on a Context on which such an object exists
};

struct CreateFigures {
    std::string config;
    CreateTimes reflections;  ///< Reflections::create
    bool rays = false;        ///< the settings enable the source rays; otherwise `setRays` is 0
    CreateTimes setRays;      ///< Reflections::setRays with a SurfaceTable, after each of these creations
    double resizeMs = 0;      ///< Reflections::resize: all images, no pipelines
    size_t pipelineBytes = 0; ///< data of the pipeline cache; little if the driver keeps machine code elsewhere
};

struct CreateResult {
    std::string device;
    std::string driver;
    CreatePlan plan;
    std::vector<CreateFigures> figures; ///< one for each config
};

/// A driver may also have caches of its own, on disk and in the process, which `first` then shows: the former can be
/// switched off; of the latter nothing is seen by the first config.
/// `context`   created, not adopted; its own pipelines are not used
/// `progress`  is called with each config before it is measured; may be empty
/// Errors: InvalidArgument (settings), OutOfMemory, Unsupported.
Result<CreateResult> measureCreation(gpu::Context& context, const CreatePlan& plan,
                                     const std::function<void(const std::string&)>& progress = {});

} // namespace glint::measure
