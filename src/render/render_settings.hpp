// What a user can tune in our own renderer, beside the library's settings (glint/settings_list.hpp explains the rows).
#pragma once

#include "glint/setting_info.hpp"

#include <span>

// clang-format off

#define GLINT_ENVIRONMENT_SETTINGS(SETTING)                                                                            \
    SETTING(float, strength, 1, "[0, 1e4]", "",                                                                        \
        "Multiplies the environment's radiance, as background, as light and in reflections",                           \
        "")                                                                                                            \
    SETTING(float, rotation, 0, "[-360, 360]", "degrees",                                                              \
        "Turns the environment about +Y",                                                                              \
        "")                                                                                                            \
    SETTING(bool, visible, true, "", "",                                                                               \
        "Draw the environment as the background; off: black, it still lights and reflects",                            \
        "")                                                                                                            \
    SETTING(bool, isProbe, false, "", "",                                                                              \
        "The image is a probe as Babylon.js renders it: its rows run from the bottom up",                              \
        "babylon:environmentTextureIsProbe")

#define GLINT_ANALYTIC_SKY_SETTINGS(SETTING)                                                                           \
    SETTING(float, elevation, 35, "[-10, 90]", "degrees",                                                              \
        "The sun above the horizon, with --env sky",                                                                   \
        "")                                                                                                            \
    SETTING(float, azimuth, 0, "[-360, 360]", "degrees",                                                               \
        "The sun's heading from +X toward +Z, with --env sky",                                                         \
        "")                                                                                                            \
    SETTING(float, turbidity, 3, "[1.7, 10]", "",                                                                      \
        "Haze of the air, with --env sky: 2 is clear, 10 is murky",                                                    \
        "")

#define GLINT_LIGHTS_SETTINGS(SETTING)                                                                                 \
    SETTING(ShadowMode, shadows, ShadowMode::Maps, "", "",                                                             \
        "How lights cast shadows: none, maps drawn from each light, or rays, which are exact (rays.backend traces them)", \
        "")

#define GLINT_SHADOWS_SETTINGS(SETTING)                                                                                \
    SETTING(int, resolution, 2048, "[256, 8192]", "texels",                                                            \
        "Width and height of a shadow map",                                                                            \
        "")

#define GLINT_MIRRORS_SETTINGS(SETTING)                                                                                \
    SETTING(float, resolution, 1, "[0.05, 1]", "",                                                                     \
        "Size of planar mirrors' pictures against the frame's",                                                        \
        "")                                                                                                            \
    SETTING(int, depth, 2, "[1, 4]", "",                                                                               \
        "Planar mirrors that are seen one in another; 1: a mirror in a mirror shows what its other sources say",       \
        "")                                                                                                            \
    SETTING(int, most, 8, "[1, 16]", "",                                                                               \
        "Planar mirrors that --planar auto may find; those that the scene names come first",                           \
        "")                                                                                                            \
    SETTING(bool, reflections, true, "", "",                                                                           \
        "Pictures of planar mirrors have reflections of their own, by the frame's settings but without rays",          \
        "")

#define GLINT_TRANSPARENT_SETTINGS(SETTING)                                                                            \
    SETTING(int, layers, 4, "[1, 16]", "",                                                                             \
        "Transparent surfaces behind each other, the nearest ones, that refraction sees in scenes which transmit light", \
        "")

#define GLINT_DISPLAY_SETTINGS(SETTING)                                                                                \
    SETTING(Tonemap, tonemap, Tonemap::Neutral, "", "",                                                                \
        "From scene-referred light to the screen: none (clamped), neutral (Khronos PBR Neutral) or agx",               \
        "")                                                                                                            \
    SETTING(float, exposure, 0, "[-20, 20]", "EV",                                                                     \
        "Scales the picture by 2^exposure before the tone map",                                                        \
        "")                                                                                                            \
    SETTING(Antialias, antialias, Antialias::None, "", "",                                                             \
        "Antialiasing of edges: none, fxaa (over the finished picture) or msaa4 (four samples a pixel)",               \
        "babylon:samples=1:none|4:msaa4")

#define GLINT_MEASURE_SETTINGS(SETTING)                                                                                \
    SETTING(bool, exact, false, "", "",                                                                                \
        "Count wrong mirror pixels against the exact picture, into --stats; for scenes of emission and perfect mirrors", \
        "")                                                                                                            \
    SETTING(bool, hits, false, "", "",                                                                                 \
        "Compare every ray with the exact one: precision, recall and position error, into --stats",                    \
        "")

// clang-format on

namespace glint::render {

GLINT_SETTING_ENUM(ShadowMode, None, Maps, Rays)
GLINT_SETTING_ENUM(Tonemap, None, Neutral, Agx)
GLINT_SETTING_ENUM(Antialias, None, Fxaa, Msaa4)

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
