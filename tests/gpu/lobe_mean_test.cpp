// resolve/lobe: what a rough floor shows of small lamps before the night sky, held against the lobe integrated over
// each lamp. Hits alone would show discs with hard edges, and lose what the lobes of pixels beside them receive.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"

#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace glint::test {
namespace lobe_mean_test {

constexpr uint32_t kWidth = 192;
constexpr uint32_t kHeight = 128;
constexpr float kLampRadiance = 40;

struct Lamp {
    glm::dvec2 center; ///< x, y
    double z;
    double half; ///< of its side, metres
};

double smithLambda(double cosine, double alpha) {
    return (std::sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
}

/// What a floor reflects to the eye of light from `wi`, with the cosine, without Fresnel. Walter et al. 2007,
/// "Microfacet Models for Refraction through Rough Surfaces"; height-correlated Smith.
double response(const glm::dvec3& wo, const glm::dvec3& wi, double alpha) {
    if (wi.y <= 0 || wo.y <= 0)
        return 0;
    const glm::dvec3 h = glm::normalize(wo + wi);
    const double a2 = alpha * alpha;
    const double d = a2 / (glm::pi<double>() * std::pow(h.y * h.y * (a2 - 1) + 1, 2));
    return d / (1 + smithLambda(wo.y, alpha) + smithLambda(wi.y, alpha)) / (4 * wo.y);
}

/// The same of light from everywhere.
double albedo(double cosine, double alpha) {
    const glm::dvec3 wo(std::sqrt(1 - cosine * cosine), cosine, 0);
    const glm::dvec3 eye = glm::normalize(glm::dvec3(alpha * wo.x, wo.y, alpha * wo.z));
    double sum = 0;
    constexpr int kSide = 24;
    for (int i = 0; i < kSide * kSide; ++i) { // visible facets: Dupuy and Benyoub 2023, spherical caps
        const double turn = 2 * glm::pi<double>() * (i % kSide + 0.5) / kSide;
        const double up = (1 - (i + 0.5) / kSide / kSide) * (1 + eye.y) - eye.y;
        const double out = std::sqrt(std::max(0.0, 1 - up * up));
        const glm::dvec3 h = glm::dvec3(out * std::cos(turn), up, out * std::sin(turn)) + eye;
        const glm::dvec3 facet = glm::normalize(glm::dvec3(alpha * h.x, h.y, alpha * h.z));
        const glm::dvec3 wi = glm::reflect(-wo, facet);
        if (wi.y > 0)
            sum += (1 + smithLambda(wo.y, alpha)) / (1 + smithLambda(wo.y, alpha) + smithLambda(wi.y, alpha));
    }
    return sum / (kSide * kSide);
}

class LobeMeanTest : public LibraryTest {
protected:
    static SyntheticCamera camera() {
        SyntheticCamera camera;
        camera.position = {0, 1.5, 5};
        camera.target = {0, 0.6, 0};
        return camera;
    }
    static SyntheticScene street(const std::vector<Lamp>& lamps, float roughness) {
        Stage stage;
        stage.floorRoughness = roughness;
        for (const Lamp& lamp : lamps)
            stage.cards.push_back({.low = lamp.center - lamp.half, .high = lamp.center + lamp.half, .z = lamp.z});
        return litBy(stage, glm::vec3(kLampRadiance));
    }
    static Settings settings() {
        Settings settings = plainSettings();
        settings.rough.cones = true;
        settings.reflect.roughnessFadeStart = 1;
        settings.reflect.maxRoughness = 1;
        return settings;
    }
    /// Mean over the lobe of a floor point.
    static double truth(const std::vector<Lamp>& lamps, const glm::dvec3& at, const glm::dvec3& wo, double alpha) {
        constexpr int kSide = 8;
        double sum = 0;
        for (const Lamp& lamp : lamps)
            for (int i = 0; i < kSide * kSide; ++i) {
                const double step = 2 * lamp.half / kSide;
                const glm::dvec3 from(lamp.center.x - lamp.half + step * (i % kSide + 0.5),
                                      lamp.center.y - lamp.half + step * (i / kSide + 0.5), lamp.z);
                const glm::dvec3 way = from - at;
                const double metres = glm::length(way);
                const glm::dvec3 wi = way / metres;
                sum += response(wo, wi, alpha) * std::max(-wi.z, 0.0) * step * step / (metres * metres);
            }
        return kLampRadiance * sum / albedo(wo.y, alpha);
    }

    struct Figures {
        double relativeError = 0; ///< mean of the squared error, clipped to 1, over the squared truth and a hundredth
        double energy = 0;        ///< over the truth's, clipped to 1
    };
    static Figures compare(const std::vector<Lamp>& lamps, float roughness, const Settings& settings) {
        const Picture picture = trace(street(lamps, roughness), camera(), kWidth, kHeight, settings);
        const double alpha = double{roughness} * double{roughness};
        Figures figures;
        double shown = 0;
        double right = 0;
        size_t compared = 0;
        for (uint32_t y = kHeight / 2; y < kHeight; ++y)
            for (uint32_t x = 0; x < kWidth; ++x) {
                const glm::dvec3 direction = camera().rayThrough(x, y, kWidth, kHeight);
                const glm::dvec3 eye = camera().originThrough(x, y, kWidth, kHeight);
                const double toFloor = -eye.y / direction.y;
                if (direction.y >= 0 || toFloor > 40)
                    continue;
                const double expected = std::min(truth(lamps, eye + direction * toFloor, -direction, alpha), 1.0);
                const double found =
                    std::min(static_cast<double>(picture.reflection[(size_t{y} * kWidth + x) * 4]), 1.0);
                figures.relativeError += (found - expected) * (found - expected) / (expected * expected + 0.01);
                shown += found;
                right += expected;
                ++compared;
            }
        figures.relativeError /= static_cast<double>(std::max<size_t>(compared, 1));
        figures.energy = shown / right;
        return figures;
    }
};

const std::vector<Lamp> kOne = {{{0.3, 1.4}, -4, 0.15}};
const std::vector<Lamp> kRow = {{{-0.8, 1.6}, -1, 0.08},
                                {{-0.8, 1.6}, -3, 0.08},
                                {{-0.8, 1.6}, -5, 0.08},
                                {{-0.8, 1.6}, -7, 0.08},
                                {{0.9, 0.5}, -2, 0.1}};

TEST_F(LobeMeanTest, aLampIsAStreakOfTheLobesShape) {
    for (const float roughness : {0.1f, 0.2f, 0.3f}) {
        SCOPED_TRACE(roughness);
        const Figures one = compare(kOne, roughness, settings());
        const Figures row = compare(kRow, roughness, settings());
        std::printf("roughness %.2f: a lamp: error %.4f, energy %.3f; a row: %.4f, %.3f\n", double{roughness},
                    one.relativeError, one.energy, row.relativeError, row.energy);
        EXPECT_LT(one.relativeError, 0.03);
        EXPECT_NEAR(one.energy, 1, 0.2);
        EXPECT_LT(row.relativeError, 0.04);
        EXPECT_NEAR(row.energy, 1, 0.2);
    }
}

TEST_F(LobeMeanTest, aQuarterOfTheRaysShowTheStreak) {
    Settings quarter = settings();
    quarter.screen.resolutionScale = 0.5f;
    const Figures one = compare(kOne, 0.12f, quarter);
    std::printf("error %.4f, energy %.3f\n", one.relativeError, one.energy);
    EXPECT_LT(one.relativeError, 0.03);
    EXPECT_NEAR(one.energy, 1, 0.3); // a lamp is as large as the traced pixels that hit it
}

} // namespace lobe_mean_test
} // namespace glint::test
