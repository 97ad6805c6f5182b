// A report with made-up figures: two configs with two seeds, on images of 8 x 4 pixels.
#pragma once

#include "lab/cli/report/report.hpp"

namespace glint::test {

inline std::vector<uint8_t> filled(uint8_t value) {
    return std::vector<uint8_t>(size_t(8) * 4 * 3, value);
}

/// `error` is the first config's relative mean squared error with the first seed; the second seed has a tenth more.
inline cli::ReportScene madeUpScene(const std::string& name, double error = 0.5) {
    measure::Comparison comparison;
    comparison.scene = name;
    comparison.width = 8;
    comparison.height = 4;
    comparison.device = "device <b>";
    comparison.driver = "driver & co";
    comparison.software = true;
    comparison.reference = "reference";
    comparison.noExact = "the scene has an environment";
    comparison.withoutReflections = filled(10);
    comparison.referencePicture = filled(100);
    for (size_t i = 0; i < 2; ++i) {
        measure::ConfigFigures config;
        config.name = i == 0 ? "first" : "</script><script>alert(1)</script>";
        config.hits.classes.assign(32, measure::HitClass::Right);
        config.hits.all.rays = config.hits.all.visibleTruths = config.hits.all.reported = 32;
        config.hits.all.right = i == 0 ? 32 : 16;
        config.composite = filled(static_cast<uint8_t>(90 + i));
        config.outcome = filled(128);
        config.source = filled(64);
        measure::ReferenceError reference;
        reference.bands[measure::kBands] = {32, error};
        config.reference = reference;
        measure::SeedFigures seed;
        seed.seed = 1;
        seed.composite = filled(static_cast<uint8_t>(92 + i));
        seed.reference = reference;
        seed.reference->bands[measure::kBands].relativeMse = 1.1 * error;
        config.seeds.push_back(seed);
        comparison.configs.push_back(std::move(config));
    }
    return cli::reportScene(std::move(comparison), {"glint render a", "glint render b"}, "");
}

/// Frames in motion: of each config three, of two by one pixels.
inline void addMadeUpMotion(cli::ReportScene& scene) {
    measure::Sequence motion;
    motion.width = 2;
    motion.height = 1;
    motion.frames = 3;
    motion.fps = 60;
    for (const measure::ConfigFigures& config : scene.comparison.configs) {
        measure::SequenceConfig moving;
        moving.name = config.name;
        motion.configs.push_back(std::move(moving));
        scene.frames.configs.push_back({"frame 0", "frame 1", "frame 2"});
    }
    scene.frames.width = 2;
    scene.frames.height = 1;
    scene.motion = std::move(motion);
    scene.path = "pan";
}

} // namespace glint::test
