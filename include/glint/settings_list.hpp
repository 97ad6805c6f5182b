// Every setting of the library, each stated once: SETTING(type, name, default, range, unit, meaning, aliases).
// Aliases are names that other systems use, `system:name`, parted by spaces; `=1-x`, `=1/(n+1)`, `=a|b` (a switch: a
// when false, b when true), `=0:a|2:b` (their numbers for our values, whose names work too), `=a` (implies a) and
// `=a>b` (implies b where a was in force) say where the meaning differs. One alias may stand at several settings.
#pragma once

// clang-format off

#define GLINT_SCREEN_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Trace reflections in screen space; off: no such pass runs",                                                   \
        "babylon:isEnabled compute-ssr:enabled")                                                                       \
    SETTING(March, march, March::Hiz, "", "",                                                                          \
        "How a ray looks for its hit in the depth image; proxy: once, where the pixel's probe volume says",            \
        "hdrp:projectionModel")                                                                                        \
    SETTING(float, maxDistance, 1000, "(0, 1e6]", "m",                                                                 \
        "Longest ray, in 3D",                                                                                          \
        "babylon:maxDistance compute-ssr:distance")                                                                    \
    SETTING(int, maxSteps, 1000, "[1, 4096]", "",                                                                      \
        "Iterations of march linear; a ray that uses them up is a miss",                                               \
        "babylon:maxSteps")                                                                                            \
    SETTING(int, step, 1, "[1, 64]", "px",                                                                             \
        "Pixels an iteration of march linear; larger: faster, thin objects are missed",                                \
        "babylon:step")                                                                                                \
    SETTING(bool, smooth, true, "", "",                                                                                \
        "Refine each hit to one pixel; acts only with screen.step > 1",                                                \
        "babylon:enableSmoothReflections")                                                                             \
    SETTING(ThicknessMode, thicknessMode, ThicknessMode::Backface, "", "",                                             \
        "How deep a surface is behind its depth sample: constant, relative to distance, or from drawn back faces",     \
        "hdrp:depthBufferThickness=relative babylon:thickness=relative>constant "                                      \
        "compute-ssr:thickness=relative>constant babylon:enableAutomaticThicknessComputation=constant|backface")       \
    SETTING(float, thickness, 0, "[0, 1e3]", "m",                                                                      \
        "Slab behind each depth sample in which a ray ends too; with backface on top of what the back faces say",      \
        "babylon:thickness compute-ssr:thickness")                                                                     \
    SETTING(float, thicknessRelative, 0.01f, "[0, 1]", "of viewZ",                                                     \
        "The same slab as a fraction of the sample's distance; acts with thicknessMode relative",                      \
        "hdrp:depthBufferThickness")                                                                                   \
    SETTING(int, selfCollisionSkip, 0, "[0, 16]", "iterations",                                                        \
        "First iterations in which nothing counts as a hit, so that a surface does not meet itself",                   \
        "babylon:selfCollisionNumSkip")                                                                                \
    SETTING(bool, clipToFrustum, true, "", "",                                                                         \
        "Clip the ray's end to what the screen shows",                                                                 \
        "babylon:clipToFrustum")                                                                                       \
    SETTING(int, backfaceDownsample, 0, "[0, 8]", "",                                                                  \
        "The host draws back-face depth at size / (n + 1); coarser: cheaper, ragged silhouettes",                      \
        "babylon:backfaceDepthTextureDownsample")                                                                      \
    SETTING(bool, backfaceTransparents, true, "", "",                                                                  \
        "Transparent surfaces count as solid in back-face depth",                                                      \
        "babylon:backfaceForceDepthWriteTransparentMeshes")                                                            \
    SETTING(float, resolutionScale, 1, "[0.1, 1]", "",                                                                 \
        "Size of the traced image against the picture; the G-buffer stays whole",                                      \
        "babylon:ssrDownsample=1/(n+1) compute-ssr:resolutionScale")                                                   \
    SETTING(TargetFormat, targetFormat, TargetFormat::Auto, "", "",                                                    \
        "Format of the traced radiance: rgba16f, rgba8 (clamped to [0, 1]), or auto, which is rgba16f",                \
        "babylon:textureType=0:rgba8|2:rgba16f")                                                                       \
    SETTING(ColorSource, colorSource, ColorSource::Current, "", "",                                                    \
        "Where a hit takes its colour: this frame, or the previous one with its own reflections, reprojected",         \
        "hdrp:colorSource")                                                                                            \
    SETTING(bool, highlights, false, "", "",                                                                           \
        "Hits show lights' highlights where the eye sees them; off: smooth surfaces lose them, if the host tells",     \
        "")

#define GLINT_HIZ_SETTINGS(SETTING)                                                                                    \
    SETTING(int, minLevel, 0, "[0, 14]", "",                                                                           \
        "Finest level of the depth pyramid that a ray visits; above 0: faster, blocky",                                \
        "hdrp:rayMinLevel")                                                                                            \
    SETTING(int, maxLevel, 10, "[0, 14]", "",                                                                          \
        "Coarsest level that a ray visits",                                                                            \
        "hdrp:rayMaxLevel")                                                                                            \
    SETTING(int, maxIterations, 128, "[1, 1024]", "",                                                                  \
        "Cells that a ray may visit; a ray that uses them up is a miss",                                               \
        "hdrp:rayMaxIterations")                                                                                       \
    SETTING(float, depthBias, 0.001f, "[0, 1]", "of viewZ",                                                            \
        "How far behind a surface, on top of its thickness, a ray still meets it",                                     \
        "hdrp:rayDepthSuccessBias")

#define GLINT_ADAPTIVE_SETTINGS(SETTING)                                                                               \
    SETTING(int, steps, 64, "[1, 128]", "",                                                                            \
        "Fewest steps of a ray; long ones take up to twice as many",                                                   \
        "compute-ssr:steps")                                                                                           \
    SETTING(float, pixelSpacing, 8, "[1, 64]", "px",                                                                   \
        "Steps are added so that they lie no farther apart on screen",                                                 \
        "")                                                                                                            \
    SETTING(int, refinements, 5, "[0, 16]", "",                                                                        \
        "Halvings of the step that met something",                                                                     \
        "")

#define GLINT_REFLECT_SETTINGS(SETTING)                                                                                \
    SETTING(float, threshold, 0, "[0, 1]", "",                                                                         \
        "No ray where the quantity of reflect.thresholdOn is at most this + 1/510",                                    \
        "babylon:reflectivityThreshold compute-ssr:reflectivityThreshold")                                             \
    SETTING(ThresholdOn, thresholdOn, ThresholdOn::F0, "", "",                                                         \
        "What reflect.threshold is held against: f0, the reflectance at normal incidence, or f0TimesStrength",         \
        "babylon:reflectivityThreshold=f0 compute-ssr:reflectivityThreshold=f0TimesStrength")                          \
    SETTING(float, strength, 1, "[0, 10]", "",                                                                         \
        "Multiplies reflections; 0: none are traced",                                                                  \
        "babylon:strength compute-ssr:intensity")                                                                      \
    SETTING(float, falloffExponent, 1, "(0, 16]", "",                                                                  \
        "Exponent over reflectance times strength; larger: weak reflections fade first",                               \
        "babylon:reflectionSpecularFalloffExponent")                                                                   \
    SETTING(bool, fresnel, true, "", "",                                                                               \
        "Reflectance grows toward grazing angles (Schlick); off: F0 at every angle",                                   \
        "babylon:useFresnel")                                                                                          \
    SETTING(float, roughnessFadeStart, 0.2f, "[0, 1]", "perceptual roughness",                                         \
        "Up to here screen-space reflections have full weight",                                                        \
        "hdrp:smoothnessFadeStart=1-x")                                                                                \
    SETTING(float, maxRoughness, 0.4f, "[0, 1]", "perceptual roughness",                                               \
        "From here on no screen-space ray is traced; at or below roughnessFadeStart: a hard edge just above it",       \
        "hdrp:minSmoothness=1-x")

#define GLINT_ROUGH_SETTINGS(SETTING)                                                                                  \
    SETTING(float, factor, 0, "[0, 1]", "",                                                                            \
        "Jitters each ray by its surface's roughness times this; 0: mirror directions only",                           \
        "babylon:roughnessFactor")

#define GLINT_BLUR_SETTINGS(SETTING)                                                                                   \
    SETTING(float, strength, 0, "[0, 1]", "",                                                                          \
        "Blurs reflections by roughness and hit distance; 0: no blur",                                                 \
        "babylon:blurDispersionStrength")                                                                              \
    SETTING(int, quality, 2, "[1, 3]", "",                                                                             \
        "Taps of the blur: 1 few, 3 many",                                                                             \
        "babylon:blurQuality")                                                                                         \
    SETTING(int, downsample, 0, "[0, 8]", "",                                                                          \
        "Blurs at size / (n + 1)",                                                                                     \
        "babylon:blurDownsample")

#define GLINT_FADE_SETTINGS(SETTING)                                                                                   \
    SETTING(FadeBorder, border, FadeBorder::Linear, "", "",                                                            \
        "Fade hits near the screen's border: none, smooth (wide, Babylon's), linear (over fade.borderWidth)",          \
        "babylon:attenuateScreenBorders=none|smooth hdrp:screenWeightDistance=linear")                                 \
    SETTING(float, borderWidth, 0.05f, "[0, 0.5]", "UV",                                                               \
        "Width of the linear border fade: 0 at the border, 1 from here inside",                                        \
        "hdrp:screenWeightDistance")                                                                                   \
    SETTING(bool, distance, false, "", "",                                                                             \
        "Fade by 1 - distance / screen.maxDistance",                                                                   \
        "babylon:attenuateIntersectionDistance")                                                                       \
    SETTING(bool, iterations, false, "", "",                                                                           \
        "Fade by 1 - iterations / screen.maxSteps",                                                                    \
        "babylon:attenuateIntersectionIterations")                                                                     \
    SETTING(bool, facingCamera, false, "", "",                                                                         \
        "Fade rays that come back toward the camera, whose hits the screen rarely shows",                              \
        "babylon:attenuateFacingCamera")                                                                               \
    SETTING(bool, backface, false, "", "",                                                                             \
        "Fade hits on surfaces that face away from the ray's origin",                                                  \
        "babylon:attenuateBackfaceReflection")

#define GLINT_RAYS_SETTINGS(SETTING)                                                                                   \
    SETTING(bool, enabled, false, "", "",                                                                              \
        "Trace rays through the host's triangles for what the sources before leave; needs a RayScene",                 \
        "")                                                                                                            \
    SETTING(RayBackend, backend, RayBackend::Auto, "", "",                                                             \
        "What traces them: query (the device's ray queries), bvh (any device), or auto, which is query where it can",  \
        "")                                                                                                            \
    SETTING(int, samples, 1, "[1, 4096]", "",                                                                          \
        "Rays a pixel; what they find is averaged",                                                                    \
        "")                                                                                                            \
    SETTING(int, bounces, 1, "[1, 8]", "",                                                                             \
        "Surfaces that a ray follows; the last one reflects the environment",                                          \
        "")                                                                                                            \
    SETTING(RayLobe, lobe, RayLobe::Ggx, "", "",                                                                       \
        "Directions of rays: ggx, spread as roughness says; mirror; mirrorIfOne, which is mirror with one sample",     \
        "")                                                                                                            \
    SETTING(float, tMin, 0, "[0, 1e3]", "m",                                                                           \
        "Where a ray begins to look; 0: as near as the numbers allow, which scales with the scene",                    \
        "")                                                                                                            \
    SETTING(float, tMax, 1e24f, "(0, 1e30]", "m",                                                                      \
        "Where a ray ends",                                                                                            \
        "")                                                                                                            \
    SETTING(float, maxRoughness, 1, "[0, 1]", "perceptual roughness",                                                  \
        "Rougher surfaces are left to the sources behind, and end a ray's bounces",                                    \
        "")                                                                                                            \
    SETTING(bool, alphaTest, true, "", "",                                                                             \
        "Rays pass through the holes of alpha-tested surfaces; off: such surfaces are solid",                          \
        "")                                                                                                            \
    SETTING(int, cullMask, 255, "[0, 255]", "",                                                                        \
        "Instances are met whose own mask shares a bit with this",                                                     \
        "")                                                                                                            \
    SETTING(bool, reuseLight, true, "", "",                                                                            \
        "After the screen source: where the picture shows what a ray has met, its light is taken from there",          \
        "")                                                                                                            \
    SETTING(float, reuseRoughness, 0.5f, "[0, 1]", "perceptual roughness",                                             \
        "Smoother surfaces shine differently from elsewhere: rays light them anew, also where the screen source hit them", \
        "")                                                                                                            \
    SETTING(bool, accumulate, false, "", "",                                                                           \
        "Average over all frames since the view or a setting changed; Reflections::restartAccumulation starts anew",   \
        "")

#define GLINT_PLANAR_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Pictures that the host drew from behind flat mirrors answer for these; without any they cost nothing",        \
        "")                                                                                                            \
    SETTING(int, steps, 32, "[1, 256]", "",                                                                            \
        "Looks along a ray into a mirror's picture, where the surface is bent away from the mirror's plane",           \
        "")                                                                                                            \
    SETTING(float, roughnessFadeStart, 0.4f, "[0, 1]", "perceptual roughness",                                         \
        "Up to here a mirror's picture has full weight",                                                               \
        "")                                                                                                            \
    SETTING(float, maxRoughness, 0.6f, "[0, 1]", "perceptual roughness",                                               \
        "From here on surfaces are left to the sources behind; at or below roughnessFadeStart: a hard edge above it",  \
        "")

#define GLINT_PROBES_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "The host's probes answer for what screen and rays left; without any they cost nothing",                       \
        "")                                                                                                            \
    SETTING(bool, parallax, true, "", "",                                                                              \
        "Reflections lie where the probes' distances or proxy volumes say; off: infinitely far away",                  \
        "")                                                                                                            \
    SETTING(int, steps, 12, "[0, 64]", "",                                                                             \
        "Most looks along a ray for what it meets in a probe that has distances; 0: proxy volumes alone",              \
        "")                                                                                                            \
    SETTING(bool, distanceRoughness, true, "", "",                                                                     \
        "What is near its reflection is sharper than its roughness says at the probe; off: as rough everywhere",       \
        "")

#define GLINT_SKY_SETTINGS(SETTING)                                                                                    \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "The environment answers for what the sources before it left; without one it adds nothing",                    \
        "")

#define GLINT_REFRACTION_SETTINGS(SETTING)                                                                             \
    SETTING(bool, enabled, true, "", "",                                                                               \
        "Light comes through transparent surfaces that the host hands over as layers, and they reflect; off: it draws them its own way", \
        "")                                                                                                            \
    SETTING(RefractionModel, model, RefractionModel::Material, "", "",                                                 \
        "What bodies are taken for: material, as the host says; none, nothing is bent; sphere, plane, or thin, a plate of 5 mm", \
        "hdrp:refractionModel")                                                                                        \
    SETTING(RefractionProjection, projection, RefractionProjection::Hiz, "", "",                                       \
        "Where light that has left a body comes from: hiz, marched; proxy, met on the volume of the probe that holds the object", \
        "hdrp:ssRayModel")                                                                                             \
    SETTING(bool, screen, true, "", "",                                                                                \
        "Layers ask the picture first; off: probes and the environment alone",                                         \
        "")                                                                                                            \
    SETTING(bool, reflections, true, "", "",                                                                           \
        "Layers reflect by screen, probes and sky; off: they keep the host's fallback specular",                       \
        "")                                                                                                            \
    SETTING(float, borderWidth, 0.05f, "[0, 0.5]", "UV",                                                               \
        "Refracted light fades to probes and sky this far from the border of the picture",                             \
        "hdrp:refraction:screenWeightDistance")                                                                        \
    SETTING(int, hizMinLevel, 0, "[0, 14]", "",                                                                        \
        "Finest level of the depth pyramid that a layer's rays visit",                                                 \
        "hdrp:refraction:rayMinLevel")                                                                                 \
    SETTING(int, hizMaxLevel, 10, "[0, 14]", "",                                                                       \
        "Coarsest level that they visit",                                                                              \
        "hdrp:refraction:rayMaxLevel")                                                                                 \
    SETTING(int, hizMaxIterations, 64, "[1, 1024]", "",                                                                \
        "Cells that such a ray looks at; one that uses them up is a miss",                                             \
        "hdrp:refraction:rayMaxIterations")                                                                            \
    SETTING(float, hizDepthBias, 0.001f, "[0, 1]", "of viewZ",                                                         \
        "Slab behind each depth sample in which it ends too",                                                          \
        "hdrp:refraction:rayDepthSuccessBias")                                                                         \
    SETTING(float, ior, 0, "[0, 5]", "",                                                                               \
        "Index of refraction of every body; 0: its material's",                                                        \
        "")                                                                                                            \
    SETTING(float, thickness, -1, "[-1, 1e3]", "m",                                                                    \
        "Thickness of every body; below 0: its material's",                                                            \
        "")                                                                                                            \
    SETTING(float, thicknessMultiplier, 1, "[0, 100]", "",                                                             \
        "Factor on the thickness of every body",                                                                       \
        "hdrp:thicknessMultiplier")                                                                                    \
    SETTING(float, transmittanceRed, -1, "[-1, 1]", "",                                                                \
        "Colour that white light has taken after the absorption distance; below 0, all three: the materials' own",     \
        "")                                                                                                            \
    SETTING(float, transmittanceGreen, -1, "[-1, 1]", "",                                                              \
        "Its green",                                                                                                   \
        "")                                                                                                            \
    SETTING(float, transmittanceBlue, -1, "[-1, 1]", "",                                                               \
        "Its blue",                                                                                                    \
        "")                                                                                                            \
    SETTING(float, absorptionDistance, -1, "[-1, 1e6]", "m",                                                           \
        "Distance after which it has; 0: bodies are clear; below 0: the materials' own",                               \
        "hdrp:absorptionDistance")

#define GLINT_ORDER_SETTINGS(SETTING)                                                                                  \
    SETTING(int, screen, 2, "[0, 9]", "",                                                                              \
        "Place of the screen source in the walk: smaller is asked first, equal ones in the order of this list",        \
        "")                                                                                                            \
    SETTING(int, rays, 3, "[0, 9]", "",                                                                                \
        "Place of rays, which are traced only where the sources before leave something",                               \
        "")                                                                                                            \
    SETTING(int, planar, 1, "[0, 9]", "",                                                                              \
        "Place of planar mirrors, which also show what is hidden, off screen and rough",                               \
        "")                                                                                                            \
    SETTING(int, probes, 4, "[0, 9]", "",                                                                              \
        "Place of probes",                                                                                             \
        "")                                                                                                            \
    SETTING(int, sky, 5, "[0, 9]", "",                                                                                 \
        "Place of the environment, which leaves nothing to those behind it",                                           \
        "")

#define GLINT_COMPOSITE_SETTINGS(SETTING)                                                                              \
    SETTING(CompositeModel, model, CompositeModel::Physical, "", "",                                                   \
        "physical: replaces the host's fallback specular, energy kept; lerp: blends colours by reflectance (Babylon)", \
        "")

#define GLINT_GBUFFER_SETTINGS(SETTING)                                                                                \
    SETTING(GBufferMode, mode, GBufferMode::Prepass, "", "",                                                           \
        "How the host draws it: prepass, the shading pass writes it too; geometry, a pass of its own",                 \
        "babylon:forceGeometryBuffer=prepass|geometry")                                                                \
    SETTING(DepthFormat, depthFormat, DepthFormat::Float, "", "",                                                      \
        "Depth as rays see it: float, or half: linear viewZ in 16 bits, which shows more self-hits",                   \
        "")

#define GLINT_INPUT_SETTINGS(SETTING)                                                                                  \
    SETTING(bool, colorIsGamma, false, "", "",                                                                         \
        "litRadiance is sRGB-encoded: decoded when read",                                                              \
        "babylon:inputTextureColorIsInGammaSpace")

#define GLINT_OUTPUT_SETTINGS(SETTING)                                                                                 \
    SETTING(bool, colorIsGamma, false, "", "",                                                                         \
        "Encode the picture as sRGB",                                                                                  \
        "babylon:generateOutputInGammaSpace")

#define GLINT_DEBUG_SETTINGS(SETTING)                                                                                  \
    SETTING(bool, outcome, false, "", "",                                                                              \
        "Show how rays ended: blue max distance, red out of steps, yellow off screen, green hit (bright: many steps)", \
        "babylon:debug")

// clang-format on
