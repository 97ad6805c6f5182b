// Base of tests of the whole library: a synthetic frame in, all of the library's results out.
#pragma once

#include "gpu/support/synthetic_gbuffer.hpp"
#include "reflect/trace/technique.hpp"

#include "reflect/trace/outcomes.hpp"

namespace glint::test {

/// A frame's results. Views are RGBA floats, row by row.
struct Picture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<float> composite;
    std::vector<float> reflection;
    std::vector<float> weight;
    std::vector<float> hitUV;
    std::vector<float> hitDistance;
    std::vector<float> lookups;
    std::vector<float> outcomeColor;
    Statistics statistics;
    std::vector<PassTime> passTimes;

    size_t pixels() const { return size_t(width) * height; }
    glm::vec3 color(size_t pixel) const {
        return {composite[pixel * 4], composite[pixel * 4 + 1], composite[pixel * 4 + 2]};
    }
    glm::dvec2 hitPX(size_t pixel) const {
        return {hitUV[pixel * 4] * static_cast<double>(width), hitUV[pixel * 4 + 1] * static_cast<double>(height)};
    }
    /// kOutcome*, from its colour; every outcome has its own colour.
    uint32_t outcome(size_t pixel) const;
    bool hit(size_t pixel) const { return outcome(pixel) == shared::kOutcomeHit; }
    /// True if the ray has an answer: a front, the slab behind one, or a surface behind an occluder.
    bool answered(size_t pixel) const { return reflect::isAnswered(outcome(pixel)); }
    /// Number of pixels with this outcome in the statistics.
    uint64_t counted(std::string_view outcome) const;
    double meanWeight() const;
};

/// A cube map with this radiance in every direction, or one radiance for each mip. `alpha`: 1 without it.
struct TestEnvironment {
    gpu::Image cube;
    EnvironmentMap map;
    static TestEnvironment make(gpu::Context& context, uint32_t size, uint32_t mips,
                                const std::function<glm::vec3(const glm::dvec3& direction, uint32_t mip)>& radiance,
                                const std::function<double(const glm::dvec3& direction)>& alpha = {});
};

/// Probes with empty cubes: volumes for march proxy. They must outlive the frames.
struct TestVolumes {
    TestEnvironment cube;
    Probes probes;
    static TestVolumes giveTo(Reflections& reflections, gpu::Context& context, Context& library,
                              std::vector<Probe> volumes);
};

class LibraryTest : public GpuTest {
protected:
    /// All fades off: a hit has weight 1.
    static Settings plainSettings(March march = March::Hiz);
    /// Limits the marcher's iterations, by the setting for its own limit; adaptive has none.
    static void limitIterations(Settings& settings, int most);
    static Reflections reflections(uint32_t width, uint32_t height, const Settings& settings = plainSettings());
    /// A view of the last recorded frame, RGBA.
    static std::vector<float> readView(Reflections& reflections, std::string_view name);
    /// Records one frame and reads all of its results.
    static Picture trace(Reflections& reflections, const View& view);
    static Picture trace(const SyntheticScene& scene, const SyntheticCamera& camera, uint32_t width, uint32_t height,
                         const Settings& settings, const EnvironmentMap& environment = {});
    /// With the volumes of probes whose source is disabled.
    static Picture traceWithin(const std::vector<Probe>& volumes, const SyntheticScene& scene,
                               const SyntheticCamera& camera, uint32_t width, uint32_t height, Settings settings);
};

/// The marchers, by their place in the registry, for which a property holds; the others are not tested for it.
template <class Property>
std::vector<size_t> techniquesWith(Property property) {
    std::vector<size_t> found;
    for (size_t i = 0; i < reflect::techniques().size(); ++i)
        if (property(reflect::techniques()[i]))
            found.push_back(i);
    return found;
}

} // namespace glint::test
