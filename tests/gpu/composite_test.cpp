// shaders/composite, shaders/hierarchy and the split-sum table, each pass alone on synthetic inputs, against the
// formulas in double precision.
#include "gpu/support/library_test.hpp"

#include "reflect/hierarchy/source_order.hpp"
#include "reflect/prepare/conventions.hpp"
#include "reflect/prepare/frame_block.hpp"
#include "shared/hierarchy.h"
#include "shared/trace_constants.h"

#include <glm/gtc/constants.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/packing.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>

namespace glint::test {
namespace composite_test {

constexpr double kHalf = 1.0 / 1024; ///< relative step of a half, with one step to spare

double schlick(double f0, double cosine) {
    return f0 + (1 - f0) * std::pow(1 - cosine, 5);
}

/// Reference for the table: the directional albedo of a GGX lobe for f0 = 1 with Schlick's term split off, by
/// quadrature over half vectors. Karis 2013; D of Walter et al. 2007; G2 of Heitz 2014, both with alpha.
glm::dvec2 dfgByQuadrature(double NoV, double perceptualRoughness) {
    const double alpha = perceptualRoughness * perceptualRoughness;
    const double a2 = alpha * alpha;
    const glm::dvec3 wo(std::sqrt(1 - NoV * NoV), 0, NoV);
    const auto lambda = [&](double cosine) {
        return (std::sqrt(1 + a2 * (1 - cosine * cosine) / (cosine * cosine)) - 1) / 2;
    };
    glm::dvec2 sum(0);
    constexpr int kTheta = 400;
    constexpr int kPhi = 200; // half of the circle: the integrand is even in phi
    for (int i = 0; i < kTheta; ++i) {
        // Even steps in the distribution of D(wm) cos(wm): tan^2(theta) = a2 u / (1 - u).
        const double u = (i + 0.5) / kTheta;
        const double cosTheta = 1 / std::sqrt(1 + a2 * u / (1 - u));
        const double sinTheta = std::sqrt(std::max(0.0, 1 - cosTheta * cosTheta));
        for (int j = 0; j < kPhi; ++j) {
            const double phi = glm::pi<double>() * (j + 0.5) / kPhi;
            const glm::dvec3 wm(sinTheta * std::cos(phi), sinTheta * std::sin(phi), cosTheta);
            const double VoH = glm::dot(wo, wm);
            const double NoL = 2 * VoH * wm.z - wo.z;
            if (VoH <= 0 || NoL <= 0)
                continue;
            // f cos / pdf with pdf(wi) = D cos(wm) / (4 VoH) and f = D G2 F / (4 NoV NoL).
            const double g2 = 1 / (1 + lambda(NoV) + lambda(NoL));
            const double weight = g2 * VoH / (NoV * wm.z);
            const double fresnel = std::pow(1 - VoH, 5);
            sum += glm::dvec2(1 - fresnel, fresnel) * weight;
        }
    }
    return sum / double(kTheta * kPhi);
}

/// Every pass runs on one row of pixels: a perspective camera at the origin looking down -Z.
constexpr uint32_t kWidth = 256;
constexpr uint32_t kHeight = 4;

struct Pixel {
    double viewZ = 3;
    glm::dvec3 normalVS = {0, 0, 1};
    glm::vec3 f0 = glm::vec3(1);
    float perceptualRoughness = 0;
    glm::vec3 lit = glm::vec3(0);
    glm::vec3 fallback = glm::vec3(0);
    glm::vec4 answer = glm::vec4(0); ///< composite: reflected; hierarchy: the screen's radiance and weight
    uint32_t outcome = shared::kOutcomeHit;
};

class CompositePassTest : public LibraryTest {
protected:
    static SyntheticCamera camera() {
        SyntheticCamera out;
        out.position = {0, 0, 0};
        out.target = {0, 0, -1};
        return out;
    }

    /// Direction from the eye to pixel `i`, unit, view space.
    static glm::dvec3 toSurface(uint32_t i) { return camera().rayThrough(i % kWidth, i / kWidth, kWidth, kHeight); }

    static gpu::Image upload(const char* name, VkFormat format, std::span<const std::byte> content) {
        return uploadTestImage(gpu(), name, format, kWidth, kHeight, content);
    }

    /// Packs as prepare does; returns what the shader will unpack.
    static gpu::Image uploadSurface(std::vector<Pixel>& pixels) {
        std::vector<glm::uvec2> packed;
        for (Pixel& pixel : pixels) {
            const glm::vec2 p = encodeOctahedral(pixel.normalVS);
            const float reflectivity = std::max({pixel.f0.r, pixel.f0.g, pixel.f0.b});
            packed.emplace_back(glm::packSnorm2x16(p),
                                glm::packUnorm2x16(glm::vec2(pixel.perceptualRoughness, reflectivity)));
            pixel.perceptualRoughness = glm::unpackUnorm2x16(packed.back().y).x;
        }
        return upload("test/surface", VK_FORMAT_R32G32_UINT, bytesOf(packed));
    }

    static gpu::Buffer uploadFrame(uint32_t flags, const shared::SettingsConstants& settings,
                                   const TestEnvironment* environment = nullptr) {
        shared::FrameConstants frame = reflect::makeFrameConstants(camera().view(kWidth, kHeight), {}, kWidth, kHeight);
        frame.flags |= flags;
        if (environment) {
            frame.environmentMips = static_cast<float>(environment->map.mips);
            frame.environmentStrength = environment->map.strength;
            frame.worldToEnvironment = glm::rotate(glm::mat4(1), -environment->map.rotation, glm::vec3(0, 1, 0));
        }
        return must(gpu::uploadBuffer(gpu(), "test/frame", std::vector<reflect::FrameBlockValues>{{frame, settings}},
                                      VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT));
    }

    static gpu::Image output(const char* name, VkFormat format, uint32_t width = kWidth, uint32_t height = kHeight) {
        return must(gpu::Image::create(
            gpu(), {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                    VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    }

    static gpu::Image& dfg() {
        static gpu::Image table = [] {
            gpu::Image image = output("test/dfg", VK_FORMAT_R16G16_SFLOAT, 64, 64);
            const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"prepare/dfg", 0, {}}));
            run([&](VkCommandBuffer commands) {
                gpu::Frame frame(gpu(), commands);
                frame.pass(pipeline).write("dfg", image).dispatch(64, 64);
            });
            return image;
        }();
        return table;
    }

    static std::vector<float> compose(std::vector<Pixel> pixels, const shared::CompositeConstants& constants,
                                      bool hasFallback) {
        std::vector<float> viewZ;
        std::vector<glm::vec4> material;
        std::vector<glm::vec4> lit;
        std::vector<glm::vec4> fallback;
        std::vector<glm::vec4> reflected;
        std::vector<glm::uvec2> record;
        for (const Pixel& pixel : pixels) {
            viewZ.push_back(static_cast<float>(pixel.viewZ));
            material.emplace_back(pixel.f0, 1); // one surface fills the pixel
            lit.emplace_back(pixel.lit, 0.25f);
            fallback.emplace_back(pixel.fallback, 0);
            reflected.push_back(pixel.answer);
            record.emplace_back(0, pixel.outcome << 28);
        }
        constexpr VkFormat kWide = VK_FORMAT_R32G32B32A32_SFLOAT;
        shared::SettingsConstants settings = {};
        settings.composite = constants;
        settings.trace.maxSteps = 1000;
        gpu::Buffer frameConstants = uploadFrame(hasFallback ? shared::kInputFallback : 0, settings);
        gpu::Image surface = uploadSurface(pixels);
        gpu::Image viewZImage = upload("test/viewZ", VK_FORMAT_R32_SFLOAT, bytesOf(viewZ));
        gpu::Image materialImage = upload("test/material", kWide, bytesOf(material));
        gpu::Image litImage = upload("test/lit", kWide, bytesOf(lit));
        gpu::Image fallbackImage = upload("test/fallback", kWide, bytesOf(fallback));
        gpu::Image reflectedImage = upload("test/reflected", kWide, bytesOf(reflected));
        gpu::Image recordImage = upload("test/record", VK_FORMAT_R32G32_UINT, bytesOf(record));
        gpu::Image edge =
            uploadTestImage(gpu(), "test/edge", VK_FORMAT_R32G32B32A32_UINT, 1, 1, bytesOf(std::vector<glm::uvec4>(1)));
        gpu::Image composite = output("test/composite", VK_FORMAT_R16G16B16A16_SFLOAT);
        static const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"composite/composite", 0, {}}));
        gpu::Image& table = dfg();
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("frame", frameConstants)
                .read("viewZ", viewZImage)
                .read("surface", surface)
                .read("material", materialImage)
                .read("edge", edge)
                .read("litRadiance", litImage)
                .read("fallbackSpecular", fallbackImage)
                .read("reflected", reflectedImage)
                .read("rayRecord", recordImage)
                .read("dfg", table)
                .write("composite", composite)
                .dispatch(kWidth, kHeight);
        });
        return must(gpu::downloadImageAsFloats(gpu(), composite));
    }

    /// The table as shaders sample it: bilinear, the outermost texels at 0 and 1.
    static glm::dvec2 sampledDfg(double NoV, double perceptualRoughness) {
        static const std::vector<float> texels = must(gpu::downloadImageAsFloats(gpu(), dfg()));
        const auto split = [](double at) {
            const double t = glm::clamp(at * 63, 0.0, 63.0);
            const auto low = std::min(static_cast<size_t>(t), size_t(62));
            return std::pair(low, t - static_cast<double>(low));
        };
        const auto [x, fx] = split(NoV);
        const auto [y, fy] = split(perceptualRoughness);
        const auto at = [&, x0 = x, y0 = y](size_t dx, size_t dy) {
            const size_t i = ((y0 + dy) * 64 + x0 + dx) * 4;
            return glm::dvec2(texels[i], texels[i + 1]);
        };
        return glm::mix(glm::mix(at(0, 0), at(1, 0), fx), glm::mix(at(0, 1), at(1, 1), fx), fy);
    }

    /// Random pixels: angles, roughness, F0, colours and weights.
    static std::vector<Pixel> randomPixels(uint32_t seed) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(0, 1);
        std::vector<Pixel> pixels(kWidth * kHeight);
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            Pixel& pixel = pixels[i];
            const glm::dvec3 tilt(unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5);
            pixel.normalVS = glm::normalize(-toSurface(i) + tilt * 1.6);
            if (glm::dot(pixel.normalVS, -toSurface(i)) < 0.03)
                pixel.normalVS = -toSurface(i);
            pixel.f0 = {unit(random), unit(random) * 0.3f, 0.04f};
            pixel.perceptualRoughness = unit(random);
            pixel.lit = glm::vec3(unit(random), unit(random), unit(random)) * 2.0f;
            pixel.fallback = pixel.lit * unit(random);
            const float weight = i % 5 == 0 ? 0.0f : i % 5 == 1 ? 1.0f : unit(random);
            pixel.answer = glm::vec4(glm::vec3(unit(random), unit(random), unit(random)) * 3.0f * weight, weight);
        }
        return pixels;
    }

    /// From the packed normal, as in the shader.
    static double NoVOf(const Pixel& pixel, uint32_t i) {
        const glm::vec2 p = glm::unpackSnorm2x16(glm::packSnorm2x16(encodeOctahedral(pixel.normalVS)));
        glm::dvec3 n(p.x, p.y, 1 - std::abs(double(p.x)) - std::abs(double(p.y)));
        if (n.z < 0)
            n = glm::dvec3((1 - std::abs(n.y)) * (n.x >= 0 ? 1 : -1), (1 - std::abs(n.x)) * (n.y >= 0 ? 1 : -1), n.z);
        return glm::clamp(glm::dot(glm::normalize(n), -toSurface(i)), 0.0, 1.0);
    }

    template <class Expected>
    static void expectPicture(const std::vector<float>& picture, const std::vector<Pixel>& pixels, Expected expected) {
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            const glm::dvec3 want = expected(pixels[i], i);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(picture[i * 4 + c], want[c], 2e-3 + 2 * kHalf * std::abs(want[c]))
                    << "pixel " << i << " channel " << c;
            ASSERT_EQ(picture[i * 4 + 3], 0.25f) << "the host's alpha";
        }
    }
};

constexpr shared::CompositeConstants kPhysical = {0, 1, 0, 1, 1};
constexpr shared::CompositeConstants kLerp = {1, 1, 0, 1, 1};

/// docs/techniques/composite.md: single scattering from the table, scaled to conserve energy (Turquin 2019, eq. 16).
glm::dvec3 physicalResponse(const glm::vec3& f0, glm::dvec2 dfg) {
    const glm::dvec3 albedo = glm::dvec3(f0) * dfg.x + dfg.y;
    return albedo * (1.0 + glm::dvec3(f0) * (1 / (dfg.x + dfg.y) - 1));
}

// ---------------------------------------------------------------- the table

TEST_F(CompositePassTest, splitSumTableIsTheIntegral) {
    const std::vector<float> texels = must(gpu::downloadImageAsFloats(gpu(), dfg()));
    for (uint32_t y = 1; y < 64; y += 8)
        for (const uint32_t x : {1u, 3u, 6u, 12u, 24u, 40u, 63u}) {
            const glm::dvec2 expected = dfgByQuadrature(x / 63.0, y / 63.0);
            const glm::dvec2 found(texels[(y * 64 + x) * 4], texels[(y * 64 + x) * 4 + 1]);
            // A few degrees above a smooth surface the quadrature has not converged.
            const double tolerance = x < 6 ? 0.015 : 0.006;
            ASSERT_NEAR(found.x, expected.x, tolerance) << "NoV " << x / 63.0 << " roughness " << y / 63.0;
            ASSERT_NEAR(found.y, expected.y, tolerance) << "NoV " << x / 63.0 << " roughness " << y / 63.0;
        }
    for (size_t i = 0; i < texels.size(); i += 4)
        ASSERT_LE(texels[i] + texels[i + 1], 1 + kHalf) << "no lobe reflects more than it receives";
}

// ---------------------------------------------------------------- composite

TEST_F(CompositePassTest, physicalReplacesTheFallback) {
    const std::vector<Pixel> pixels = randomPixels(1);
    for (const bool hasFallback : {true, false}) {
        const std::vector<float> picture = compose(pixels, kPhysical, hasFallback);
        expectPicture(picture, pixels, [&](const Pixel& pixel, uint32_t i) {
            const glm::dvec2 table = sampledDfg(NoVOf(pixel, i), pixel.perceptualRoughness);
            const glm::dvec3 removed =
                hasFallback ? glm::dvec3(pixel.fallback) * double(pixel.answer.a) : glm::dvec3(0);
            return glm::max(
                glm::dvec3(pixel.lit) - removed + glm::dvec3(pixel.answer) * physicalResponse(pixel.f0, table), 0.0);
        });
    }
}

TEST_F(CompositePassTest, physicalWithoutFresnelUsesF0Alone) {
    const std::vector<Pixel> pixels = randomPixels(2);
    shared::CompositeConstants constants = kPhysical;
    constants.fresnel = 0;
    expectPicture(compose(pixels, constants, true), pixels, [](const Pixel& pixel, uint32_t) {
        return glm::max(glm::dvec3(pixel.lit) - glm::dvec3(pixel.fallback) * double(pixel.answer.a) +
                            glm::dvec3(pixel.answer) * glm::dvec3(pixel.f0),
                        0.0);
    });
}

TEST_F(CompositePassTest, exponentIsOverReflectanceTimesStrength) {
    const std::vector<Pixel> pixels = randomPixels(3);
    for (const float strength : {0.5f, 1.0f, 3.0f})
        for (const float exponent : {0.5f, 2.0f}) {
            shared::CompositeConstants constants = kPhysical;
            constants.fresnel = 0;
            constants.strength = strength;
            constants.falloffExponent = exponent;
            expectPicture(compose(pixels, constants, false), pixels, [&](const Pixel& pixel, uint32_t) {
                const glm::dvec3 response =
                    glm::pow(glm::dvec3(pixel.f0) * double(strength), glm::dvec3(double(exponent)));
                return glm::dvec3(pixel.lit) + glm::dvec3(pixel.answer) * response;
            });
            constants.model = 1;
            expectPicture(compose(pixels, constants, false), pixels, [&](const Pixel& pixel, uint32_t i) {
                const glm::dvec3 m = glm::clamp(
                    glm::pow(glm::dvec3(pixel.f0) * double(strength), glm::dvec3(double(exponent))), 0.0, 1.0);
                const double NoV = NoVOf(pixel, i);
                const glm::dvec3 fresnel(schlick(pixel.f0.r, NoV), schlick(pixel.f0.g, NoV), schlick(pixel.f0.b, NoV));
                const glm::dvec3 reflection =
                    glm::dvec3(pixel.answer) * fresnel + (1.0 - pixel.answer.a) * glm::dvec3(pixel.lit);
                return pixel.answer.a > 0 ? glm::dvec3(pixel.lit) * (1.0 - m) + reflection * m : glm::dvec3(pixel.lit);
            });
        }
}

TEST_F(CompositePassTest, whatIsNotGivenIsNotTaken) {
    const std::vector<Pixel> pixels = randomPixels(5);
    for (const auto& [strength, exponent] :
         {std::pair(0.5f, 1.0f), {0.001f, 1.0f}, {3.0f, 1.0f}, {1.0f, 4.0f}, {1.0f, 0.5f}}) {
        shared::CompositeConstants constants = kPhysical;
        constants.fresnel = 0;
        constants.strength = strength;
        constants.falloffExponent = exponent;
        const std::vector<float> picture = compose(pixels, constants, true);
        expectPicture(picture, pixels, [&](const Pixel& pixel, uint32_t) {
            const glm::dvec3 full(pixel.f0);
            const glm::dvec3 given = glm::pow(full * double(strength), glm::dvec3(double(exponent)));
            const glm::dvec3 taken = glm::min(given / glm::max(full, 1e-6), 1.0);
            return glm::max(glm::dvec3(pixel.lit) - glm::dvec3(pixel.fallback) * double(pixel.answer.a) * taken +
                                glm::dvec3(pixel.answer) * given,
                            0.0);
        });
        if (strength > 0.001f)
            continue;
        for (size_t i = 0; i < pixels.size(); ++i) // the limit is the host's own picture
            EXPECT_NEAR(picture[i * 4], pixels[i].lit.r,
                        0.002 * (1 + pixels[i].lit.r + pixels[i].fallback.r + pixels[i].answer.r));
    }
}

TEST_F(CompositePassTest, lerpWithFresnelIsBabylons) {
    const std::vector<Pixel> pixels = randomPixels(4);
    expectPicture(compose(pixels, kLerp, true), pixels, [](const Pixel& pixel, uint32_t i) {
        const double NoV = NoVOf(pixel, i);
        const glm::dvec3 m(schlick(pixel.f0.r, NoV), schlick(pixel.f0.g, NoV), schlick(pixel.f0.b, NoV));
        const glm::dvec3 reflection = glm::dvec3(pixel.answer) + (1.0 - pixel.answer.a) * glm::dvec3(pixel.lit);
        return glm::dvec3(pixel.lit) * (1.0 - m) + reflection * m;
    });
}

TEST_F(CompositePassTest, untouchedWhereNothingAnswers) {
    std::vector<Pixel> pixels = randomPixels(5);
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        if (i % 3 == 0)
            pixels[i].answer = glm::vec4(0);
        if (i % 3 == 1)
            pixels[i].viewZ = shared::kBackgroundZ;
        if (i % 3 == 2)
            pixels[i].f0 = glm::vec3(0);
        for (int c = 0; c < 3; ++c) // exact in half precision
            pixels[i].lit[c] = glm::unpackHalf1x16(glm::packHalf1x16(pixels[i].lit[c]));
    }
    for (const shared::CompositeConstants& constants : {kPhysical, kLerp}) {
        const std::vector<float> picture = compose(pixels, constants, true);
        for (uint32_t i = 0; i < pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_EQ(picture[i * 4 + c], pixels[i].lit[c]) << "pixel " << i;
    }
}

TEST_F(CompositePassTest, whiteFurnaceNeverExceedsOne) {
    // All radiance is 1 and the surface reflects all of it, so the fallback is 1 too. Every roughness and angle;
    // weights of all sizes.
    std::vector<Pixel> pixels(kWidth * kHeight);
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        const double NoV = (i % 64 + 0.5) / 64;
        const glm::dvec3 toEye = -toSurface(i);
        const glm::dvec3 across = glm::normalize(glm::cross(toEye, glm::dvec3(0, 1, 0)));
        pixels[i].normalVS = toEye * NoV + across * std::sqrt(1 - NoV * NoV);
        pixels[i].perceptualRoughness = static_cast<float>(i / 64) / 15.0f;
        const float weight = i % 2 ? 1.0f : 0.5f;
        pixels[i].lit = pixels[i].fallback = glm::vec3(1);
        pixels[i].answer = glm::vec4(glm::vec3(weight), weight);
    }
    for (const shared::CompositeConstants& constants : {kPhysical, kLerp}) {
        const std::vector<float> picture = compose(pixels, constants, true);
        for (uint32_t i = 0; i < pixels.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                ASSERT_LE(picture[i * 4 + c], 1 + kHalf) << "NoV " << (i % 64 + 0.5) / 64 << " row " << i / 64;
                ASSERT_GE(picture[i * 4 + c], 1 - 2 * kHalf) << "NoV " << (i % 64 + 0.5) / 64 << " row " << i / 64;
            }
    }
    // Dielectrics gain no more than their surroundings' radiance.
    for (Pixel& pixel : pixels) {
        pixel.f0 = glm::vec3(0.04f);
        pixel.lit = glm::vec3(0);
        pixel.answer = glm::vec4(1);
    }
    const std::vector<float> picture = compose(pixels, kPhysical, true);
    for (size_t i = 0; i < picture.size(); ++i)
        if (i % 4 != 3) {
            ASSERT_LE(picture[i], 1 + kHalf);
        }
}

TEST_F(CompositePassTest, extremeColoursStayFiniteHalves) {
    std::vector<Pixel> pixels(kWidth * kHeight);
    const float extremes[] = {0, 1, 65504, 1e30f, INFINITY, NAN, -1};
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        pixels[i].lit = glm::vec3(extremes[i % 7]);
        pixels[i].fallback = glm::vec3(extremes[i / 7 % 7]);
        pixels[i].answer = glm::vec4(glm::vec3(i / 49 % 2 ? 65504.0f : 0.5f), i / 98 % 2 ? 1.0f : 0.5f);
    }
    for (shared::CompositeConstants constants : {kPhysical, kLerp}) {
        constants.strength = 10;
        const std::vector<float> picture = compose(pixels, constants, true);
        for (uint32_t i = 0; i < pixels.size(); ++i)
            for (int c = 0; c < 3; ++c)
                ASSERT_TRUE(picture[i * 4 + c] >= 0 && picture[i * 4 + c] <= 65504) << i << ": " << picture[i * 4 + c];
    }
}

// ---------------------------------------------------------------- hierarchy

class HierarchyPassTest : public CompositePassTest {
protected:
    using Weights = std::array<float, shared::kSourceCount>;
    /// shaders/lib/source_weights.glsl
    static std::vector<Weights> unpackWeights(const std::vector<std::byte>& texels) {
        std::vector<Weights> weights(texels.size() / sizeof(glm::uvec2));
        for (size_t i = 0; i < weights.size(); ++i) {
            glm::uvec2 packed;
            std::memcpy(&packed, texels.data() + i * sizeof(packed), sizeof(packed));
            for (uint32_t source = 0; source < shared::kSourceCount; ++source)
                weights[i][source] =
                    static_cast<float>((packed[static_cast<int>(source / 3)] >> (10 * (source % 3))) & 1023) / 1023;
        }
        return weights;
    }
    struct Answer {
        std::vector<float> reflected;
        std::vector<Weights> weights;
    };
    /// Which sources answer; an empty list: that one does not.
    struct Sources {
        bool screen = true;
        bool sky = true;
        std::vector<glm::vec4> rays = {}, probes = {}, planar = {};
    };
    /// `present`: the environment is.
    static Answer combine(std::vector<Pixel> pixels, TestEnvironment& environment, const Sources& sources,
                          bool present = true, const Settings& settings = {}) {
        const auto& [screen, sky, rays, probes, planar] = sources;
        std::vector<float> viewZ;
        std::vector<glm::vec4> answers;
        for (const Pixel& pixel : pixels) {
            viewZ.push_back(static_cast<float>(pixel.viewZ));
            answers.push_back(pixel.answer);
        }
        const auto bit = [](bool on, uint32_t source) { return on ? 1u << source : 0u; };
        shared::SettingsConstants resolved = {};
        resolved.hierarchy = {bit(screen, shared::kSourceScreen) | bit(!rays.empty(), shared::kSourceRays) |
                                  bit(!planar.empty(), shared::kSourcePlanar) |
                                  bit(!probes.empty(), shared::kSourceProbes) | bit(sky, shared::kSourceSky),
                              reflect::SourceOrder(settings).packed(), 1};
        gpu::Buffer frameConstants = uploadFrame(present ? shared::kInputEnvironment : 0, resolved, &environment);
        gpu::Image surface = uploadSurface(pixels);
        gpu::Image viewZImage = upload("test/viewZ", VK_FORMAT_R32_SFLOAT, bytesOf(viewZ));
        gpu::Image screenImage = upload("test/screen", VK_FORMAT_R32G32B32A32_SFLOAT, bytesOf(answers));
        gpu::Image raysImage =
            upload("test/rays", VK_FORMAT_R32G32B32A32_SFLOAT, bytesOf(rays.empty() ? answers : rays));
        gpu::Image recordImage = upload("test/raysRecord", VK_FORMAT_R32G32B32A32_UINT,
                                        bytesOf(std::vector<glm::uvec4>(pixels.size(), glm::uvec4(0))));
        gpu::Image probesImage =
            upload("test/probes", VK_FORMAT_R32G32B32A32_SFLOAT, bytesOf(probes.empty() ? answers : probes));
        gpu::Image planarImage =
            upload("test/planar", VK_FORMAT_R32G32B32A32_SFLOAT, bytesOf(planar.empty() ? answers : planar));
        gpu::Image reflected = output("test/reflected", VK_FORMAT_R16G16B16A16_SFLOAT);
        gpu::Image weights = output("test/weights", VK_FORMAT_R32G32_UINT);
        static const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"hierarchy/combine", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline)
                .read("frame", frameConstants)
                .read("viewZ", viewZImage)
                .read("surface", surface)
                .read("answers", std::array<gpu::Image*, shared::kMaxSources>{&screenImage, &raysImage, &planarImage,
                                                                              &probesImage, &screenImage, &screenImage})
                .read("answersRaysRecord", recordImage)
                .read("environment", environment.cube)
                .read("occlusion", screenImage) // none is stated
                .write("reflected", reflected)
                .write("weights", weights)
                .dispatch(kWidth, kHeight);
        });
        return {must(gpu::downloadImageAsFloats(gpu(), reflected)),
                unpackWeights(must(gpu::downloadImage(gpu(), weights)))};
    }

    /// The screen's answer as trace writes it: radiance not multiplied by its weight.
    static std::vector<Pixel> screenPixels(uint32_t seed) {
        std::vector<Pixel> pixels = randomPixels(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<float> unit(0, 1);
        for (Pixel& pixel : pixels)
            pixel.answer = glm::vec4(unit(random), unit(random), unit(random), pixel.answer.a);
        return pixels;
    }
    static glm::dvec3 reflectedDirection(const Pixel& pixel, uint32_t i) {
        return glm::reflect(toSurface(i), pixel.normalVS);
    }
};

/// Linear in the direction, so that filtering a cube map of it is nearly exact.
glm::dvec3 ramp(const glm::dvec3& d) {
    return {0.5 + 0.4 * d.x, 0.5 + 0.4 * d.y, 0.5 + 0.4 * d.z};
}

TEST_F(HierarchyPassTest, skyGetsExactlyWhatTheScreenLeft) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 64, 1, [](const glm::dvec3& d, uint32_t) { return glm::vec3(ramp(d)); });
    environment.map.strength = 1.5f;
    std::vector<Pixel> pixels = screenPixels(7);
    for (Pixel& pixel : pixels)
        pixel.perceptualRoughness *= 0.09f; // of rougher ones' lobes the mirror direction is not the whole
    const Answer answer = combine(pixels, environment, {});
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        const double w = pixels[i].answer.a;
        const glm::dvec3 sky = ramp(reflectedDirection(pixels[i], i)) * 1.5;
        const glm::dvec3 expected = w * glm::dvec3(pixels[i].answer) + (1 - w) * sky;
        for (int c = 0; c < 3; ++c) // a texel of 64 spans 1.4 degrees, across which the ramp bends by at most 1e-3
            ASSERT_NEAR(answer.reflected[i * 4 + c], expected[c], 3e-3) << i;
        ASSERT_NEAR(answer.reflected[i * 4 + 3], 1, kHalf) << "all weight is given";
        ASSERT_NEAR(answer.weights[i][shared::kSourceScreen], w, 0.5 / 1023 + 1e-6);
        ASSERT_NEAR(answer.weights[i][shared::kSourceSky], 1 - w, 0.5 / 1023 + 1e-6);
    }
}

/// Also with rays or probes alone behind the screen.
TEST_F(HierarchyPassTest, eachSourceGetsWhatThoseBeforeItLeft) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    const std::vector<Pixel> pixels = screenPixels(9);
    const auto answersOf = [](const std::vector<Pixel>& from, float share) {
        std::vector<glm::vec4> answers;
        for (const Pixel& pixel : from)
            answers.emplace_back(glm::vec3(pixel.answer), pixel.answer.a * share);
        return answers;
    };
    const std::vector<glm::vec4> rays = answersOf(screenPixels(10), 0.5f);
    const std::vector<glm::vec4> probes = answersOf(screenPixels(11), 0.5f);
    for (const bool hasRays : {true, false})
        for (const bool hasProbes : {true, false}) {
            const Answer answer =
                combine(pixels, environment,
                        {.rays = hasRays ? rays : answersOf({}, 1), .probes = hasProbes ? probes : answersOf({}, 1)});
            for (uint32_t i = 0; i < pixels.size(); ++i) {
                const double screen = pixels[i].answer.a;
                const double traced = hasRays ? std::min(double(rays[i].a), 1 - screen) : 0;
                const double looked = hasProbes ? std::min(double(probes[i].a), 1 - screen - traced) : 0;
                const double sky = 1 - screen - traced - looked;
                const glm::dvec3 expected = screen * glm::dvec3(pixels[i].answer) + traced * glm::dvec3(rays[i]) +
                                            looked * glm::dvec3(probes[i]) + glm::dvec3(sky);
                for (int c = 0; c < 3; ++c)
                    ASSERT_NEAR(answer.reflected[i * 4 + c], expected[c], 2 * kHalf) << i;
                ASSERT_NEAR(answer.weights[i][shared::kSourceScreen], screen, 0.5 / 1023 + 1e-6);
                ASSERT_NEAR(answer.weights[i][shared::kSourceSky], sky, 0.5 / 1023 + 1e-6);
                ASSERT_NEAR(answer.weights[i][shared::kSourceRays], traced, 0.5 / 1023 + 1e-6);
                ASSERT_NEAR(answer.weights[i][shared::kSourceProbes], looked, 0.5 / 1023 + 1e-6);
            }
        }
}

/// Every order of the five, against the rule in double precision.
TEST_F(HierarchyPassTest, theOrderIsTheUsers) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(0.25f); });
    const std::vector<Pixel> pixels = screenPixels(12);
    const auto answersOf = [](const std::vector<Pixel>& from) {
        std::vector<glm::vec4> answers;
        for (const Pixel& pixel : from)
            answers.push_back(pixel.answer);
        return answers;
    };
    const std::vector<std::vector<glm::vec4>> answers = {
        answersOf(pixels), answersOf(screenPixels(13)), answersOf(screenPixels(14)), answersOf(screenPixels(15)),
        std::vector<glm::vec4>(pixels.size(), glm::vec4(0.25, 0.25, 0.25, 1))};
    std::array<int, shared::kSourceCount> places = {0, 1, 2, 3, 4};
    do {
        Settings settings;
        settings.order = {places[0], places[1], places[2], places[3], places[4]};
        const Answer answer = combine(pixels, environment,
                                      {.rays = answers[1], .probes = answers[3], .planar = answers[2]}, true, settings);
        for (uint32_t i = 0; i < pixels.size(); ++i) {
            glm::dvec3 expected(0);
            double total = 0;
            for (int place = 0; place < 5; ++place) {
                const auto source = static_cast<size_t>(std::ranges::find(places, place) - places.begin());
                const glm::dvec4 given(answers[source][i]);
                const double left = 1 - total;
                const double share = given.a >= (1 - 1.0 / 512) * left ? left : given.a; // hierarchy/walk.glsl
                expected += share * glm::dvec3(given);
                total += share;
                ASSERT_NEAR(answer.weights[i][source], share, 0.5 / 1023 + 1e-6) << i;
            }
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(answer.reflected[i * 4 + c], expected[c], 2 * kHalf) << i;
        }
    } while (std::ranges::next_permutation(places).found);
}

TEST_F(HierarchyPassTest, eachSourceCanBeAbsent) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    const std::vector<Pixel> pixels = screenPixels(8);
    const Answer screenOnly = combine(pixels, environment, {.sky = false});
    const Answer skyOnly = combine(pixels, environment, {.screen = false});
    const Answer none = combine(pixels, environment, {.screen = false, .sky = false});
    const Answer noCube = combine(pixels, environment, {}, false);
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        ASSERT_NEAR(screenOnly.reflected[i * 4 + 3], pixels[i].answer.a, kHalf);
        ASSERT_NEAR(screenOnly.reflected[i * 4], pixels[i].answer.a * pixels[i].answer.r, kHalf);
        ASSERT_EQ(skyOnly.reflected[i * 4 + 3], 1);
        ASSERT_NEAR(skyOnly.reflected[i * 4], 1, kHalf);
        ASSERT_EQ(none.reflected[i * 4 + 3], 0);
        ASSERT_EQ(none.reflected[i * 4], 0);
    }
    EXPECT_EQ(noCube.reflected, screenOnly.reflected);
}

TEST_F(HierarchyPassTest, weightsNeverExceedOneAndBackgroundGetsNone) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3&, uint32_t) { return glm::vec3(2); });
    std::vector<Pixel> pixels = screenPixels(9);
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        pixels[i].answer.a = static_cast<float>(i % 9) * 0.25f - 0.5f; // -0.5 to 1.5: no source should, but one might
        if (i % 4 == 0)
            pixels[i].viewZ = shared::kBackgroundZ;
    }
    const Answer answer = combine(pixels, environment, {});
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        ASSERT_LE(answer.reflected[i * 4 + 3], 1);
        ASSERT_LE(answer.weights[i][shared::kSourceScreen] + answer.weights[i][shared::kSourceSky], 1 + 1.001 / 1023)
            << "each is rounded to 10 bits";
        if (i % 4 == 0) {
            ASSERT_EQ(answer.reflected[i * 4 + 3], 0);
        }
    }
}

TEST_F(HierarchyPassTest, environmentTurnsCounterClockwiseSeenFromAbove) {
    // A bright patch toward +X; turned by 90 degrees counter-clockwise seen from above (+Y toward the eye, X to the
    // right, Z toward the viewer's chin), it lies toward -Z.
    TestEnvironment environment = TestEnvironment::make(
        gpu(), 32, 1, [](const glm::dvec3& d, uint32_t) { return d.x > 0.95 ? glm::vec3(1) : glm::vec3(0); });
    environment.map.rotation = glm::half_pi<float>();
    std::vector<Pixel> pixels(kWidth * kHeight);
    const auto reflectInto = [&](uint32_t i, const glm::dvec3& direction) {
        pixels[i].normalVS = glm::normalize(direction - toSurface(i));
    };
    const uint32_t middle = kWidth / 2;
    reflectInto(middle, glm::normalize(glm::dvec3(1, 0.01, -0.01)));
    reflectInto(middle + 1, glm::normalize(glm::dvec3(-1, 0.01, -0.01)));
    reflectInto(middle + 2, glm::normalize(glm::dvec3(0.01, 0.2, -1)));
    const Answer answer = combine(pixels, environment, {.screen = false});
    EXPECT_EQ(answer.reflected[middle * 4], 0);
    EXPECT_EQ(answer.reflected[(middle + 1) * 4], 0);
    EXPECT_EQ(answer.reflected[(middle + 2) * 4], 1);
}

TEST_F(HierarchyPassTest, roughnessPicksTheMip) {
    constexpr uint32_t kMips = 5;
    TestEnvironment environment = TestEnvironment::make(
        gpu(), 16, kMips, [](const glm::dvec3&, uint32_t mip) { return glm::vec3(static_cast<float>(mip)); });
    std::vector<Pixel> pixels(kWidth * kHeight);
    for (uint32_t i = 0; i < pixels.size(); ++i) // rougher lobes are mixtures: lib/environment_lobe.glsl
        pixels[i].perceptualRoughness = 0.099f * static_cast<float>(i % kWidth) / (kWidth - 1.0f);
    const Answer answer = combine(pixels, environment, {.screen = false});
    for (uint32_t i = 0; i < pixels.size(); ++i) // drivers blend mips in steps of 1/256 at least
        ASSERT_NEAR(answer.reflected[i * 4], pixels[i].perceptualRoughness * (kMips - 1), 8e-3);
}

TEST_F(HierarchyPassTest, anEvenEnvironmentIsExactAtEveryRoughnessAndAngle) {
    TestEnvironment environment =
        TestEnvironment::make(gpu(), 16, 5, [](const glm::dvec3&, uint32_t) { return glm::vec3(1); });
    std::vector<Pixel> pixels = screenPixels(11);
    for (uint32_t i = 0; i < pixels.size(); ++i)
        pixels[i].perceptualRoughness = static_cast<float>(i % kWidth) / (kWidth - 1.0f);
    const Answer answer = combine(pixels, environment, {.screen = false});
    for (uint32_t i = 0; i < pixels.size(); ++i) {
        if (answer.reflected[i * 4 + 3] > 0) {
            ASSERT_NEAR(answer.reflected[i * 4], 1, 2e-3) << "roughness " << pixels[i].perceptualRoughness;
        }
    }
}

TEST_F(HierarchyPassTest, brokenEnvironmentStaysFinite) {
    TestEnvironment environment = TestEnvironment::make(gpu(), 8, 1, [](const glm::dvec3& d, uint32_t) {
        return glm::vec3(d.x > 0 ? 65504.0f : INFINITY, d.y > 0 ? NAN : 65504.0f, -4);
    });
    environment.map.strength = 1000;
    const std::vector<Pixel> pixels = screenPixels(10);
    const Answer answer = combine(pixels, environment, {});
    for (size_t i = 0; i < answer.reflected.size(); ++i)
        ASSERT_TRUE(answer.reflected[i] >= 0 && answer.reflected[i] <= 65504) << i << ": " << answer.reflected[i];
}

} // namespace composite_test
} // namespace glint::test
