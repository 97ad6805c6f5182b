// Surfaces of more than one lobe on whole scenes: KHR_materials_specular and KHR_materials_clearcoat, by every source.
#include "base/file.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/tests/image/job_test.hpp"
#include "lab/tests/support/gltf_builder.hpp"
#include "tests/support/temp_folder.hpp"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace lobes_test {

/// A glTF scene of rectangles, each with a material of its own.
class Rectangles {
public:
    Rectangles() {
        builder_.json["extensionsUsed"] = {"KHR_materials_specular", "KHR_materials_clearcoat",
                                           "KHR_materials_emissive_strength"};
    }

    void add(const glm::vec3& corner, const glm::vec3& u, const glm::vec3& v, const Json& material) {
        std::vector<float> positions, normals;
        const glm::vec3 normal = glm::normalize(glm::cross(u, v));
        for (const glm::vec3& at : {corner, corner + u, corner + u + v, corner + v}) {
            positions.insert(positions.end(), {at.x, at.y, at.z});
            normals.insert(normals.end(), {normal.x, normal.y, normal.z});
        }
        const Json attributes = {{"POSITION", builder_.addAccessor("VEC3", positions)},
                                 {"NORMAL", builder_.addAccessor("VEC3", normals)}};
        const int faces = builder_.addAccessor("SCALAR", std::vector<uint16_t>{0, 1, 2, 0, 2, 3});
        const int look = builder_.append("materials", material);
        const int mesh = builder_.append(
            "meshes", {{"primitives", {{{"attributes", attributes}, {"indices", faces}, {"material", look}}}}});
        nodes_.push_back(builder_.append("nodes", {{"mesh", mesh}}));
    }
    /// From `eye`, looking along -Z and down by `pitch` radians.
    void look(const glm::vec3& eye, float pitch) {
        builder_.append("cameras", {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.05}}}});
        nodes_.push_back(builder_.append("nodes", {{"camera", 0},
                                                   {"translation", {eye.x, eye.y, eye.z}},
                                                   {"rotation", {-std::sin(pitch / 2), 0, 0, std::cos(pitch / 2)}}}));
    }
    std::string write(const std::string& path) {
        builder_.json["scenes"] = {{{"nodes", nodes_}}};
        const std::vector<uint8_t> bytes = builder_.glb();
        EXPECT_TRUE(writeFile(path, std::string(bytes.begin(), bytes.end())));
        return path;
    }

private:
    GltfBuilder builder_;
    Json nodes_ = Json::array();
};

Json pbr(double metallic, double roughness, double color = 1) {
    return {
        {"baseColorFactor", {color, color, color, 1}}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}};
}

Json clearcoat(double strength, double roughness) {
    return {{"KHR_materials_clearcoat", {{"clearcoatFactor", strength}, {"clearcoatRoughnessFactor", roughness}}}};
}

class LobesTest : public JobTest {
protected:
    static const std::vector<float>& view(const render::RenderResult& result, const char* name) {
        const auto found = std::ranges::find(result.views, name, &render::RenderedView::name);
        EXPECT_NE(found, result.views.end()) << name;
        return found->rgba;
    }

    const TempFolder folder_;
};

// ---------------------------------------------------------------- a furnace of all kinds

constexpr float kEven = 0.5f; ///< radiance of the environment

class FurnaceTest : public LobesTest {
protected:
    /// White surfaces of every combination, side by side.
    render::RenderJob job(const std::vector<std::string>& assignments, uint32_t frames,
                          const std::vector<double>& metallics) const {
        Rectangles scene;
        constexpr double kFactor[] = {1, 0.5, 0.1};
        constexpr double kRoughness[] = {0, 0.3, 1};
        const Json kCoats[] = {Json::object(), clearcoat(1, 0), clearcoat(1, 0.6), clearcoat(0.5, 0.2)};
        int place = 0;
        for (const double metallic : metallics)
            for (const double factor : kFactor)
                for (const double roughness : kRoughness)
                    for (const Json& coat : kCoats) {
                        Json extensions = coat;
                        extensions["KHR_materials_specular"] = {{"specularFactor", factor}};
                        const glm::vec3 corner(-3 + 0.5f * float(place % 12), 0, -0.6f * float(place / 12));
                        scene.add(corner, {0.5f, 0, 0}, {0, 0, -0.6f},
                                  {{"pbrMetallicRoughness", pbr(metallic, roughness)}, {"extensions", extensions}});
                        ++place;
                    }
        scene.look({0, 1.2f, 3.4f}, 0.25f);
        const std::vector<float> even(size_t{16} * 8 * 3, kEven);
        const scene::ExrLayer layer = {.name = "", .channels = "RGB", .pixels = even, .stride = 3};
        must(scene::writeExr(folder_ + "even.exr", 16, 8, std::span(&layer, 1)));
        render::RenderJob job;
        job.scene = scene.write(folder_ + "kinds.glb");
        job.environment = folder_ + "even.exr";
        job.width = 180;
        job.height = 90;
        job.frames = frames;
        job.views = {"composite", "scene", "reflectivity"};
        job.settings = settingsOf(assignments);
        return job;
    }

    /// `most`: fraction of the light that may be lost.
    void expectEven(const std::vector<std::string>& assignments, uint32_t frames,
                    const std::vector<double>& metallics = {0, 1}, float most = 0.03f) {
        const render::RenderResult result = must(render::runJob(device(), job(assignments, frames, metallics)));
        const std::vector<float>& composite = view(result, "composite");
        const std::vector<float>& host = view(result, "scene");
        const std::vector<float>& f0 = view(result, "reflectivity");
        uint32_t surfaces = 0;
        for (size_t i = 0; i < composite.size(); i += 4) {
            if (f0[i] <= 0)
                continue;
            ++surfaces;
            ASSERT_GE(composite[i], (1 - most) * kEven) << "pixel " << i / 4 % 180 << ", " << i / 4 / 180;
            ASSERT_LE(composite[i], 1.01f * kEven) << "pixel " << i / 4 % 180 << ", " << i / 4 / 180;
            ASSERT_NEAR(composite[i], host[i], 0.01f * kEven) << "the host's own picture";
        }
        EXPECT_GT(surfaces, 1500u);
    }
};

TEST_F(FurnaceTest, TheSkyAlone) {
    expectEven({"screen.enabled=false"}, 1);
}
/// Between metal and dielectric the model's compensation for several scatterings is not linear: rough surfaces lose
/// light, in the host's picture and in Glint's alike.
TEST_F(FurnaceTest, HalfMetals) {
    expectEven({"screen.enabled=false"}, 1, {0.5}, 0.15f);
}
TEST_F(FurnaceTest, RaysAndTheDenoiser) {
    expectEven({"denoise.enabled=true", "rays.enabled=true", "rays.bounces=2", "reflect.maxRoughness=1",
                "reflect.roughnessFadeStart=1"},
               3);
}
TEST_F(FurnaceTest, RaysThatAddUp) {
    expectEven({"screen.enabled=false", "rays.enabled=true", "rays.accumulate=true", "rays.samples=2"}, 2);
}

// ---------------------------------------------------------------- coats before a panel

/// A floor of strips before a red panel, which is all that is lit: rough metal; the same under a smooth coat; the coat
/// alone; the coat, roughness 0.3, alone.
constexpr int kStrips = 4;
constexpr uint32_t kWidth = 160, kHeight = 100;

class CoatTest : public LobesTest {
protected:
    render::RenderJob job(const std::vector<std::string>& assignments, uint32_t frames) const {
        Rectangles scene;
        const Json paint = pbr(1, 0.7, 0.3);
        const Json black = {{"pbrMetallicRoughness", pbr(0, 0, 0)}};
        Json looks[kStrips] = {{{"pbrMetallicRoughness", paint}},
                               {{"pbrMetallicRoughness", paint}, {"extensions", clearcoat(1, 0)}},
                               black,
                               black};
        const Json none = {{"specularFactor", 0}};
        looks[2]["extensions"] = clearcoat(1, 0);
        looks[2]["extensions"]["KHR_materials_specular"] = none;
        looks[3]["extensions"] = clearcoat(1, 0.3);
        looks[3]["extensions"]["KHR_materials_specular"] = none;
        for (int strip = 0; strip < kStrips; ++strip)
            scene.add({-2 + float(strip), 0, 2}, {1, 0, 0}, {0, 0, -4}, looks[strip]);
        scene.add(
            {-8, 0, -2}, {16, 0, 0}, {0, 3, 0},
            {{"pbrMetallicRoughness", pbr(0, 1, 0)},
             {"emissiveFactor", {1, 0, 0}},
             {"extensions",
              {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4}}}, {"KHR_materials_specular", none}}}});
        scene.look({0, 1.4f, 3.2f}, 0.35f);
        render::RenderJob job;
        job.scene = scene.write(folder_ + "coats.glb");
        job.environment = "none";
        job.width = kWidth;
        job.height = kHeight;
        job.frames = frames;
        job.views = {"composite"};
        job.planar = render::MirrorSearch::Auto;
        job.settings = settingsOf(assignments);
        return job;
    }

    /// Means of red over the middles of the strips in a row of the floor that shows the panel.
    static std::array<double, kStrips> strips(const render::RenderResult& result) {
        const std::vector<float>& picture = view(result, "composite");
        std::array<double, kStrips> sums = {};
        constexpr uint32_t kRow = 62;
        // Where the row's floor lies: the camera looks down by 0.35, the field of view is 0.8 high.
        const double down = std::tan(0.4) * (1 - 2 * (kRow + 0.5) / kHeight);
        const glm::dvec3 ray =
            glm::dvec3(0, std::cos(0.35) * down - std::sin(0.35), -std::sin(0.35) * down - std::cos(0.35));
        const double metres = 1.4 / -ray.y; // along a ray with a view depth of 1
        const double pixelsPerMetre = kHeight / (2 * std::tan(0.4) * metres);
        for (int strip = 0; strip < kStrips; ++strip) {
            const auto middle = static_cast<int>(kWidth / 2.0 + (strip - 1.5) * pixelsPerMetre);
            for (int x = middle - 2; x <= middle + 2; ++x)
                sums[static_cast<size_t>(strip)] += picture[4 * (kRow * kWidth + static_cast<size_t>(x))] / 5;
        }
        return sums;
    }

    void expectCoats(const std::vector<std::string>& assignments, uint32_t frames) {
        const std::array<double, kStrips> shown = strips(must(render::runJob(device(), job(assignments, frames))));
        // The row is seen at a cosine of about 0.4.
        const double cosine = cosineOfRow();
        const double reflectance = 0.04 + 0.96 * std::pow(1 - cosine, 5);
        EXPECT_NEAR(shown[2], 4 * reflectance, 0.06 * 4 * reflectance) << "the coat alone";
        EXPECT_NEAR(shown[1], shown[2] + (1 - reflectance) * shown[0], 0.08 * shown[1]) << "over what is below it";
        EXPECT_GT(shown[3], 0.5 * shown[2]) << "a rough coat shows the panel too";
        EXPECT_LT(shown[3], 1.3 * shown[2]);
    }

    static double cosineOfRow() {
        const double down = std::tan(0.4) * (1 - 2 * 62.5 / kHeight);
        const double y = std::cos(0.35) * down - std::sin(0.35);
        return -y / std::sqrt(1 + down * down);
    }
};

TEST_F(CoatTest, TheScreen) {
    expectCoats({"reflect.maxRoughness=1", "reflect.roughnessFadeStart=1"}, 1);
}
TEST_F(CoatTest, Rays) {
    expectCoats(
        {"screen.enabled=false", "rays.enabled=true", "rays.maxRoughness=1", "rays.accumulate=true", "rays.samples=8"},
        4);
}
TEST_F(CoatTest, PlanarMirrors) {
    // The paint, which alone would be no mirror, has no answer below the coat either.
    expectCoats({"screen.enabled=false", "planar.maxRoughness=0.5", "planar.roughnessFadeStart=0.5"}, 1);
}
TEST_F(CoatTest, ScreenAndRaysWithTheDenoiser) {
    expectCoats({"denoise.enabled=true", "rays.enabled=true", "reflect.maxRoughness=1", "reflect.roughnessFadeStart=1",
                 "rays.maxRoughness=1"},
                8);
}

TEST_F(CoatTest, ScenesWithoutCoatsHaveNoPassesForThem) {
    Rectangles scene;
    scene.add({-2, 0, 2}, {4, 0, 0}, {0, 0, -4}, {{"pbrMetallicRoughness", pbr(1, 0.1)}});
    scene.look({0, 1.4f, 3.2f}, 0.35f);
    render::RenderJob plain = job({}, 1);
    const auto decides = [&] {
        const render::RenderResult result = must(render::runJob(device(), plain));
        return std::ranges::any_of(result.stats.plan, [](const FrameDecision& decision) {
            return std::string_view(decision.name) == "coat" && decision.value;
        });
    };
    plain.width = plain.height = 16;
    plain.planar = render::MirrorSearch::None;
    plain.passTimes = false;
    EXPECT_TRUE(decides());
    plain.scene = scene.write(folder_ + "plain.glb");
    EXPECT_FALSE(decides());
}

} // namespace lobes_test
} // namespace glint::test
