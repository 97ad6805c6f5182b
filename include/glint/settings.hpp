// SPDX-License-Identifier: MIT
// Everything that a user can tune in the library: plain structs with defaults, and the same by name, as text, as JSON.
// settings_list.hpp holds each setting's default, range, unit and meaning; docs/settings.md shows them as a table.
#pragma once

#include "glint/api.h"
#include "glint/error.hpp"
#include "glint/ray_backend.hpp"
#include "glint/setting_info.hpp"
#include "glint/settings_list.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glint {

GLINT_SETTING_ENUM(March, Linear, Adaptive, Hiz, Proxy)
GLINT_SETTING_ENUM(ThicknessMode, Constant, Relative, Backface)
GLINT_SETTING_ENUM(TargetFormat, Auto, Rgba8, Rgba16f)
GLINT_SETTING_ENUM(GBufferMode, Prepass, Geometry)
GLINT_SETTING_ENUM(DepthFormat, Float, Half)
GLINT_SETTING_ENUM(ColorSource, Current, Previous)
GLINT_SETTING_ENUM(ThresholdOn, F0, F0TimesStrength)
GLINT_SETTING_ENUM(FadeBorder, None_, Smooth, Linear)
GLINT_SETTING_ENUM(CompositeModel, Physical, Lerp)
GLINT_SETTING_ENUM(RefractionModel, Material, None_, Sphere, Plane, Thin)
GLINT_SETTING_ENUM(RefractionProjection, Hiz, Proxy)
GLINT_SETTING_ENUM(RayRate, Full, Checkerboard, Quarter, Adaptive)
GLINT_SETTING_ENUM(Antilag, Off, Mean, Gradient)
GLINT_SETTING_ENUM(VirtualMotion, Surface, Flat, Curved)
GLINT_SETTING_ENUM(RayLobe, Ggx, Mirror, MirrorIfOne, Cone)

struct ScreenSettings {
    GLINT_SCREEN_SETTINGS(GLINT_SETTING_MEMBER)
};
struct HizSettings {
    GLINT_HIZ_SETTINGS(GLINT_SETTING_MEMBER)
};
struct AdaptiveSettings {
    GLINT_ADAPTIVE_SETTINGS(GLINT_SETTING_MEMBER)
};
struct ReflectSettings {
    GLINT_REFLECT_SETTINGS(GLINT_SETTING_MEMBER)
};
struct RoughSettings {
    GLINT_ROUGH_SETTINGS(GLINT_SETTING_MEMBER)
};
struct BlurSettings {
    GLINT_BLUR_SETTINGS(GLINT_SETTING_MEMBER)
};
struct ReuseSettings {
    GLINT_REUSE_SETTINGS(GLINT_SETTING_MEMBER)
};
struct DenoiseSettings {
    GLINT_DENOISE_SETTINGS(GLINT_SETTING_MEMBER)
};
struct FadeSettings {
    GLINT_FADE_SETTINGS(GLINT_SETTING_MEMBER)
};
struct RaysSettings {
    GLINT_RAYS_SETTINGS(GLINT_SETTING_MEMBER)
};
struct PlanarSettings {
    GLINT_PLANAR_SETTINGS(GLINT_SETTING_MEMBER)
};
struct ProbesSettings {
    GLINT_PROBES_SETTINGS(GLINT_SETTING_MEMBER)
};
struct SkySettings {
    GLINT_SKY_SETTINGS(GLINT_SETTING_MEMBER)
};
struct RefractionSettings {
    GLINT_REFRACTION_SETTINGS(GLINT_SETTING_MEMBER)
};
struct OrderSettings {
    GLINT_ORDER_SETTINGS(GLINT_SETTING_MEMBER)
};
struct CompositeSettings {
    GLINT_COMPOSITE_SETTINGS(GLINT_SETTING_MEMBER)
};
struct GBufferSettings {
    GLINT_GBUFFER_SETTINGS(GLINT_SETTING_MEMBER)
};
struct InputSettings {
    GLINT_INPUT_SETTINGS(GLINT_SETTING_MEMBER)
};
struct OutputSettings {
    GLINT_OUTPUT_SETTINGS(GLINT_SETTING_MEMBER)
};
struct DebugSettings {
    GLINT_DEBUG_SETTINGS(GLINT_SETTING_MEMBER)
};

/// `Settings s; s.screen.maxDistance = 20;` Defaults are the preset `balanced`.
struct Settings {
    ScreenSettings screen;
    HizSettings hiz;
    AdaptiveSettings adaptive;
    ReflectSettings reflect;
    RoughSettings rough;
    BlurSettings blur;
    ReuseSettings reuse;
    DenoiseSettings denoise;
    FadeSettings fade;
    RaysSettings rays;
    PlanarSettings planar;
    ProbesSettings probes;
    SkySettings sky;
    RefractionSettings refraction;
    OrderSettings order;
    CompositeSettings composite;
    GBufferSettings gbuffer;
    InputSettings input;
    OutputSettings output;
    DebugSettings debug;
};

/// Every setting of `Settings`, in the list's order. `SettingInfo::offset` counts from the start of `Settings`.
GLINT_API std::span<const SettingInfo> settingsTable();

/// Sets one setting from text: `set(s, "screen.step", "4")`. Other systems' names work too: `babylon:thickness`, or a
/// bare `thickness` where one system alone has that name or `preset` (the one in force; may be empty) is that system.
/// Values that are names are read in any case, whole numbers also in hexadecimal: `set(s, "rays.cullMask", "0x0F")`.
/// Errors: InvalidArgument names the nearest key, the candidates, the range or the type; the setting keeps its value.
GLINT_API Result<void> set(Settings& settings, std::string_view key, std::string_view value,
                           std::string_view preset = {});

/// Sets what the JSON names, nested `{"screen":{"step":4}}` or flat `{"screen.step":4}`; the rest keeps its value.
/// A colour of another system may be a list: `{"hdrp:transmittanceColor":[0.9,0.5,0.2]}`.
/// `name` says in errors where the text comes from: "my.json:3: ...". On an error nothing is changed.
GLINT_API Result<void> fromJson(Settings& settings, std::string_view text, std::string_view name,
                                std::string_view preset = {});

/// All settings as nested JSON; `fromJson` reads it back to the same bits.
GLINT_API std::string toJson(const Settings& settings);

/// Errors: InvalidArgument for the first setting out of range, as a host may write it into the struct.
GLINT_API Result<void> validate(const Settings& settings);

/// Defaults, then what the preset says. Errors: InvalidArgument lists the presets.
GLINT_API Result<void> applyPreset(Settings& settings, std::string_view name);

/// "babylon", "balanced", ... in alphabetical order: the files of presets/, built into the library.
GLINT_API std::vector<std::string_view> presetNames();

/// The preset's own text, for programs that have settings of their own beside the library's.
GLINT_API Result<std::string_view> presetJson(std::string_view name);

} // namespace glint
