// Directions of rough reflections against their intended density, integrated here in double precision.
#include "gpu/support/brdf_oracle.hpp"
#include "gpu/support/gpu_test.hpp"

#include <cstring>
#include <numeric>
#include <random>

namespace glint::test {
namespace ggx_sampling_test {

/// Layout of tests/gpu/shaders/ggx_samples.comp.
struct Item {
    glm::vec3 wo;
    float alpha;
    glm::vec2 u;
    uint32_t reflected;
    glm::vec3 wm;
    float weight;
};

enum class Normals { Visible, Reflecting };

double heightOfReflected(const glm::dvec3& wo, const glm::dvec3& wm) {
    return 2 * glm::dot(wo, wm) * wm.z - wo.z;
}

constexpr int kPolarBins = 12;
constexpr int kAzimuthBins = 16;
constexpr int kBins = kPolarBins * kAzimuthBins;

class GgxSamplingTest : public GpuTest {
protected:
    static std::vector<Item> sample(Normals normals, const glm::dvec3& wo, double alpha, uint32_t count) {
        std::mt19937 random(11);
        std::uniform_real_distribution<float> unit(0, 1);
        std::vector<Item> list(count);
        for (Item& item : list)
            item = {glm::vec3(wo),
                    static_cast<float>(alpha),
                    {unit(random), unit(random)},
                    normals == Normals::Reflecting ? 1u : 0u,
                    {},
                    0};
        gpu::Buffer buffer = must(gpu::uploadBuffer(
            gpu(), "test/ggx", list, VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT));
        const gpu::Pipeline pipeline = must(gpu::Pipeline::compute(gpu(), {"ggx_samples", 0, {}}));
        run([&](VkCommandBuffer commands) {
            gpu::Frame frame(gpu(), commands);
            frame.pass(pipeline).readWrite("items", buffer).dispatch(count);
        });
        const std::vector<std::byte> bytes = must(gpu::downloadBuffer(gpu(), buffer));
        std::memcpy(list.data(), bytes.data(), list.size() * sizeof(Item));
        return list;
    }

    /// Slopes are compressed so that narrow lobes fill the bins too: s = tan(theta) / (tan(theta) + alpha).
    static int binOf(const glm::dvec3& wm, double alpha) {
        const double tangent = std::hypot(wm.x, wm.y) / wm.z;
        const double turn = std::atan2(wm.y, wm.x) / (2 * oracle::kPi) + 0.5;
        const int polar = std::min(int(tangent / (tangent + alpha) * kPolarBins), kPolarBins - 1);
        return polar * kAzimuthBins + std::min(int(turn * kAzimuthBins), kAzimuthBins - 1);
    }

    /// D_wo(wm) = G1(wo) max(wo.wm, 0) D(wm) / wo.z (Heitz 2018, eq. 3), or of the bounded cap 2 max(wo.wm, 0) D(wm) /
    /// (k wo.z + sqrt(alpha^2 (1 - wo.z^2) + wo.z^2)) where light is reflected upwards (Eto and Tokuyoshi 2023, eqs. 5
    /// and 8, times 4 wo.wm), integrated over each bin.
    static std::vector<double> expectedShares(Normals normals, const glm::dvec3& wo, double alpha) {
        const double a2 = alpha * alpha;
        const double wide = 1 + std::hypot(wo.x, wo.y);
        const double k = (1 - a2) * wide * wide / (wide * wide + a2 * wo.z * wo.z);
        const double scale = normals == Normals::Visible
                                 ? 1 / (1 + oracle::lambda(wo.z, alpha)) / wo.z
                                 : 2 / (k * wo.z + std::sqrt(a2 * (1 - wo.z * wo.z) + wo.z * wo.z));
        std::vector<double> shares(kBins, 0.0);
        constexpr int kSub = 40; // midpoints along a bin's side
        for (int p = 0; p < kPolarBins * kSub; ++p)
            for (int a = 0; a < kAzimuthBins * kSub; ++a) {
                const double s = (p + 0.5) / (kPolarBins * kSub);
                const double tangent = alpha * s / (1 - s);
                const double cosine = 1 / std::sqrt(1 + tangent * tangent);
                const double sine = tangent * cosine;
                const double phi = ((a + 0.5) / (kAzimuthBins * kSub) - 0.5) * 2 * oracle::kPi;
                const glm::dvec3 wm(sine * std::cos(phi), sine * std::sin(phi), cosine);
                if (normals == Normals::Reflecting && heightOfReflected(wo, wm) <= 0)
                    continue;
                const double density = scale * std::max(glm::dot(wo, wm), 0.0) * oracle::ggx(cosine, alpha);
                // dw = sin(theta) dtheta dphi, dtheta = cos^2(theta) dtan, dtan = alpha / (1 - s)^2 ds
                const double jacobian = sine * cosine * cosine * alpha / ((1 - s) * (1 - s));
                const double cell = 1.0 / (kPolarBins * kSub) * 2 * oracle::kPi / (kAzimuthBins * kSub);
                shares[size_t(binOf(wm, alpha))] += density * jacobian * cell;
            }
        return shares;
    }
};

/// How unlikely the counts are under these shares, in standard deviations, by Pearson's statistic. Bins with few
/// expected samples are merged.
double surprise(const std::vector<double>& shares, const std::vector<double>& counts, double samples) {
    double statistic = 0;
    double restExpected = 0;
    double restCounted = 0;
    int degrees = -1;
    const auto add = [&](double expected, double counted) {
        statistic += (counted - expected) * (counted - expected) / expected;
        ++degrees;
    };
    for (size_t bin = 0; bin < shares.size(); ++bin) {
        const double expected = shares[bin] * samples;
        if (expected >= 10) {
            add(expected, counts[bin]);
        } else {
            restExpected += expected;
            restCounted += counts[bin];
        }
    }
    if (restExpected >= 10)
        add(restExpected, restCounted);
    EXPECT_GT(degrees, 20);
    // Wilson and Hilferty 1931: the statistic's cube root is nearly normal.
    const double d = degrees;
    return (std::cbrt(statistic / d) - (1 - 2 / (9 * d))) / std::sqrt(2 / (9 * d));
}

TEST_F(GgxSamplingTest, DirectionsHaveTheDensityOfVisibleNormals) {
    constexpr uint32_t kSamples = 200000;
    for (const double roughness : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0})
        for (const double cosine : {0.1, 0.5, 0.95}) {
            const double alpha = roughness * roughness;
            const double sine = std::sqrt(1 - cosine * cosine);
            const glm::dvec3 wo(sine * std::cos(0.7), sine * std::sin(0.7), cosine);
            const std::vector<double> shares = expectedShares(Normals::Visible, wo, alpha);
            std::vector<double> counts(kBins, 0.0);
            for (const Item& item : sample(Normals::Visible, wo, alpha, kSamples))
                counts[size_t(binOf(glm::dvec3(item.wm), alpha))] += 1;
            EXPECT_NEAR(std::accumulate(shares.begin(), shares.end(), 0.0), 1, 2e-3) << "the density itself";
            // 4 sigma: one in 30 000
            EXPECT_LT(surprise(shares, counts, kSamples), 4) << "roughness " << roughness << ", cosine " << cosine;
        }
}

TEST_F(GgxSamplingTest, ReflectedDirectionsHaveTheBoundedDensityAndFewerGoBelow) {
    constexpr uint32_t kSamples = 200000;
    double mostSaved = 0;
    for (const double roughness : {0.05, 0.2, 0.4, 0.6, 0.8, 1.0})
        for (const double cosine : {0.1, 0.5, 0.95}) {
            const double alpha = roughness * roughness;
            const double sine = std::sqrt(1 - cosine * cosine);
            const glm::dvec3 wo(sine * std::cos(0.7), sine * std::sin(0.7), cosine);
            std::vector<double> shares = expectedShares(Normals::Reflecting, wo, alpha);
            const double above = std::accumulate(shares.begin(), shares.end(), 0.0);
            EXPECT_LE(above, 1 + 2e-3) << "the density itself";
            shares.push_back(std::max(1 - above, 0.0));
            std::vector<double> counts(shares.size(), 0.0);
            for (const Item& item : sample(Normals::Reflecting, wo, alpha, kSamples)) {
                const glm::dvec3 wm(item.wm);
                counts[heightOfReflected(wo, wm) > 0 ? size_t(binOf(wm, alpha)) : size_t(kBins)] += 1;
            }
            EXPECT_LT(surprise(shares, counts, kSamples), 4) << "roughness " << roughness << ", cosine " << cosine;
            double below = 0;
            for (const Item& item : sample(Normals::Visible, wo, alpha, kSamples))
                below += item.weight == 0;
            EXPECT_LE(counts.back(), below + 3 * std::sqrt(below + 1)) << roughness << " " << cosine;
            mostSaved = std::max(mostSaved, (below - counts.back()) / kSamples);
        }
    EXPECT_GT(mostSaved, 0.1) << "of all samples, where most go below";
}

/// The mean weight of samples is the split sum of a lobe with F = 1.
TEST_F(GgxSamplingTest, WeightsAverageToTheAlbedo) {
    for (const Normals normals : {Normals::Visible, Normals::Reflecting})
        for (const double roughness : {0.1, 0.5, 1.0})
            for (const double cosine : {0.2, 0.9}) {
                const glm::dvec3 wo(std::sqrt(1 - cosine * cosine), 0, cosine);
                double sum = 0;
                const std::vector<Item> items = sample(normals, wo, roughness * roughness, 50000);
                for (const Item& item : items)
                    sum += item.weight;
                const glm::dvec2 albedo = oracle::splitSum(cosine, roughness);
                EXPECT_NEAR(sum / double(items.size()), albedo.x + albedo.y, 0.005) << roughness << " " << cosine;
            }
}

} // namespace ggx_sampling_test
} // namespace glint::test
