// Names and values as people write them: aliases, the preset in force, misspellings, wrong types; errors of one line.
#include "glint/settings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace glint {
namespace settings_names_test {

std::string errorOf(std::string_view key, std::string_view value, std::string_view preset = {}) {
    Settings settings;
    const auto done = set(settings, key, value, preset);
    return done.ok() ? "" : done.error().message;
}

TEST(SettingsNames, AliasWithOneSystemNeedsNoSystem) {
    Settings settings;
    ASSERT_TRUE(set(settings, "selfCollisionNumSkip", "3").ok());
    EXPECT_EQ(settings.screen.selfCollisionSkip, 3);
}

TEST(SettingsNames, AliasOfSeveralSystemsIsResolvedByThePreset) {
    Settings settings;
    ASSERT_TRUE(set(settings, "reflectivityThreshold", "0.5", "compute-ssr").ok());
    EXPECT_EQ(settings.reflect.threshold, 0.5f);
    EXPECT_EQ(settings.reflect.thresholdOn, ThresholdOn::F0TimesStrength);
    ASSERT_TRUE(set(settings, "reflectivityThreshold", "0.25", "babylon").ok());
    EXPECT_EQ(settings.reflect.threshold, 0.25f);
    EXPECT_EQ(settings.reflect.thresholdOn, ThresholdOn::F0);
}

TEST(SettingsNames, AliasOfSeveralSystemsIsAnErrorOtherwise) {
    const std::string expected =
        "'thickness' is a name in several systems: write 'babylon:thickness' or 'compute-ssr:thickness'";
    EXPECT_EQ(errorOf("thickness", "1"), expected);
    EXPECT_EQ(errorOf("thickness", "1", "balanced"), expected);
    EXPECT_EQ(errorOf("babylon:thickness", "1"), "");
    EXPECT_EQ(errorOf("babylon:thickness", "1", "compute-ssr"), "");
}

TEST(SettingsNames, AThicknessInMetresActsWhateverModeIsTheDefault) {
    for (const char* name : {"babylon:thickness", "compute-ssr:thickness"}) {
        Settings settings;
        ASSERT_TRUE(set(settings, name, "0.2").ok());
        EXPECT_EQ(settings.screen.thickness, 0.2f) << name;
        EXPECT_EQ(settings.screen.thicknessMode, ThicknessMode::Backface) << name << ": an offset on top";
        settings.screen.thicknessMode = ThicknessMode::Relative; // where it would not act
        ASSERT_TRUE(set(settings, name, "0.3").ok());
        EXPECT_EQ(settings.screen.thicknessMode, ThicknessMode::Constant) << name;
    }
}

TEST(SettingsNames, AliasesCarryTheirOwnMeaning) {
    Settings settings;
    ASSERT_TRUE(set(settings, "hdrp:minSmoothness", "0.75").ok());
    EXPECT_EQ(settings.reflect.maxRoughness, 0.25f);
    ASSERT_TRUE(set(settings, "attenuateScreenBorders", "true").ok());
    EXPECT_EQ(settings.fade.border, FadeBorder::Smooth);
    ASSERT_TRUE(set(settings, "attenuateScreenBorders", "false").ok());
    EXPECT_EQ(settings.fade.border, FadeBorder::None_);
    ASSERT_TRUE(set(settings, "screenWeightDistance", "0.2").ok());
    EXPECT_EQ(settings.fade.border, FadeBorder::Linear);
    EXPECT_EQ(settings.fade.borderWidth, 0.2f);
    ASSERT_TRUE(set(settings, "depthBufferThickness", "0.02").ok());
    EXPECT_EQ(settings.screen.thicknessMode, ThicknessMode::Relative);
    EXPECT_EQ(settings.screen.thicknessRelative, 0.02f);
    ASSERT_TRUE(set(settings, "hdrp:projectionModel", "proxy").ok());
    EXPECT_EQ(settings.screen.march, March::Proxy);
}

TEST(SettingsNames, AnAliasTakesTheNumbersOfItsSystem) {
    Settings settings;
    ASSERT_TRUE(set(settings, "babylon:textureType", "0").ok());
    EXPECT_EQ(settings.screen.targetFormat, TargetFormat::Rgba8);
    ASSERT_TRUE(set(settings, "textureType", "2").ok());
    EXPECT_EQ(settings.screen.targetFormat, TargetFormat::Rgba16f);
    ASSERT_TRUE(set(settings, "textureType", "auto").ok());
    EXPECT_EQ(settings.screen.targetFormat, TargetFormat::Auto);
    ASSERT_TRUE(fromJson(settings, R"({"babylon:textureType": 2})", "test").ok());
    EXPECT_EQ(settings.screen.targetFormat, TargetFormat::Rgba16f);
    EXPECT_FALSE(set(settings, "textureType", "1").ok());
    EXPECT_FALSE(set(settings, "screen.targetFormat", "2").ok()) << "the key itself has no numbers";
}

TEST(SettingsNames, RayQueryHasTheNamesOfItsDocument) {
    Settings settings;
    for (const char* prefix : {"", "ray-query:"}) {
        const auto take = [&](const char* name, const char* value) {
            EXPECT_TRUE(set(settings, std::string(prefix) + name, value, "ray-query").ok()) << prefix << name;
        };
        settings = {};
        take("MAX_REFLECTIONS_SAMPLES", "8");
        take("MAX_BOUNCES", "3");
        take("ray_t_min", "0.01");
        take("ray_t_max", "50");
        take("cull_mask", "0x03");
        EXPECT_EQ(settings.rays.samples, 8);
        EXPECT_EQ(settings.rays.bounces, 3);
        EXPECT_EQ(settings.rays.tMin, 0.01f);
        EXPECT_EQ(settings.rays.tMax, 50);
        EXPECT_EQ(settings.rays.cullMask, 3);
        take("samples", "4");
        take("bounces", "2");
        EXPECT_EQ(settings.rays.samples, 4);
        EXPECT_EQ(settings.rays.bounces, 2);
    }
}

TEST(SettingsNames, APictureIsNoSetting) {
    for (const char* name : {"environmentTexture", "babylon:environmentTexture", "environment.texture"})
        EXPECT_EQ(errorOf(name, "a.hdr"),
                  std::string(name) + ": a picture is no setting; --env FILE says which, and sky.enabled whether rays "
                                      "that miss show it");
}

TEST(SettingsNames, AColourIsSetAsAWhole) {
    Settings settings;
    const auto colour = [&] {
        const RefractionSettings& r = settings.refraction;
        return std::array{r.transmittanceRed, r.transmittanceGreen, r.transmittanceBlue};
    };
    ASSERT_TRUE(set(settings, "transmittanceColor", "0.9,0.5,0.25").ok());
    EXPECT_EQ(colour(), (std::array{0.9f, 0.5f, 0.25f}));
    ASSERT_TRUE(set(settings, "hdrp:transmittanceColor", "0.1 0.2 0.3").ok());
    EXPECT_EQ(colour(), (std::array{0.1f, 0.2f, 0.3f}));
    ASSERT_TRUE(set(settings, "transmittanceColor", "0.5").ok());
    EXPECT_EQ(colour(), (std::array{0.5f, 0.5f, 0.5f}));
    ASSERT_TRUE(fromJson(settings, R"({"hdrp:transmittanceColor": "1,0.5,0"})", "test").ok());
    EXPECT_EQ(colour(), (std::array{1.0f, 0.5f, 0.0f}));
    ASSERT_TRUE(fromJson(settings, R"({"hdrp:transmittanceColor": 0.25})", "test").ok());
    EXPECT_EQ(colour(), (std::array{0.25f, 0.25f, 0.25f}));
    ASSERT_TRUE(fromJson(settings, R"({"hdrp:transmittanceColor": [0.5, 1, 0.25]})", "test").ok());
    EXPECT_EQ(colour(), (std::array{0.5f, 1.0f, 0.25f}));
    ASSERT_TRUE(fromJson(settings, R"({"transmittanceColor": [1, 0.25, 1e-1]})", "test").ok());
    EXPECT_EQ(colour(), (std::array{1.0f, 0.25f, 0.1f}));
    for (const char* bad : {"", "red", "1,2", "0.1,0.2,0.3,0.4", "0.1,0.2,x", "true"})
        EXPECT_EQ(errorOf("transmittanceColor", bad),
                  "transmittanceColor: expected a colour as R,G,B or one number, got '" + std::string(bad) + "'");
    EXPECT_NE(errorOf("transmittanceColor", "0.1,0.2,3"), "");
}

TEST(SettingsNames, AbsorptionDistanceZeroIsTheDarkestUnderHdrpsName) {
    Settings settings;
    ASSERT_TRUE(set(settings, "hdrp:absorptionDistance", "0").ok());
    EXPECT_EQ(settings.refraction.absorptionDistance, 1e-6f) << "nothing comes through what is not white";
    ASSERT_TRUE(set(settings, "hdrp:absorptionDistance", "2").ok());
    EXPECT_EQ(settings.refraction.absorptionDistance, 2);
    ASSERT_TRUE(set(settings, "refraction.absorptionDistance", "0").ok());
    EXPECT_EQ(settings.refraction.absorptionDistance, 0) << "clear";
    ASSERT_TRUE(set(settings, "indexOfRefraction", "1.4").ok());
    EXPECT_EQ(settings.refraction.ior, 1.4f);
    ASSERT_TRUE(set(settings, "hdrp:refractionThickness", "0.5").ok());
    EXPECT_EQ(settings.refraction.thickness, 0.5f);
    ASSERT_TRUE(set(settings, "refractionThicknessMultiplier", "2").ok());
    EXPECT_EQ(settings.refraction.thicknessMultiplier, 2);
}

TEST(SettingsNames, AnAliasWithABadValueChangesNothing) {
    Settings settings;
    ASSERT_TRUE(set(settings, "fade.border", "none").ok());
    EXPECT_FALSE(set(settings, "screenWeightDistance", "2").ok());
    EXPECT_EQ(settings.fade.border, FadeBorder::None_);
}

TEST(SettingsNames, MisspeltNamesGetTheNearestRightOne) {
    EXPECT_EQ(errorOf("screen.stpe", "1"), "unknown setting 'screen.stpe'; did you mean 'screen.step'?");
    EXPECT_EQ(errorOf("maxDistanse", "1"), "unknown setting 'maxDistanse'; did you mean 'screen.maxDistance'?");
    EXPECT_EQ(errorOf("SCREEN.MAXSTEPS", "1"), "unknown setting 'SCREEN.MAXSTEPS'; did you mean 'screen.maxSteps'?");
    EXPECT_EQ(errorOf("babilon:thickness", "1"),
              "unknown setting 'babilon:thickness'; did you mean 'babylon:thickness'?");
    EXPECT_EQ(errorOf("zzzzzzzzzzzz", "1"), "unknown setting 'zzzzzzzzzzzz'; `glint settings` lists them all");
    EXPECT_EQ(errorOf("", "1"), "unknown setting ''; `glint settings` lists them all");
}

/// What stands after "did you mean".
std::string suggestionFor(std::string_view name) {
    const std::string error = errorOf(name, "1");
    const size_t at = error.find("did you mean ");
    return at == error.npos ? "" : error.substr(at + 13);
}

TEST(SettingsNames, AKeyWithoutItsGroupGetsIt) {
    EXPECT_EQ(suggestionFor("thicknessMode"), "'screen.thicknessMode'?");
    EXPECT_EQ(suggestionFor("maxdistance"), "'screen.maxDistance'?");
    EXPECT_EQ(suggestionFor("backFaceDownsample"), "'screen.backfaceDownsample'?");
    EXPECT_EQ(suggestionFor("pixelspacing"), "'adaptive.pixelSpacing'?");
    EXPECT_EQ(suggestionFor("transmittanceRed"), "'refraction.transmittanceRed'?");
    EXPECT_EQ(suggestionFor("thickness_mode"), "'screen.thicknessMode'?");
    EXPECT_EQ(suggestionFor("colourSource"), "'screen.colorSource'?");
    EXPECT_EQ(suggestionFor("maxRoughness"), "'reflect.maxRoughness', 'rays.maxRoughness' or 'planar.maxRoughness'?");
    EXPECT_EQ(suggestionFor("thicknes"), "'screen.thickness' or 'refraction.thickness'?");
    EXPECT_EQ(suggestionFor("denoise"), "'denoise.enabled'?");
    EXPECT_EQ(suggestionFor("rays"), "'rays.enabled' or 'order.rays'?");
    EXPECT_EQ(suggestionFor("enable"), "'screen.enabled', 'denoise.enabled', 'rays.enabled', 'planar.enabled', "
                                       "'probes.enabled', 'sky.enabled' or 'refraction.enabled'?");
}

TEST(SettingsNames, AMisspeltGroupKeepsItsSetting) {
    EXPECT_EQ(suggestionFor("denoise.enable"), "'denoise.enabled'?");
    EXPECT_EQ(suggestionFor("rays.enable"), "'rays.enabled'?");
    EXPECT_EQ(suggestionFor("rayss.enabled"), "'rays.enabled'?");
    EXPECT_EQ(suggestionFor("screne.enabled"), "'screen.enabled'?");
    EXPECT_EQ(suggestionFor("ray.samples"), "'rays.samples'?");
    EXPECT_EQ(suggestionFor("adaptive.step"), "'adaptive.steps'?");
    EXPECT_EQ(suggestionFor("screen.maxIterations"), "'hiz.maxIterations'?");
    EXPECT_EQ(suggestionFor("screen.maxRoughness"),
              "'reflect.maxRoughness', 'rays.maxRoughness' or 'planar.maxRoughness'?");
    EXPECT_EQ(suggestionFor("hdrp:maxDistance"), "'screen.maxDistance'?");
}

TEST(SettingsNames, OtherSystemsNamesAreSuggestedWhereNoKeyIsAsNear) {
    EXPECT_EQ(suggestionFor("screenWeightDistanse"), "'hdrp:screenWeightDistance'?");
    EXPECT_EQ(suggestionFor("refraction.screenWeightDistance"), "'hdrp:refraction:screenWeightDistance'?");
    EXPECT_EQ(suggestionFor("max_bounces"), "'ray-query:MAX_BOUNCES'?");
    EXPECT_EQ(suggestionFor("hdrp:transmittanceColour"), "'hdrp:transmittanceColor'?");
    EXPECT_EQ(suggestionFor("unity:minSmoothness"), "'hdrp:minSmoothness'?");
    EXPECT_EQ(suggestionFor("reflectivityTreshold"),
              "'babylon:reflectivityThreshold' or 'compute-ssr:reflectivityThreshold'?");
}

TEST(SettingsNames, WithoutANearNameThoseThatContainItAreSuggested) {
    EXPECT_EQ(suggestionFor("stepsize"), "'screen.step', 'adaptive.steps', 'planar.steps' or 'probes.steps'?");
    EXPECT_EQ(suggestionFor("absorption"), "'refraction.absorptionDistance'?");
    EXPECT_EQ(suggestionFor("a"), "");
    EXPECT_EQ(suggestionFor("."), "");
    EXPECT_EQ(suggestionFor(":"), "");
    EXPECT_EQ(suggestionFor("screen."), "'screen.enabled'?");
}

TEST(SettingsNames, ValuesAreNamedInAnyCase) {
    Settings settings;
    const auto take = [&](const char* name, const char* value, const char* preset) {
        const auto done = set(settings, name, value, preset);
        EXPECT_TRUE(done.ok()) << done.error().message;
    };
    take("hdrp:projectionModel", "Proxy", "");
    EXPECT_EQ(settings.screen.march, March::Proxy);
    take("projectionModel", "HiZ", "hdrp");
    EXPECT_EQ(settings.screen.march, March::Hiz);
    take("hdrp:refractionModel", "Sphere", "");
    EXPECT_EQ(settings.refraction.model, RefractionModel::Sphere);
    take("hdrp:refractionModel", "None", "");
    EXPECT_EQ(settings.refraction.model, RefractionModel::None_);
    take("reflect.thresholdOn", "F0timesstrength", "");
    EXPECT_EQ(settings.reflect.thresholdOn, ThresholdOn::F0TimesStrength);
    take("babylon:textureType", "RGBA16F", "");
    EXPECT_EQ(settings.screen.targetFormat, TargetFormat::Rgba16f);
    ASSERT_TRUE(fromJson(settings, R"({"hdrp:ssRayModel": "Proxy", "projectionModel": "Proxy",
                                       "fade.border": "SMOOTH"})",
                         "test", "hdrp")
                    .ok());
    EXPECT_EQ(settings.refraction.projection, RefractionProjection::Proxy);
    EXPECT_EQ(settings.screen.march, March::Proxy);
    EXPECT_EQ(settings.fade.border, FadeBorder::Smooth);
    const std::string written = toJson(settings);
    EXPECT_NE(written.find("\"march\": \"proxy\""), written.npos) << "written as the table has it";
    EXPECT_NE(written.find("\"thresholdOn\": \"f0TimesStrength\""), written.npos);
}

TEST(SettingsNames, WholeNumbersMayBeHexadecimal) {
    Settings settings;
    ASSERT_TRUE(set(settings, "ray-query:cull_mask", "0x0F").ok());
    EXPECT_EQ(settings.rays.cullMask, 15);
    ASSERT_TRUE(set(settings, "rays.cullMask", "0Xfe").ok());
    EXPECT_EQ(settings.rays.cullMask, 254);
    EXPECT_EQ(errorOf("rays.cullMask", "0x100"), "rays.cullMask = 256 is out of range [0, 255]");
    for (const char* bad : {"0x", "0xg", "0x1.8", "x1", "0x 1", "-0x1", "0x10000000000000000"})
        EXPECT_EQ(errorOf("rays.cullMask", bad),
                  "rays.cullMask: expected a whole number, got '" + std::string(bad) + "'");
    EXPECT_EQ(errorOf("screen.thickness", "0x1"), "screen.thickness: expected a number, got '0x1'");
}

TEST(SettingsNames, WrongTypesSayWhatIsExpected) {
    EXPECT_EQ(errorOf("screen.step", "fast"), "screen.step: expected a whole number, got 'fast'");
    EXPECT_EQ(errorOf("screen.step", "1.5"), "screen.step: expected a whole number, got '1.5'");
    EXPECT_EQ(errorOf("screen.step", "4px"), "screen.step: expected a whole number, got '4px'");
    EXPECT_EQ(errorOf("screen.thickness", ""), "screen.thickness: expected a number, got ''");
    EXPECT_EQ(errorOf("screen.smooth", "1"), "screen.smooth: expected true or false, got '1'");
    EXPECT_EQ(errorOf("fade.border", "liner"), "fade.border: expected none, smooth or linear, got 'liner'");
    EXPECT_EQ(errorOf("babylon:attenuateScreenBorders", "smooth"),
              "babylon:attenuateScreenBorders: expected true or false, got 'smooth'");
}

TEST(SettingsNames, ValuesOutOfRangeSayTheRange) {
    EXPECT_EQ(errorOf("screen.maxDistance", "0"), "screen.maxDistance = 0 is out of range (0, 1e6] m");
    EXPECT_EQ(errorOf("screen.step", "99999999999999999999"), "screen.step = 1e+20 is out of range [1, 64] px");
    EXPECT_EQ(errorOf("hdrp:minSmoothness", "-0.5"),
              "reflect.maxRoughness = 1.5 is out of range [0, 1] perceptual roughness "
              "(from hdrp:minSmoothness = -0.5)");
}

TEST(SettingsNames, HostileTextStaysOneShortLine) {
    const std::string message = errorOf("a\nb\x1b[31m" + std::string(100000, 'x'), std::string(100000, 'y'));
    EXPECT_LT(message.size(), 300u);
    EXPECT_TRUE(std::ranges::none_of(message, [](char c) { return static_cast<unsigned char>(c) < 0x20; }));
}

} // namespace settings_names_test
} // namespace glint
