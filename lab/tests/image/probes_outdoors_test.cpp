// Baked probes under the open sky: a street with a wet patch between two rows of houses and trees. A probe's cube shows
// the street from one place; where a tree hides a ray's hit from the cube, the tree's own colours must not appear.
#include "base/file.hpp"
#include "lab/tests/image/source_choices.hpp"
#include "lab/tests/support/gltf_builder.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::test {
namespace probes_outdoors_test {

struct Street {
    GltfBuilder builder;

    int material(const std::array<float, 3>& color, float metallic, float roughness) {
        return builder.append("materials", {{"pbrMetallicRoughness",
                                             {{"baseColorFactor", {color[0], color[1], color[2], 1}},
                                              {"metallicFactor", metallic},
                                              {"roughnessFactor", roughness}}}});
    }

    void box(const std::array<float, 3>& low, const std::array<float, 3>& high, int material) {
        std::vector<float> positions, normals;
        std::vector<uint16_t> indices;
        for (size_t axis = 0; axis < 3; ++axis)
            for (const bool far : {false, true}) {
                const auto first = static_cast<uint16_t>(positions.size() / 3);
                for (const auto& [a, b] : {std::pair(false, false), {true, false}, {true, true}, {false, true}}) {
                    std::array<float, 3> corner = {};
                    corner[axis] = far ? high[axis] : low[axis];
                    corner[(axis + 1) % 3] = (a ? high : low)[(axis + 1) % 3];
                    corner[(axis + 2) % 3] = (b ? high : low)[(axis + 2) % 3];
                    positions.insert(positions.end(), corner.begin(), corner.end());
                    for (size_t i = 0; i < 3; ++i)
                        normals.push_back(i != axis ? 0.0f : far ? 1.0f : -1.0f);
                }
                for (const int corner : {0, 1, 2, 0, 2, 3})
                    indices.push_back(static_cast<uint16_t>(first + (far || corner == 0 ? corner : 4 - corner)));
            }
        const int position = builder.addAccessor("VEC3", positions);
        const int normal = builder.addAccessor("VEC3", normals);
        const int faces = builder.addAccessor("SCALAR", indices);
        const int mesh = builder.append("meshes", {{"primitives",
                                                    {{{"attributes", {{"POSITION", position}, {"NORMAL", normal}}},
                                                      {"indices", faces},
                                                      {"material", material}}}}});
        builder.append("nodes", {{"mesh", mesh}});
    }

    std::string write(const std::string& path) {
        Json nodes = Json::array();
        for (size_t i = 0; i < builder.json["nodes"].size(); ++i)
            nodes.push_back(i);
        builder.json["scenes"] = {{{"nodes", nodes}}};
        const std::vector<uint8_t> bytes = builder.glb();
        EXPECT_TRUE(writeFile(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()}));
        return path;
    }
};

std::string writeStreet(const std::string& path) {
    Street street;
    const int wet = street.material({0.9f, 0.9f, 0.9f}, 1, 0.02f);
    const int asphalt = street.material({0.12f, 0.12f, 0.13f}, 0, 0.9f);
    const int trunk = street.material({0.1f, 0.1f, 0.1f}, 0, 0.5f);
    const int leaves = street.material({0.04f, 0.3f, 0.03f}, 0, 0.7f); // the only green of the scene
    const std::array walls = {
        street.material({0.5f, 0.2f, 0.15f}, 0, 0.8f), street.material({0.55f, 0.5f, 0.4f}, 0, 0.8f),
        street.material({0.35f, 0.33f, 0.4f}, 0, 0.8f), street.material({0.6f, 0.5f, 0.5f}, 0, 0.8f)};
    street.box({-40, -0.1f, -60}, {40, 0, 60}, asphalt);
    street.box({-3, -0.05f, 4}, {3.4f, 0.004f, 10.5f}, wet);
    constexpr std::array kHeights = {7.0f, 10.0f, 6.0f, 12.0f, 8.0f};
    for (int k = 0; k < 9; ++k) {
        const float z = -50 + 10 * static_cast<float>(k);
        const size_t house = static_cast<size_t>(k);
        street.box({-15, 0, z}, {-7, kHeights[house % 5], z + 9.5f}, walls[house % 4]);
        street.box({7, 0, z - 3}, {15, kHeights[(house + 2) % 5], z + 7}, walls[(house + 1) % 4]);
    }
    for (const auto& [x, z] : {std::pair(4.0f, 3.0f), {-4.2f, -3.0f}, {4.0f, -9.0f}, {-4.0f, -16.0f}}) {
        street.box({x - 0.12f, 0, z - 0.12f}, {x + 0.12f, 2.7f, z + 0.12f}, trunk);
        street.box({x - 1.4f, 2.6f, z - 1.3f}, {x + 1.3f, 4.6f, z + 1.4f}, leaves);
        street.box({x - 0.8f, 4.6f, z - 0.8f}, {x + 0.7f, 5.6f, z + 0.8f}, leaves);
    }
    return street.write(path);
}

bool isGreen(const uint8_t* rgb) {
    return rgb[1] - std::max(rgb[0], rgb[2]) > 8;
}

/// Against the reference, over smooth surfaces, in bytes.
struct Errors {
    double mean = 0;
    double percentile95 = 0;
    size_t falseGreen = 0; ///< pixels that are green only here
    size_t pixels = 0;
};

class OutdoorProbesTest : public JobTest {};

TEST_F(OutdoorProbesTest, aStreetUnderTheSkyIsNoWorseWithProbes) {
    const TempFolder folder;
    render::RenderJob job;
    job.scene = writeStreet(folder + "street.glb");
    job.camera = folder + "camera.json";
    ASSERT_TRUE(writeFile(job.camera, R"({"position": [0.5, 1.7, 12], "target": [-0.4, -0.2, 4], "fovY": 50})"));
    job.width = 240;
    job.height = 135;
    job.display = true;
    job.views = {"composite", "roughness"};
    bakeProbes(device(), job, folder);
    render::ReflectionSession session = must(render::openJob(device(), job));
    const auto draw = [&](const render::ProgramSettings& settings) {
        must(session.setSettings(settings));
        must(session.renderFrame(0));
        return must(session.readView("composite")).rgb8;
    };
    const std::vector<uint8_t> reference = draw(referenceOf(job.settings, 16));
    const std::vector<float> roughness = must(session.readView("roughness")).rgba;
    const auto errorsOf = [&](const std::string& name, unsigned sources) {
        render::ProgramSettings settings = job.settings;
        choose(settings, sources);
        const std::vector<uint8_t> image = draw(settings);
        Errors out;
        std::vector<double> differences;
        for (size_t i = 0; i < image.size(); i += 3) {
            if (roughness[i / 3 * 4] == 0 || roughness[i / 3 * 4] > 0.25f)
                continue;
            double sum = 0;
            for (size_t c = i; c < i + 3; ++c)
                sum += std::abs(int(image[c]) - int(reference[c]));
            differences.push_back(sum / 3);
            out.mean += sum / 3;
            out.falseGreen += isGreen(&image[i]) && !isGreen(&reference[i]) ? 1 : 0;
        }
        out.pixels = differences.size();
        out.mean /= static_cast<double>(out.pixels);
        std::ranges::sort(differences);
        out.percentile95 = differences.empty() ? 0 : differences[differences.size() * 95 / 100];
        RecordProperty(name + " mean", std::to_string(out.mean));
        RecordProperty(name + " 95th percentile", std::to_string(out.percentile95));
        RecordProperty(name + " false green", static_cast<int>(out.falseGreen));
        return out;
    };
    const Errors sky = errorsOf("sky", kSky);
    const Errors probes = errorsOf("probes, sky", kProbes | kSky);
    const Errors screen = errorsOf("screen, sky", kScreen | kSky);
    const Errors all = errorsOf("screen, probes, sky", kScreen | kProbes | kSky);
    ASSERT_GT(sky.pixels, 5000u);
    EXPECT_LE(probes.mean, sky.mean);
    EXPECT_LE(probes.percentile95, sky.percentile95);
    EXPECT_LE(all.mean, screen.mean);
    EXPECT_LE(all.percentile95, screen.percentile95);
    // Leaves are drawn in their place: texels of their outline may be seen, streaks may not.
    EXPECT_LT(static_cast<double>(probes.falseGreen), 0.02 * static_cast<double>(probes.pixels));
}

} // namespace probes_outdoors_test
} // namespace glint::test
