// Parts of a host's lists for rays that are replaced alone: the same picture as with whole lists.
#include "gpu/support/library_test.hpp"
#include "gpu/support/surface_scene.hpp"

#include <gmock/gmock.h>

namespace glint::test {
namespace surface_table_test {

using testing::HasSubstr;

constexpr uint32_t kWidth = 48;
constexpr uint32_t kHeight = 30;

class SurfaceTableTest : public LibraryTest {
protected:
    void SetUp() override {
        LibraryTest::SetUp();
        scene_.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0));
        scene_.addQuad({-2, 0, -2}, {2, 0, 0}, {0, 2, 0}, emitting({1, 0.5f, 0.25f}));
        scene_.addQuad({0, 0, -2}, {2, 0, 0}, {0, 2, 0}, emitting({0.25f, 0.5f, 1}));
        host_ = SyntheticGBuffer::render(gpu(), SurfaceScene::seenBy(scene_), camera_, kWidth, kHeight);
        Settings settings = plainSettings();
        settings.screen.enabled = false;
        settings.rays.enabled = true;
        settings.rays.backend = RayBackend::Bvh;
        reflections_.emplace(reflections(kWidth, kHeight, settings));
        must(reflections_->setInputs(host_.gbuffer));
        for (size_t i = 0; i < scene_.triangles.instances.size(); ++i)
            instances_.push_back({scene_.triangles.instances[i].mesh, static_cast<uint32_t>(i),
                                  scene_.triangles.instances[i].localToWorld});
    }
    SurfaceScene::World world() const { return scene_.build(gpu(), library(), RayBackend::Bvh); }
    std::vector<float> picture(SurfaceScene::World& world) {
        must(reflections_->setRays(world.rays, world.surfaces));
        HostImage image;
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
            image = reflections_->record(commands, camera_.view(kWidth, kHeight));
        });
        return download(gpu(), image);
    }

    SurfaceScene scene_;
    SyntheticCamera camera_ = {.position = {0, 1, 4}, .target = {0, 0.3, 0}};
    SyntheticGBuffer host_;
    std::optional<Reflections> reflections_;
    std::vector<SurfaceInstance> instances_;
};

TEST_F(SurfaceTableTest, PartsAreReplacedAsTheWhole) {
    SurfaceScene::World parts = world(), whole = world();
    const std::vector<float> before = picture(parts);
    EXPECT_EQ(picture(whole), before);

    scene_.materials[2] = emitting({0, 2, 0});
    must(parts.surfaces.updateMaterials(2, std::span(scene_.materials).subspan(2)));
    must(whole.surfaces.setMaterials(scene_.materials));
    const std::vector<float> green = picture(parts);
    EXPECT_EQ(green, picture(whole));
    EXPECT_NE(green, before);

    std::vector<RayInstance>& rays = scene_.triangles.instances;
    rays[1].localToWorld[13] = instances_[1].localToWorld[13] = 0.5f; // half a metre up
    rays[1].mask = 0xff;
    instances_[1].material = 2;
    must(parts.rays.updateInstances(1, std::span(rays).subspan(1, 1)));
    must(parts.surfaces.updateInstances(1, std::span(instances_).subspan(1, 1)));
    must(whole.rays.setInstances(rays));
    must(whole.surfaces.setInstances(instances_));
    const std::vector<float> moved = picture(parts);
    EXPECT_EQ(moved, picture(whole));
    EXPECT_NE(moved, green);
}

TEST_F(SurfaceTableTest, PartsBeyondTheListAreErrors) {
    SurfaceScene::World made = world();
    EXPECT_THAT(made.surfaces.updateMaterials(2, std::span(scene_.materials).first(2)).error().message,
                HasSubstr("surface materials 2 to 4 are updated, the table has 3"));
    EXPECT_THAT(made.surfaces.updateInstances(3, std::span(instances_).first(1)).error().message,
                HasSubstr("surface instances 3 to 4 are updated, the table has 3"));
    instances_[1].material = 3;
    EXPECT_THAT(made.surfaces.updateInstances(1, std::span(instances_).subspan(1, 1)).error().message,
                HasSubstr("surface instance 1 has mesh 1 of 3 and material 3 of 3"));
    EXPECT_TRUE(made.surfaces.updateInstances(3, {}));
}

} // namespace surface_table_test
} // namespace glint::test
