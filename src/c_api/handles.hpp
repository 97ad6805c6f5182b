// The objects behind the handles of the C interface.
#pragma once

#include "glint/glint.h"
#include "glint/glint.hpp"

#include <string>
#include <utility>
#include <vector>

/// With the list that was read last (glint_context_memory).
struct GlintContext {
    glint::Context context;
    glint::MemoryReport memory;
    std::vector<GlintMemoryUse> memoryUses;
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
    GlintReflections(glint::Reflections&& made, bool inspected) : reflections(std::move(made)), inspects(inspected) {}

    glint::Reflections reflections;
    bool inspects; ///< ReflectionsDesc::inspection
    std::vector<std::string> passImages;
    std::vector<glint::PassTime> passTimes;
    std::vector<std::string> notes;
    std::vector<std::string> outcomeNames;
    std::vector<GlintOutcome> outcomes;
    std::vector<std::string> inputFindings;
    std::vector<GlintRaySample> raySamples;
    std::vector<GlintRayFade> rayFades;
    std::vector<GlintRaySource> raySources;
};
