// SPDX-License-Identifier: MIT
// Every setting of the library, each stated once: SETTING(type, name, default, range, unit, meaning, aliases, search).
// Aliases are the names that other systems use: `system:name`, separated by spaces. One alias may belong to several
// settings. A suffix converts the other system's value:
//   `=1-x`, `=1/(n+1)`   this formula
//   `=a|b`               a switch: a if false, b if true
//   `=0:a|2:b`           the other system's numbers for our values; our value names work too
//   `=r`, `=g`, `=b`     this component of a colour
//   `=a`                 sets a, whatever the value
//   `=a>b`               sets b if a was set
// `search` says how `glint tune` varies the setting; a setting without it is a matter of the scene, the host or the
// look, and is never varied. Parts separated by `;`:
//   `linear 0..4`, `log 1..64`   the interval worth searching, and the scale on which steps count alike
//   `choice`, `switch`           every value of an enum; on and off
//   `if KEY=a|b`, `if KEY>n`     the setting has an effect only then, and only where KEY has one; all of several hold
//   `motion`                     it matters only where something moves
//   `cost +`, `cost -`           larger values cost more, or less
#pragma once

// clang-format off

#define GLINT_SCREEN_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Trace reflections in screen space; off: no screen-space pass runs",                                           \
        "babylon:isEnabled compute-ssr:enabled",                                                                       \
        "switch; cost +")                                                                                              \
    SETTING(March, march, March::Hiz, "", "",                                                                          \
        "March algorithm of screen-space rays: hiz, linear, adaptive, or proxy (one sample at a probe proxy's hit)",   \
        "hdrp:projectionModel",                                                                                        \
        "choice; if screen.enabled=true")                                                                              \
    SETTING(float, maxDistance, 1000, "(0, 1e6]", "m",                                                                 \
        "Maximum length of a screen-space ray, measured in 3D",                                                        \
        "babylon:maxDistance compute-ssr:distance",                                                                    \
        "log 1..1000; if screen.enabled=true; cost +")                                                                 \
    SETTING(int, maxSteps, 1000, "[1, 4096]", "",                                                                      \
        "Maximum iterations of a ray with screen.march linear; a ray that reaches this limit is a miss",               \
        "babylon:maxSteps",                                                                                            \
        "log 16..1024; if screen.march=linear; cost +")                                                                \
    SETTING(int, step, 1, "[1, 64]", "px",                                                                             \
        "Pixels per iteration with screen.march linear; larger: faster, but thin objects are missed",                  \
        "babylon:step",                                                                                                \
        "log 1..32; if screen.march=linear; cost -")                                                                   \
    SETTING(bool, smooth, true, "", "",                                                                                \
        "Refine each hit to one pixel; has an effect only with screen.step above 1",                                   \
        "babylon:enableSmoothReflections",                                                                             \
        "switch; if screen.step>1; cost +")                                                                            \
    SETTING(ThicknessMode, thicknessMode, ThicknessMode::Backface, "", "",                                             \
        "Depth of a surface behind its depth sample: constant, relative to distance, or from back-face depth",         \
        "hdrp:depthBufferThickness=relative babylon:thickness=relative>constant "                                      \
        "compute-ssr:thickness=relative>constant babylon:enableAutomaticThicknessComputation=constant|backface",       \
        "choice; if screen.march=hiz|linear|adaptive")                                                                 \
    SETTING(float, thickness, 0, "[0, 1e3]", "m",                                                                      \
        "Slab behind each depth sample in which a ray also hits; thicknessMode backface: behind the back face",        \
        "babylon:thickness compute-ssr:thickness",                                                                     \
        "linear 0..1; if screen.thicknessMode=constant|backface")                                                      \
    SETTING(float, thicknessRelative, 0.01f, "[0, 1]", "of viewZ",                                                     \
        "Slab behind each depth sample, as a fraction of its distance; used by thicknessMode relative only",           \
        "hdrp:depthBufferThickness",                                                                                   \
        "log 0.001..0.2; if screen.thicknessMode=relative")                                                            \
    SETTING(float, inferred, 1, "[0, 1]", "",                                                                          \
        "Weight of answers for rays that crossed a surface behind an occluder, from what shows of it beside; 0: off",  \
        "",                                                                                                            \
        "linear 0..1; if screen.march=hiz|linear|adaptive")                                                            \
    SETTING(int, selfCollisionSkip, 0, "[0, 16]", "iterations",                                                        \
        "Iterations at a ray's start that ignore hits, so that a surface does not hit itself; 0: none",                \
        "babylon:selfCollisionNumSkip",                                                                                \
        "linear 0..4; if screen.march=hiz|linear|adaptive")                                                            \
    SETTING(bool, clipToFrustum, true, "", "",                                                                         \
        "Clip the end of each screen-space ray to the view frustum",                                                   \
        "babylon:clipToFrustum")                                                                                       \
    SETTING(int, backfaceDownsample, 0, "[0, 8]", "",                                                                  \
        "The host draws back-face depth at size / (n + 1); larger: cheaper, but ragged silhouettes; 0: full size",     \
        "babylon:backfaceDepthTextureDownsample",                                                                      \
        "linear 0..4; if screen.thicknessMode=backface; cost -")                                                       \
    SETTING(bool, backfaceTransparents, true, "", "",                                                                  \
        "Treat transparent surfaces as solid in back-face depth",                                                      \
        "babylon:backfaceForceDepthWriteTransparentMeshes")                                                            \
    SETTING(bool, transparents, false, "", "",                                                                         \
        "Screen rays end at transparent surfaces (GBuffer::transparentDepth), with colours of the previous frame; off: "  \
        "rays pass through them",                                                                                      \
        "")                                                                                                            \
    SETTING(float, resolutionScale, 1, "[0.1, 1]", "",                                                                 \
        "Width and height of the traced image relative to the frame; the G-buffer keeps full resolution",              \
        "babylon:ssrDownsample=1/(n+1) compute-ssr:resolutionScale",                                                   \
        "linear 0.25..1; if screen.enabled=true; if denoise.enabled=false; cost +")                                    \
    SETTING(TargetFormat, targetFormat, TargetFormat::Auto, "", "",                                                    \
        "Format of the traced radiance: rgba16f, rgba8 (radiance scaled into [0, 1]), or auto (rgba16f)",              \
        "babylon:textureType=0:rgba8|2:rgba16f")                                                                       \
    SETTING(ColorSource, colorSource, ColorSource::Current, "", "",                                                    \
        "Colour of a hit: current frame, or previous frame with its reflections, reprojected",                         \
        "hdrp:colorSource",                                                                                            \
        "choice; if screen.enabled=true")                                                                              \
    SETTING(bool, highlights, false, "", "",                                                                           \
        "Keep highlights in hits on smooth surfaces; off: remove them if the host provides highlight-free means",      \
        "",                                                                                                            \
        "switch; if screen.enabled=true")

#define GLINT_HIZ_SETTINGS(SETTING)                                                                                    \
    SETTING(int, minLevel, 0, "[0, 14]", "",                                                                           \
        "Finest depth pyramid level that a ray of march hiz visits; above 0: faster, but blocky",                      \
        "hdrp:rayMinLevel",                                                                                            \
        "linear 0..3; if screen.march=hiz; cost -")                                                                    \
    SETTING(int, maxLevel, 10, "[0, 14]", "",                                                                          \
        "Coarsest depth pyramid level that a ray of march hiz visits",                                                 \
        "hdrp:rayMaxLevel",                                                                                            \
        "linear 3..12; if screen.march=hiz")                                                                           \
    SETTING(int, maxIterations, 128, "[1, 1024]", "",                                                                  \
        "Maximum cells that a ray of march hiz visits; a ray that reaches this limit is a miss",                       \
        "hdrp:rayMaxIterations",                                                                                       \
        "log 8..512; if screen.march=hiz; cost +")                                                                     \
    SETTING(float, depthBias, 0.001f, "[0, 1]", "of viewZ",                                                            \
        "Slab behind each surface, added to its thickness, in which a ray of march hiz also hits",                     \
        "hdrp:rayDepthSuccessBias",                                                                                    \
        "log 0.0001..0.1; if screen.march=hiz")

#define GLINT_ADAPTIVE_SETTINGS(SETTING)                                                                               \
    SETTING(int, steps, 64, "[1, 128]", "",                                                                            \
        "Minimum steps of a ray with screen.march adaptive; long rays take up to twice as many",                       \
        "compute-ssr:steps",                                                                                           \
        "log 8..128; if screen.march=adaptive; cost +")                                                                \
    SETTING(float, pixelSpacing, 8, "[1, 64]", "px",                                                                   \
        "Spacing of steps on screen: march adaptive adds steps, up to twice adaptive.steps, to reach it",              \
        "",                                                                                                            \
        "log 1..64; if screen.march=adaptive; cost -")                                                                 \
    SETTING(int, refinements, 5, "[0, 16]", "",                                                                        \
        "Binary search iterations of march adaptive at a crossing; each one halves the step",                          \
        "",                                                                                                            \
        "linear 0..8; if screen.march=adaptive; cost +")

#define GLINT_REFLECT_SETTINGS(SETTING)                                                                                \
    SETTING(float, threshold, 0, "[0, 1]", "",                                                                         \
        "Trace no ray where the quantity selected by reflect.thresholdOn is at most this value + 1/510",               \
        "babylon:reflectivityThreshold compute-ssr:reflectivityThreshold",                                             \
        "linear 0..0.2; cost -")                                                                                       \
    SETTING(ThresholdOn, thresholdOn, ThresholdOn::F0, "", "",                                                         \
        "Quantity compared with reflect.threshold: f0 (reflectance at normal incidence), or f0TimesStrength",          \
        "babylon:reflectivityThreshold=f0 compute-ssr:reflectivityThreshold=f0TimesStrength")                          \
    SETTING(float, strength, 1, "[0, 10]", "",                                                                         \
        "Multiplies reflections; 0: no reflections are traced",                                                        \
        "babylon:strength compute-ssr:intensity")                                                                      \
    SETTING(float, falloffExponent, 1, "(0, 16]", "",                                                                  \
        "Exponent of reflectance times reflect.strength; larger: weak reflections fade first",                         \
        "babylon:reflectionSpecularFalloffExponent")                                                                   \
    SETTING(bool, fresnel, true, "", "",                                                                               \
        "Increase reflectance toward grazing angles (Schlick); off: use F0 at every angle",                            \
        "babylon:useFresnel")                                                                                          \
    SETTING(float, roughnessFadeStart, 0.5f, "[0, 1]", "perceptual roughness",                                         \
        "Screen-space reflections have full weight up to this roughness and fade out above it",                        \
        "hdrp:smoothnessFadeStart=1-x",                                                                                \
        "linear 0..1; if screen.enabled=true")                                                                         \
    SETTING(float, maxRoughness, 0.6f, "[0, 1]", "perceptual roughness",                                               \
        "No screen-space ray from this roughness on; at or below roughnessFadeStart: hard cutoff just above it",       \
        "hdrp:minSmoothness=1-x",                                                                                      \
        "linear 0..1; if screen.enabled=true; cost +")

#define GLINT_ROUGH_SETTINGS(SETTING)                                                                                  \
    SETTING(float, factor, 0, "[0, 1]", "",                                                                            \
        "Jitters each screen-space ray by surface roughness times this factor; 0: mirror directions only",             \
        "babylon:roughnessFactor",                                                                                     \
        "linear 0..1; if screen.enabled=true; if denoise.enabled=false")                                              \
    SETTING(bool, cones, true, "", "",                                                                                 \
        "Blur each screen-space hit by the width of the surface's lobe there, without noise; acts where rays take "    \
        "mirror directions: without denoise.enabled, blur.strength and rough.factor",                                  \
        "",                                                                                                            \
        "switch; if screen.enabled=true; if denoise.enabled=false")

#define GLINT_BLUR_SETTINGS(SETTING)                                                                                   \
    SETTING(float, strength, 0, "[0, 1]", "",                                                                          \
        "Blurs screen-space reflections by roughness and hit distance; larger: wider; 0: no blur",                     \
        "babylon:blurDispersionStrength",                                                                              \
        "linear 0..0.3; if screen.enabled=true; if denoise.enabled=false; cost +")                                     \
    SETTING(int, quality, 2, "[1, 3]", "",                                                                             \
        "Number of taps of the reflection blur: 1: few, 2: medium, 3: many",                                           \
        "babylon:blurQuality",                                                                                         \
        "linear 1..3; if blur.strength>0; cost +")                                                                     \
    SETTING(int, downsample, 0, "[0, 8]", "",                                                                          \
        "The reflection blur runs at size / (n + 1); 0: full size",                                                    \
        "babylon:blurDownsample",                                                                                      \
        "linear 0..3; if blur.strength>0; cost -")

#define GLINT_REUSE_SETTINGS(SETTING)                                                                                  \
    SETTING(int, samples, 8, "[0, 16]", "",                                                                            \
        "With denoise.enabled: neighbouring pixels whose rays a rough pixel uses besides its own; 0: none",            \
        "",                                                                                                            \
        "linear 0..16; if denoise.enabled=true; cost +")                                                               \
    SETTING(float, radius, 8, "[1, 32]", "px",                                                                         \
        "With denoise.enabled: farthest pixel whose ray a rough pixel uses; narrow lobes look less far",               \
        "",                                                                                                            \
        "log 1..32; if reuse.samples>0")                                                                               \
    SETTING(RayRate, rate, RayRate::Adaptive, "", "",                                                                  \
        "Rough pixels that send a ray each frame, by screen and rays alike: full (all), checkerboard (half), quarter, or adaptive (a quarter or half of those that have settled); the others use neighbours' rays", \
        "",                                                                                                            \
        "choice; if reuse.samples>0; cost +")

#define GLINT_DENOISE_SETTINGS(SETTING)                                                                                \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Sample the lobe of rough surfaces with screen and rays together, and average over neighbours and frames; off: rays take mirror directions, and rough.cones blurs what they hit", \
        "",                                                                                                            \
        "switch; cost +")                                                                                              \
    SETTING(float, historySeconds, 0.5f, "[0, 4]", "s",                                                                \
        "Longest time over which frames are averaged; longer: less noise, but slower to follow changes of light",      \
        "",                                                                                                            \
        "log 0.1..1; if denoise.enabled=true; motion")                                                                 \
    SETTING(float, disocclusion, 0.005f, "[1e-4, 0.2]", "of viewZ",                                                    \
        "A place of the previous frame farther than this from the surface's plane is another surface",                 \
        "",                                                                                                            \
        "log 0.001..0.05; if denoise.enabled=true; motion")                                                            \
    SETTING(float, lobeTrail, 0.4f, "[0.05, 2]", "of the lobe",                                                        \
        "How far a moving reflection may lag, as a fraction of the lobe's width; smaller: sharper, but noisier in motion", \
        "",                                                                                                            \
        "log 0.05..2; if denoise.enabled=true; motion")                                                                \
    SETTING(VirtualMotion, virtualMotion, VirtualMotion::Curved, "", "",                                               \
        "Where the previous frame is looked up: where the surface was (surface), also where a flat mirror showed the reflection (flat), also where a curved one did (curved); with fewer places, more histories are lost while the camera moves", \
        "",                                                                                                            \
        "choice; if denoise.enabled=true; motion; cost +")                                                             \
    SETTING(bool, hitMotion, true, "", "",                                                                             \
        "Follow objects that move in reflections: by GBuffer motion where the frame shows them, by the instances' transforms where rays hit them", \
        "",                                                                                                            \
        "switch; if denoise.enabled=true; motion")                                                                     \
    SETTING(Antilag, antilag, Antilag::Gradient, "", "",                                                               \
        "What shortens the average where light changes: nothing, the difference between a short and the long average, or the last frame's rays followed again: through the RayScene or, without one, to places of the frame", \
        "",                                                                                                            \
        "choice; if denoise.enabled=true; motion; cost +")                                                             \
    SETTING(int, fastFrames, 6, "[1, 30]", "",                                                                         \
        "Frames in the short average, which denoise.antilag compares with the long one",                               \
        "",                                                                                                            \
        "log 1..30; if denoise.antilag=mean; motion")                                                                  \
    SETTING(float, firefly, 10, "[0, 1000]", "of the mean",                                                            \
        "Brightest new light kept, relative to the average over frames or to the pixels around; smaller: fewer bright points, but small lamps lose light; 0: all is kept", \
        "",                                                                                                            \
        "log 4..100; if denoise.enabled=true")                                                                         \
    SETTING(float, maxRadius, 16, "[0, 64]", "px",                                                                     \
        "Largest radius of the filter that smooths the noise that is left; 0: no filter",                              \
        "",                                                                                                            \
        "linear 0..32; if denoise.enabled=true; cost +")                                                               \
    SETTING(float, noiseTarget, 0.05f, "[0.005, 0.5]", "of the mean",                                                  \
        "Standard deviation above which the filter works at full strength; larger: sharper, but more grain is left",   \
        "",                                                                                                            \
        "log 0.005..0.5; if denoise.maxRadius>0")                                                                      \
    SETTING(float, stabilizeSeconds, 0, "[0, 4]", "s",                                                                 \
        "Longest time over which the brightness of what is shown is averaged within what the pixels around show: less flicker, but slower to follow changes; 0: not at all", \
        "",                                                                                                            \
        "linear 0..1; if denoise.enabled=true; motion; cost +")

#define GLINT_FADE_SETTINGS(SETTING)                                                                                   \
    SETTING(FadeBorder, border, FadeBorder::Linear, "", "",                                                            \
        "Fade of hits near the screen border: none, smooth (wide, as Babylon.js), or linear (over fade.borderWidth)",  \
        "babylon:attenuateScreenBorders=none|smooth hdrp:screenWeightDistance=linear",                                 \
        "choice; if screen.enabled=true; motion")                                                                      \
    SETTING(float, borderWidth, 0.05f, "[0, 0.5]", "UV",                                                               \
        "Width of the linear border fade: weight is 0 at the border and 1 from this distance inward",                  \
        "hdrp:screenWeightDistance",                                                                                   \
        "linear 0..0.3; if fade.border=linear; motion")                                                                \
    SETTING(bool, distance, false, "", "",                                                                             \
        "Fade hits by 1 - hit distance / screen.maxDistance",                                                          \
        "babylon:attenuateIntersectionDistance",                                                                       \
        "switch; if screen.enabled=true")                                                                              \
    SETTING(bool, iterations, false, "", "",                                                                           \
        "Fade hits by 1 - iterations / screen.maxSteps",                                                               \
        "babylon:attenuateIntersectionIterations",                                                                     \
        "switch; if screen.enabled=true")                                                                              \
    SETTING(bool, facingCamera, false, "", "",                                                                         \
        "Fade rays that point back toward the camera, since the screen rarely shows the surfaces that they hit",       \
        "babylon:attenuateFacingCamera",                                                                               \
        "switch; if screen.enabled=true; cost -")                                                                      \
    SETTING(bool, backface, false, "", "",                                                                             \
        "Fade hits on surfaces that face away from the ray's origin",                                                  \
        "babylon:attenuateBackfaceReflection",                                                                         \
        "switch; if screen.enabled=true")                                                                              \
    SETTING(bool, uncertain, true, "", "",                                                                             \
        "Answers that may be wrong (a side, a silhouette, a guess) weigh by how often such answers are right, and by "  \
        "how much brighter they are than what would stand there instead; off: as much as certain ones",                \
        "",                                                                                                            \
        "switch; if screen.march=hiz|linear|adaptive; cost +")

#define GLINT_RAYS_SETTINGS(SETTING)                                                                                   \
    SETTING(bool, enabled, false, "", "",                                                                              \
        "Trace rays through the host's triangles for the weight remaining after earlier sources; needs a RayScene",    \
        "",                                                                                                            \
        "switch; cost +")                                                                                              \
    SETTING(RayBackend, backend, RayBackend::Auto, "", "",                                                             \
        "Ray back end: query (the device's ray queries), bvh (any device), or auto (query on GPUs with it, else bvh)",  \
        "")                                                                                                            \
    SETTING(int, samples, 1, "[1, 4096]", "",                                                                          \
        "Rays per pixel through the host's triangles; their results are averaged",                                     \
        "ray-query:MAX_REFLECTIONS_SAMPLES ray-query:samples",                                                         \
        "log 1..8; if rays.enabled=true; cost +")                                                                      \
    SETTING(float, interpolate, 0, "[0, 1]", "",                                                                       \
        "Without the denoiser: one ray for 2 x 2 pixels; the others take the mean where rays around them differ by at most this fraction, else send their own; 0: each pixel sends one", \
        "",                                                                                                            \
        "linear 0..1; if rays.enabled=true; if denoise.enabled=false; cost -")                                         \
    SETTING(int, bounces, 1, "[1, 64]", "",                                                                            \
        "Maximum surfaces that a ray path hits; what the last one reflects is estimated (rays.environmentOcclusion)",  \
        "ray-query:MAX_BOUNCES ray-query:bounces",                                                                     \
        "linear 1..4; if rays.enabled=true; cost +")                                                                   \
    SETTING(bool, environmentOcclusion, true, "", "",                                                                  \
        "One more ray tells what a path's last surface reflects: the environment, or what the previous frame shows there, or else that surface's own light; off: the environment, hidden or not", \
        "",                                                                                                            \
        "switch; if rays.enabled=true; cost +")                                                                        \
    SETTING(RayLobe, lobe, RayLobe::Ggx, "", "",                                                                       \
        "Ray directions: ggx (spread by roughness), mirror, mirrorIfOne (mirror if rays.samples is 1, else ggx), or cone (mirror directions, and what they find is filtered as wide as the lobe)", \
        "",                                                                                                            \
        "choice; if rays.enabled=true")                                                                                \
    SETTING(int, shadowRays, 1, "[1, 256]", "",                                                                        \
        "Maximum shadow rays from a hit whose light the denoiser averages; its lights share them. Mirrors, and rays without the denoiser, send one to each light", \
        "",                                                                                                            \
        "log 1..8; if rays.enabled=true; if denoise.enabled=true; cost +")                                             \
    SETTING(bool, sampleLights, false, "", "",                                                                         \
        "Rough surfaces also send rays to emissive triangles and bright parts of the environment: less noise; with denoise.enabled to the environment alone, once a pixel", \
        "",                                                                                                            \
        "switch; if rays.enabled=true; cost +")                                                                        \
    SETTING(float, regularization, 0.2f, "[0, 4]", "",                                                                 \
        "After a rough bounce, minimum hit roughness is this times path spread; falls with samples; 0: fireflies",     \
        "",                                                                                                            \
        "linear 0..1; if rays.enabled=true")                                                                           \
    SETTING(float, tMin, 0, "[0, 1e3]", "m",                                                                           \
        "Minimum distance of ray hits; 0: the smallest offset that precision allows, which scales with the scene",     \
        "ray-query:ray_t_min")                                                                                         \
    SETTING(float, tMax, 1e24f, "(0, 1e30]", "m",                                                                      \
        "Maximum length of a ray through the host's triangles",                                                        \
        "ray-query:ray_t_max")                                                                                         \
    SETTING(float, maxRoughness, 1, "[0, 1]", "perceptual roughness",                                                  \
        "Surfaces rougher than this trace no rays and use later sources; a path also ends at a rougher hit",           \
        "",                                                                                                            \
        "linear 0..1; if rays.enabled=true; cost +")                                                                   \
    SETTING(bool, alphaTest, true, "", "",                                                                             \
        "Rays pass through holes of alpha-tested surfaces; off: alpha-tested surfaces are solid",                      \
        "")                                                                                                            \
    SETTING(int, transparents, 8, "[0, 16]", "",                                                                       \
        "Maximum transparent surfaces that a path passes through; 0: rays ignore transparent surfaces",                \
        "",                                                                                                            \
        "linear 0..8; if rays.enabled=true; cost +")                                                                   \
    SETTING(int, cullMask, 255, "[0, 255]", "",                                                                        \
        "Rays intersect only instances whose mask shares a bit with this mask",                                        \
        "ray-query:cull_mask")                                                                                         \
    SETTING(bool, reuseLight, true, "", "",                                                                            \
        "After the screen source: use the frame's light at ray hits that the frame shows; off: shade all hits",        \
        "",                                                                                                            \
        "switch; if rays.enabled=true; if screen.enabled=true; cost -")                                                \
    SETTING(float, reuseRoughness, 0.5f, "[0, 1]", "perceptual roughness",                                             \
        "Rays shade hits on smoother surfaces, also screen hits, since the frame's light there is view-dependent",     \
        "",                                                                                                            \
        "linear 0..1; if rays.reuseLight=true; cost +")                                                                \
    SETTING(bool, accumulate, false, "", "",                                                                           \
        "Average ray results since the view or a setting changed, or Reflections::restartAccumulation was called; switches denoise off", \
        "")

#define GLINT_PLANAR_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Use the images that the host draws for planar mirrors; without planar mirrors this costs nothing",            \
        "")                                                                                                            \
    SETTING(int, steps, 32, "[1, 256]", "",                                                                            \
        "Maximum samples along a ray in a planar mirror's image where a normal differs from the mirror's plane",       \
        "",                                                                                                            \
        "log 1..128; if planar.enabled=true; cost +")                                                                  \
    SETTING(float, roughnessFadeStart, 0.4f, "[0, 1]", "perceptual roughness",                                         \
        "Planar mirrors have full weight up to this roughness and fade out above it",                                  \
        "",                                                                                                            \
        "linear 0..1; if planar.enabled=true")                                                                         \
    SETTING(float, maxRoughness, 0.6f, "[0, 1]", "perceptual roughness",                                               \
        "No planar mirrors from this roughness on; at or below roughnessFadeStart: hard cutoff just above it",         \
        "",                                                                                                            \
        "linear 0..1; if planar.enabled=true; cost +")

#define GLINT_PROBES_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Use the host's probes for the weight remaining after earlier sources; without probes this costs nothing",     \
        "")                                                                                                            \
    SETTING(bool, parallax, true, "", "",                                                                              \
        "Correct probe reflections for parallax by probe distances or proxies; off: probes are infinitely far away",   \
        "",                                                                                                            \
        "switch; if probes.enabled=true; cost +")                                                                      \
    SETTING(int, steps, 16, "[0, 64]", "",                                                                             \
        "Maximum samples along a ray in a probe that stores distances; 0: use proxy volumes only",                     \
        "",                                                                                                            \
        "linear 0..32; if probes.parallax=true; cost +")                                                               \
    SETTING(bool, distanceRoughness, true, "", "",                                                                     \
        "Sharpen probe reflections of surfaces near the reflecting point; off: same roughness at every distance",      \
        "",                                                                                                            \
        "switch; if probes.enabled=true")

#define GLINT_SKY_SETTINGS(SETTING)                                                                                    \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Use the environment for the weight remaining after earlier sources; without an environment: no effect",       \
        "")

#define GLINT_REFRACTION_SETTINGS(SETTING)                                                                             \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Draw the host's transparent layers with refraction and reflection; off: the host draws transparent surfaces", \
        "")                                                                                                            \
    SETTING(RefractionModel, model, RefractionModel::Material, "", "",                                                 \
        "Refraction shape of bodies: material (the host's), none (straight), sphere, plane, or thin (5 mm plate)",     \
        "hdrp:refractionModel")                                                                                        \
    SETTING(RefractionProjection, projection, RefractionProjection::Hiz, "", "",                                       \
        "Origin of refracted light: hiz (ray march), or proxy (intersect the proxy of the probe around the object)",   \
        "hdrp:ssRayModel")                                                                                             \
    SETTING(bool, screen, true, "", "",                                                                                \
        "Transparent layers sample the screen first; off: probes and environment only",                                \
        "")                                                                                                            \
    SETTING(bool, reflections, true, "", "",                                                                           \
        "Transparent layers reflect screen, probes and environment; off: they keep the host's fallback specular",      \
        "")                                                                                                            \
    SETTING(float, borderWidth, 0.05f, "[0, 0.5]", "UV",                                                               \
        "Refracted light from the screen fades to probes and environment within this distance of the screen border",   \
        "hdrp:refraction:screenWeightDistance")                                                                        \
    SETTING(float, dispersion, -1, "[-1, 20]", "20 / Abbe number",                                                     \
        "Dispersion of transparent bodies: variation of the index of refraction by colour; below 0: the material's",   \
        "")                                                                                                            \
    SETTING(int, innerReflections, 0, "[0, 8]", "",                                                                    \
        "Reflections inside a transparent body that are followed; 0: all of the light leaves at its first exit",       \
        "")                                                                                                            \
    SETTING(int, hizMinLevel, 0, "[0, 14]", "",                                                                        \
        "Finest depth pyramid level that a refracted or reflected ray of a transparent layer visits",                  \
        "hdrp:refraction:rayMinLevel",                                                                                 \
        "linear 0..3; if refraction.projection=hiz; cost -")                                                           \
    SETTING(int, hizMaxLevel, 10, "[0, 14]", "",                                                                       \
        "Coarsest depth pyramid level that a refracted or reflected ray of a transparent layer visits",                \
        "hdrp:refraction:rayMaxLevel")                                                                                 \
    SETTING(int, hizMaxIterations, 64, "[1, 1024]", "",                                                                \
        "Maximum cells that a ray of a transparent layer visits; a ray that reaches this limit is a miss",             \
        "hdrp:refraction:rayMaxIterations",                                                                            \
        "log 8..256; if refraction.projection=hiz; cost +")                                                            \
    SETTING(float, hizDepthBias, 0.001f, "[0, 1]", "of viewZ",                                                         \
        "Slab behind each depth sample in which a ray of a transparent layer also hits",                               \
        "hdrp:refraction:rayDepthSuccessBias")                                                                         \
    SETTING(float, ior, 0, "[0, 5]", "",                                                                               \
        "Index of refraction of every transparent body; 0: the material's",                                            \
        "hdrp:indexOfRefraction")                                                                                      \
    SETTING(float, thickness, -1, "[-1, 1e3]", "m",                                                                    \
        "Thickness of every transparent body; below 0: the material's",                                                \
        "hdrp:refractionThickness")                                                                                    \
    SETTING(float, thicknessMultiplier, 1, "[0, 100]", "",                                                             \
        "Multiplies the thickness of every transparent body",                                                          \
        "hdrp:thicknessMultiplier hdrp:refractionThicknessMultiplier")                                                 \
    SETTING(float, transmittanceRed, -1, "[-1, 1]", "",                                                                \
        "Red of the transmittance colour at the absorption distance; below 0: the material's",                         \
        "hdrp:transmittanceColor=r")                                                                                   \
    SETTING(float, transmittanceGreen, -1, "[-1, 1]", "",                                                              \
        "Green of the transmittance colour at the absorption distance; below 0: the material's",                       \
        "hdrp:transmittanceColor=g")                                                                                   \
    SETTING(float, transmittanceBlue, -1, "[-1, 1]", "",                                                               \
        "Blue of the transmittance colour at the absorption distance; below 0: the material's",                        \
        "hdrp:transmittanceColor=b")                                                                                   \
    SETTING(float, absorptionDistance, -1, "[-1, 1e6]", "m",                                                           \
        "Absorption distance after which white light has the transmittance colour; 0: clear; below 0: the material's", \
        "hdrp:absorptionDistance=0:1e-6")

#define GLINT_ORDER_SETTINGS(SETTING)                                                                                  \
    SETTING(int, screen, 2, "[0, 9]", "",                                                                              \
        "Order of the screen source, smaller first; sources of equal order: screen, rays, planar, probes, sky",        \
        "")                                                                                                            \
    SETTING(int, rays, 3, "[0, 9]", "",                                                                                \
        "Order of the ray source, smaller first; rays are traced only where earlier sources leave weight",             \
        "")                                                                                                            \
    SETTING(int, planar, 1, "[0, 9]", "",                                                                              \
        "Order of planar mirrors, smaller first; they also show hidden, off-screen and rough reflections",             \
        "")                                                                                                            \
    SETTING(int, probes, 4, "[0, 9]", "",                                                                              \
        "Order of probes, smaller first; probes fill the weight that earlier sources leave",                           \
        "")                                                                                                            \
    SETTING(int, sky, 5, "[0, 9]", "",                                                                                 \
        "Order of the environment, smaller first; it takes all remaining weight, so later sources get none",           \
        "")

#define GLINT_COMPOSITE_SETTINGS(SETTING)                                                                              \
    SETTING(CompositeModel, model, CompositeModel::Physical, "", "",                                                   \
        "Composite: physical (replaces fallback specular, conserves energy), or lerp (by reflectance, as Babylon.js)", \
        "")

#define GLINT_GBUFFER_SETTINGS(SETTING)                                                                                \
    SETTING(GBufferMode, mode, GBufferMode::Prepass, "", "",                                                           \
        "How the host draws the G-buffer: prepass (the shading pass also writes it), or geometry (a separate pass)",   \
        "babylon:forceGeometryBuffer=prepass|geometry")                                                                \
    SETTING(DepthFormat, depthFormat, DepthFormat::Float, "", "",                                                      \
        "Depth format for tracing: float, or half (linear viewZ in 16 bits, with more self-intersections)",            \
        "",                                                                                                            \
        "choice; if screen.enabled=true")

#define GLINT_INPUT_SETTINGS(SETTING)                                                                                  \
    SETTING(bool, colorIsGamma, false, "", "",                                                                         \
        "The host's litRadiance is sRGB-encoded and is decoded when read",                                             \
        "babylon:inputTextureColorIsInGammaSpace")

#define GLINT_OUTPUT_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, colorIsGamma, false, "", "",                                                                         \
        "Encode the output image as sRGB",                                                                             \
        "babylon:generateOutputInGammaSpace")

#define GLINT_DEBUG_SETTINGS(SETTING)                                                                                  \
    SETTING(bool, outcome, false, "", "",                                                                              \
        "Show ray outcomes: blue: max distance or clipped at the frustum, red: out of steps, yellow: off screen, "     \
        "green: hit (brighter: more steps)",                                                                           \
        "babylon:debug")                                                                                               \
    SETTING(bool, certainty, false, "", "",                                                                            \
        "Store of each screen-space answer, in place of its radiance, its kind, the share of such answers that are "    \
        "right, and the weight that it states by that (glint compare measures with it)",                               \
        "")

// clang-format on
