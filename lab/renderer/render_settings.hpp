// Settings of our own renderer, in addition to the library's settings (glint/settings_list.hpp explains the rows).
#pragma once

#include "glint/setting_info.hpp"

#include <span>

// clang-format off

#define GLINT_ENVIRONMENT_SETTINGS(SETTING)                                                                            \
    SETTING(float, strength, 1, "[0, 1e4]", "",                                                                        \
        "Multiplies the environment's radiance in background, lighting and reflections",                               \
        "")                                                                                                            \
    SETTING(float, rotation, 0, "[-360, 360]", "degrees",                                                              \
        "Rotates the environment about world +Y",                                                                      \
        "")                                                                                                            \
    SETTING(bool, visible, true, "", "",                                                                               \
        "Draw the environment as background; off: black background, but it still lights and reflects",                 \
        "")                                                                                                            \
    SETTING(bool, isProbe, false, "", "",                                                                              \
        "The environment image is a probe rendered by Babylon.js: its rows run from bottom to top",                    \
        "babylon:environmentTextureIsProbe")

#define GLINT_ANALYTIC_SKY_SETTINGS(SETTING)                                                                           \
    SETTING(float, elevation, 35, "[-10, 90]", "degrees",                                                              \
        "Elevation of the sun above the horizon, with --env sky",                                                      \
        "")                                                                                                            \
    SETTING(float, azimuth, 0, "[-360, 360]", "degrees",                                                               \
        "Azimuth of the sun from +X toward +Z, with --env sky",                                                        \
        "")                                                                                                            \
    SETTING(float, turbidity, 3, "[1.7, 10]", "",                                                                      \
        "Turbidity (haze) of the air, with --env sky: 2 is clear, 10 is murky",                                        \
        "")

#define GLINT_LIGHTS_SETTINGS(SETTING)                                                                                 \
    SETTING(ShadowMode, shadows, ShadowMode::Maps, "", "",                                                             \
        "Shadows of lights: none, maps (one drawn from each light), or rays (exact, traced by rays.backend)",          \
        "")

#define GLINT_SHADOWS_SETTINGS(SETTING)                                                                                \
    SETTING(int, resolution, 2048, "[256, 8192]", "texels",                                                            \
        "Width and height of each shadow map",                                                                         \
        "")

#define GLINT_MIRRORS_SETTINGS(SETTING)                                                                                \
    SETTING(float, resolution, 1, "[0.05, 1]", "",                                                                     \
        "Width and height of planar mirror images relative to the frame",                                              \
        "")                                                                                                            \
    SETTING(int, depth, 2, "[1, 4]", "",                                                                               \
        "Recursion depth of planar mirrors; 1: a mirror seen in a mirror uses its other sources only",                 \
        "")                                                                                                            \
    SETTING(int, most, 8, "[1, 16]", "",                                                                               \
        "Maximum planar mirrors that --planar auto finds; mirrors named by the scene come first",                      \
        "")                                                                                                            \
    SETTING(bool, reflections, true, "", "",                                                                           \
        "Draw reflections in planar mirror images, with the frame's settings but without rays",                        \
        "")

#define GLINT_TRANSPARENT_SETTINGS(SETTING)                                                                            \
    SETTING(int, layers, 4, "[1, 16]", "",                                                                             \
        "Maximum transparent layers per pixel, nearest first, that refraction draws in scenes that transmit light",    \
        "")

#define GLINT_DISPLAY_SETTINGS(SETTING)                                                                                \
    SETTING(Tonemap, tonemap, Tonemap::Neutral, "", "",                                                                \
        "Tone map from scene-referred light to display: none (clamp), neutral (Khronos PBR Neutral), or agx",          \
        "")                                                                                                            \
    SETTING(float, exposure, 0, "[-20, 20]", "EV",                                                                     \
        "Multiplies the image by 2^exposure before tone mapping",                                                      \
        "")                                                                                                            \
    SETTING(Antialias, antialias, Antialias::Auto, "", "",                                                             \
        "Antialiasing of edges: none, fxaa (on the finished image), msaa4 (four samples per pixel), accumulate (the "  \
        "mean of a still view's frames, shifted within the pixel), or auto (accumulate in the viewer and for a PNG "   \
        "of the composite alone, else none)",                                                                          \
        "babylon:samples=1:none|4:msaa4")

#define GLINT_MEASURE_SETTINGS(SETTING)                                                                                \
    SETTING(bool, exact, false, "", "",                                                                                \
        "Count wrong mirror pixels against the exact image in --stats; for scenes of emission and perfect mirrors",    \
        "")                                                                                                            \
    SETTING(bool, hits, false, "", "",                                                                                 \
        "Compare every ray with the exact ray; write precision, recall and position error to --stats",                 \
        "")

// clang-format on

namespace glint::render {

GLINT_SETTING_ENUM(ShadowMode, None, Maps, Rays)
GLINT_SETTING_ENUM(Tonemap, None, Neutral, Agx)
GLINT_SETTING_ENUM(Antialias, Auto, None, Fxaa, Msaa4, Accumulate)

struct EnvironmentSettings {
    GLINT_ENVIRONMENT_SETTINGS(GLINT_SETTING_MEMBER)
};
struct AnalyticSkySettings {
    GLINT_ANALYTIC_SKY_SETTINGS(GLINT_SETTING_MEMBER)
};
struct LightsSettings {
    GLINT_LIGHTS_SETTINGS(GLINT_SETTING_MEMBER)
};
struct ShadowsSettings {
    GLINT_SHADOWS_SETTINGS(GLINT_SETTING_MEMBER)
};
struct MirrorsSettings {
    GLINT_MIRRORS_SETTINGS(GLINT_SETTING_MEMBER)
};
struct TransparentSettings {
    GLINT_TRANSPARENT_SETTINGS(GLINT_SETTING_MEMBER)
};
struct DisplaySettings {
    GLINT_DISPLAY_SETTINGS(GLINT_SETTING_MEMBER)
};
struct MeasureSettings {
    GLINT_MEASURE_SETTINGS(GLINT_SETTING_MEMBER)
};

struct RenderSettings {
    EnvironmentSettings environment;
    AnalyticSkySettings analyticSky;
    LightsSettings lights;
    ShadowsSettings shadows;
    MirrorsSettings mirrors;
    TransparentSettings transparent;
    DisplaySettings display;
    MeasureSettings measure;
};

/// Every setting of `RenderSettings`, in the list's order.
std::span<const SettingInfo> renderSettingsTable();

} // namespace glint::render
