// The plan of a gallery, read with every value checked, and the page while its pictures are being rendered.
#include "lab/cli/plan_place.hpp"
#include "lab/cli/report/gallery_plan.hpp"
#include "lab/cli/report/gallery_run.hpp"
#include "lab/cli/report/report_json.hpp"
#include "lab/cli/report/report_page.hpp"

#include "lab/tests/unit/report_fixture.hpp"
#include "tests/support/must.hpp"

#include <gtest/gtest.h>

#include <functional>

namespace glint::cli {
namespace {

PlanJson madeUpPlan() {
    return PlanJson::parse(R"({
        "description": "made up", "size": "1920x1080", "softwareSize": "64x36", "settle": 0.5,
        "pictures": [{"name": "none", "scene": "builtin:exact", "config": "screen.enabled=false"},
                     {"name": "rays_2", "title": "rays & more", "scene": "builtin:exact", "planar": "auto",
                      "view": "outcome", "config": "ray-query"}]
    })");
}

std::string errorOf(const std::function<void(PlanJson&)>& change) {
    PlanJson json = madeUpPlan();
    change(json);
    const auto plan = readGalleryPlan(json.dump(), "plan.json");
    return plan ? "" : plan.error().message;
}

gpu::DeviceInfo device(bool software) {
    gpu::DeviceInfo info;
    info.name = "device";
    info.software = software;
    return info;
}

Gallery madeUpGallery() {
    const GalleryPlan plan = test::must(readGalleryPlan(madeUpPlan().dump(), "plan.json"));
    return test::must(planGallery(plan, device(true), "", {})).gallery;
}

TEST(Gallery, PicturesAreJobs) {
    const GalleryPlan plan = test::must(readGalleryPlan(madeUpPlan().dump(), "plan.json"));
    const GalleryWork work = test::must(planGallery(plan, device(false), "", {}));
    ASSERT_EQ(work.jobs.size(), 2u);
    EXPECT_EQ(work.jobs[0].width, 1920u);
    EXPECT_FALSE(work.jobs[0].settings.reflections.screen.enabled);
    EXPECT_EQ(work.jobs[1].settle, 0.5);
    EXPECT_EQ(work.jobs[1].planar, render::MirrorSearch::Auto);
    EXPECT_EQ(work.jobs[1].views, std::vector<std::string>{"outcome"});
    EXPECT_EQ(work.gallery.pictures[0].title, "none");
    EXPECT_EQ(work.gallery.pictures[1].command,
              "glint render builtin:exact --size 1920x1080 --planar auto --preset ray-query --view outcome "
              "--settle 0.5 -o rays_2.png");
}

TEST(Gallery, SizesFitTheDevice) {
    const GalleryPlan plan = test::must(readGalleryPlan(madeUpPlan().dump(), "plan.json"));
    EXPECT_EQ(test::must(planGallery(plan, device(true), "", {})).jobs[0].height, 36u);
    EXPECT_EQ(test::must(planGallery(plan, device(true), "8x4", {})).jobs[0].height, 4u);
}

TEST(Gallery, ErrorsSayWhere) {
    EXPECT_EQ(errorOf([](PlanJson&) {}), "");
    EXPECT_EQ(errorOf([](PlanJson& json) { json.erase("pictures"); }), "plan.json: it has no \"pictures\"");
    EXPECT_EQ(errorOf([](PlanJson& json) { json["pictures"][1].erase("scene"); }),
              "plan.json: pictures[1]: it has no \"scene\"");
    EXPECT_EQ(errorOf([](PlanJson& json) { json["pictures"][1]["name"] = "../none"; }),
              "plan.json: pictures[1].name: expected letters, digits, - and _, at most 60");
    EXPECT_EQ(errorOf([](PlanJson& json) { json["pictures"][1]["name"] = "none"; }),
              "plan.json: pictures[1]: the name 'none' is there twice");
    EXPECT_NE(errorOf([](PlanJson& json) { json["pictures"][0]["scen"] = "a"; }).find("did you mean 'scene'?"),
              std::string::npos);
    EXPECT_NE(errorOf([](PlanJson& json) { json["pictures"][0]["config"] = "slow"; }).find("pictures[0].config:"),
              std::string::npos);
    EXPECT_NE(errorOf([](PlanJson& json) { json["softwareSize"] = "0x0"; }).find("softwareSize:"), std::string::npos);
    EXPECT_NE(errorOf([](PlanJson& json) { json["settle"] = -1; }).find("settle:"), std::string::npos);
}

TEST(Gallery, ThePageHasAPlaceForEveryPicture) {
    Report report;
    report.gallery = madeUpGallery();
    report.gallery->pictures[0].rendered = RenderedPicture{.width = 64, .height = 36, .frames = 3, .stats = {}};
    const std::string page = test::must(reportPage(report));
    EXPECT_NE(page.find("<title>Glint: scenes without and with reflections</title>"), page.npos);
    const std::string_view begin = "id=\"data\">";
    const size_t from = page.find(begin) + begin.size();
    const PlanJson data = PlanJson::parse(page.substr(from, page.find("</script", from) - from));
    EXPECT_EQ(data["device"]["name"], "device");
    EXPECT_EQ(data["gallery"]["complete"], false);
    EXPECT_EQ(data["gallery"]["pictures"][0]["frames"], 3);
    EXPECT_FALSE(data["gallery"]["pictures"][1].contains("width"));
    EXPECT_EQ(data["gallery"]["pictures"][1]["title"], "rays & more");
    EXPECT_TRUE(data["scenes"].empty());
}

TEST(Gallery, MeasurementsFollowOnTheSamePage) {
    Report report;
    report.gallery = madeUpGallery();
    report.gallery->complete = true;
    report.scenes.push_back(test::madeUpScene("scene"));
    const PlanJson json = reportJson(report);
    EXPECT_EQ(json["gallery"]["complete"], true);
    EXPECT_EQ(json["scenes"].size(), 1u);
}

} // namespace
} // namespace glint::cli
