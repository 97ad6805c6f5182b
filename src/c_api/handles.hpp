// The objects behind the handles of the C interface.
#pragma once

#include "glint/glint.h"
#include "glint/glint.hpp"

#include <string>
#include <utility>
#include <vector>

struct GlintContext {
    glint::Context context;
};

struct GlintSettings {
    glint::Settings settings;
};

struct GlintRayScene {
    glint::RayScene scene;
};

struct GlintSurfaceTable {
    glint::SurfaceTable table;
};

struct GlintPlanarMirrors {
    glint::PlanarMirrors mirrors;
};

struct GlintProbes {
    glint::Probes probes;
};

/// With the lists that were read last (glint_reflections_read_...).
struct GlintReflections {
    explicit GlintReflections(glint::Reflections&& made) : reflections(std::move(made)) {}

    glint::Reflections reflections;
    std::vector<std::string> passImages;
    std::vector<glint::PassTime> passTimes;
    std::vector<std::string> notes;
    std::vector<std::string> outcomeNames;
    std::vector<GlintOutcome> outcomes;
};
