// Which passes a frame has: one struct of named decisions, computed from settings and facts about the host's images and
// sources by a pure function, without a device. Stages read it from their StageContext.
#pragma once

#include "glint/reflections.hpp"

namespace glint::reflect {

/// What the decisions depend on.
struct PlanInputs {
    Settings settings;
    // Of ReflectionsDesc.
    uint32_t width = 0;
    uint32_t height = 0;
    bool views = false;
    bool inspection = false;
    bool statistics = false;
    bool transparentLayers = false;
    bool inputCheck = false;
    // The host's images.
    bool manySamples = false;      ///< several samples per pixel
    bool resolvesMaterial = false; ///< no image of the host holds F0 as it is
    bool backDepth = false;
    bool backDepthFits = false; ///< it has one texel per pixel
    bool transparentDepth = false;
    bool coat = false; ///< a clear coat is stated
    bool environment = false;
    bool compositeOutput = false;  ///< Outputs::composite
    bool reflectionOutput = false; ///< Outputs::reflection
    // The host's sources.
    bool scene = false;      ///< setRays was called
    bool shadesHits = false; ///< with ShadeHits
    bool mirrors = false;    ///< setPlanar was called, and there are mirrors
    bool probes = false;     ///< the same for probes
    // The frame's pixels in use (View::width, height).
    uint32_t extentWidth = 0;
    uint32_t extentHeight = 0;

    void setImages(const GBuffer& gbuffer, const EnvironmentMap& around);
};

/// Every decision: its name and its meaning.
#define GLINT_FRAME_PLAN(X)                                                                                            \
    X(screen, "the source `screen` is enabled")                                                                        \
    X(rays, "the source `rays` is enabled and has a scene")                                                            \
    X(planar, "the source `planar` is enabled and has mirrors")                                                        \
    X(probes, "the source `probes` is enabled and has probes")                                                         \
    X(sky, "the source `sky` is enabled and has an environment")                                                       \
    X(reflects, "a source answers, or debug colours are shown")                                                        \
    X(records, "the frame has passes; otherwise litRadiance is returned as it is")                                     \
    X(manySamples, "prepare/surface_samples prepares the host's several samples per pixel")                            \
    X(classifiesEarly, "prepare/classified also finds the pixels that need a ray; otherwise trace/classify does")      \
    X(resolvesMaterial, "F0 and coverage are stored in an image")                                                      \
    X(backFaces, "the host's back faces give surfaces their thickness")                                                \
    X(backFacesInPlace, "back faces are read from the host's image; otherwise prepare/back_faces converts them")       \
    X(pyramid, "prepare/pyramid builds the depth pyramid")                                                             \
    X(previousColors, "hits take their colours from the previous frame, which is kept")                                \
    X(previousEnds, "paths end in the previous frame's picture, which is kept")                                        \
    X(tracesScreen, "the screen's rays are listed and marched")                                                        \
    X(cones, "trace/picture makes smaller copies of the picture for cones of rough surfaces")                          \
    X(transparents, "trace/transparents marches among transparent surfaces")                                           \
    X(keepsRecord, "the outcome of every ray is stored")                                                               \
    X(storesListedOnly, "pixels without a ray store no answer")                                                        \
    X(blur, "resolve/blur blurs the screen's answers")                                                                 \
    X(upsample, "resolve/upsample brings the screen's answers to the frame's size")                                    \
    X(sampleLights, "rays/reflect_lights samples lights")                                                              \
    X(interpolatesRays, "rays/interpolate answers for pixels between rays")                                            \
    X(shadesHits, "the host shades the hits of rays")                                                                  \
    X(denoise, "denoise/gather to denoise/filter join and denoise the answers of screen and rays")                     \
    X(followsPaths, "rays/sentinels follows paths to find light that changes")                                         \
    X(followsPlaces, "denoise/sentinels follows places of the picture to find light that changes")                     \
    X(findsChange, "denoise/change finds tiles whose light has changed")                                               \
    X(ratesRays, "denoise/rate sets how many rays the next frame sends")                                               \
    X(stabilizes, "denoise/stabilize steadies the brightness of what is shown")                                        \
    X(combines, "hierarchy/combine writes the reflections alone; otherwise composite/combined does both in one pass")  \
    X(composites, "there is an image with reflections")                                                                \
    X(coat, "the host's clear coats have rays and answers of their own, in passes that run once more for them")        \
    X(layers, "transparent layers can follow the frame")                                                               \
    X(countsRays, "composite/statistics counts the rays' outcomes")

struct FramePlan {
#define GLINT_DECISION(name, meaning) bool name = false;
    GLINT_FRAME_PLAN(GLINT_DECISION)
#undef GLINT_DECISION
    bool operator==(const FramePlan&) const = default;
};

FramePlan planFrame(const PlanInputs& inputs);

/// The decisions by name, in the order of the list.
std::vector<FrameDecision> decisionsOf(const FramePlan& plan);

/// Returns the traced size for an image side of `pixels`: scaled by screen.resolutionScale, at least one pixel.
uint32_t tracedPixels(const Settings& settings, uint32_t pixels);
/// Returns the side of the blur's images for `traced` pixels: divided by blur.downsample + 1, rounded up.
uint32_t blurredPixels(const Settings& settings, uint32_t traced);

} // namespace glint::reflect
