// Material overrides on whole scenes: what they say is seen, by every part of a frame that reads a material.
#include "base/file.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/tests/image/job_test.hpp"
#include "tests/support/temp_folder.hpp"

#include <algorithm>
#include <cmath>

namespace glint::test {
namespace materials_test {

class MaterialsTest : public JobTest {
protected:
    /// The composite with these overrides: the content of "materials".
    std::vector<float> show(const std::string& scene, const std::string& materials,
                            render::MirrorSearch planar = render::MirrorSearch::None,
                            const std::vector<std::string>& assignments = {}) {
        render::RenderJob job;
        job.scene = scene;
        job.width = 160;
        job.height = 90;
        job.views = {"composite"};
        job.planar = planar;
        job.settings = settingsOf(assignments);
        job.materials = "none";
        if (!materials.empty()) {
            job.materials = temp_ + "materials.json";
            must(writeFile(job.materials, "{\"materials\": {" + materials + "}}"));
        }
        return must(render::runJob(device(), job)).views.front().rgba;
    }
    static double largestDifference(const std::vector<float>& a, const std::vector<float>& b) {
        double largest = 0;
        for (size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, std::abs(double(a[i]) - double(b[i])));
        return largest;
    }
    static size_t changedPixels(const std::vector<float>& a, const std::vector<float>& b) {
        size_t changed = 0;
        for (size_t i = 0; i < a.size(); i += 4)
            changed += a[i] != b[i] || a[i + 1] != b[i + 1] || a[i + 2] != b[i + 2];
        return changed;
    }

    TempFolder temp_;
};

TEST_F(MaterialsTest, AStandardMaterialReflectsItsSpecularColourSharply) {
    const std::string scene = "builtin:mirror"; // its floor is a perfect mirror already
    const std::vector<float> file = show(scene, "");
    const std::string rough = R"("floor mirror": {"metallic": 0, "roughness": 0.8})";
    EXPECT_GT(changedPixels(file, show(scene, rough)), 500u);
    EXPECT_LE(largestDifference(file, show(scene, R"("floor mirror": {"kind": "standard"})")), 1e-3)
        << "(1, 1, 1): a mirror";
    // Black: what a Standard material does not reflect, it scatters.
    const std::vector<float> tinted = show(
        scene, R"("floor mirror": {"kind": "standard", "specularColor": [0.8, 0.4, 0.2], "baseColor": [0, 0, 0]})");
    EXPECT_LE(largestDifference(tinted, show(scene, R"("floor mirror": {"baseColor": [0.8, 0.4, 0.2]})")), 1e-3)
        << "a metal of that F0 without roughness";
    EXPECT_GT(changedPixels(file, tinted), 500u);
}

TEST_F(MaterialsTest, AStandardMaterialsTextureColoursTheReflectionWhateverItsAlpha) {
    const std::vector<uint8_t> texel = {188, 128, 64, 30};
    must(scene::writePng(temp_ + "specular.png", 1, 1, 4, texel));
    const std::vector<float> standard = show(
        "builtin:mirror", R"("floor mirror": {"kind": "standard", "textures": {"specularColor": "specular.png"}})");
    const std::vector<float> metal =
        show("builtin:mirror", R"("floor mirror": {"textures": {"baseColor": "specular.png"}})");
    EXPECT_LE(largestDifference(standard, metal), 1e-3);
    EXPECT_GT(changedPixels(standard, show("builtin:mirror", "")), 500u);
}

TEST_F(MaterialsTest, ABodyHasTheShapeThatIsSaid) {
    const std::vector<float> file = show("builtin:glass", "");
    EXPECT_EQ(file, show("builtin:glass", R"("ior 1.5": {"refraction": "sphere"})")) << "the ball's own";
    // A ball covers 60 pixels or so of this small picture.
    for (const char* shape : {"plane", "thin", "none"}) {
        const size_t changed =
            changedPixels(file, show("builtin:glass", fmt::format(R"("ior 1.5": {{"refraction": "{}"}})", shape)));
        EXPECT_GT(changed, 20u) << shape;
        EXPECT_LT(changed, 300u) << shape;
    }
}

TEST_F(MaterialsTest, APlanarMarkMakesAMirrorOrForbidsIt) {
    using render::MirrorSearch;
    const std::vector<std::string> planarAlone = {"screen.enabled=false"};
    const auto shown = [&](const std::string& materials, MirrorSearch search) {
        return show("builtin:mirror", materials, search, planarAlone);
    };
    const std::vector<float> without = shown("", MirrorSearch::None);
    const std::vector<float> found = shown("", MirrorSearch::Auto);
    EXPECT_GT(changedPixels(without, found), 200u);
    EXPECT_EQ(shown("", MirrorSearch::Named), without) << "the scene names none";
    EXPECT_EQ(shown(R"("floor mirror": {"planar": true})", MirrorSearch::Named), found);
    EXPECT_EQ(shown(R"("floor mirror": {"planar": false})", MirrorSearch::Auto), without);
}

} // namespace materials_test
} // namespace glint::test
