// glint trace: a G-buffer that our own renderer wrote to a file gives the reflections that the renderer had, and each
// wrong declaration of what the file means is found by its name.
#include "lab/scene/images/image_file.hpp"
#include "lab/session/run_job.hpp"
#include "lab/session/trace_job.hpp"
#include "tests/gpu/support/gpu_test.hpp"
#include "tests/support/temp_folder.hpp"

#include "base/file.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace glint::test {
namespace trace_test {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr const char* kViews[] = {"composite", "scene",     "fallbackSpecular", "depth",
                                  "normal",    "roughness", "reflectivity",     "albedo"};

class TraceTest : public GpuTest {
protected:
    /// Highlights stay in hits, as a file does not separate them, and it has no back faces.
    static render::RenderJob drawnJob(const std::string& scene, const std::string& camera = "") {
        render::RenderJob job;
        job.scene = scene;
        job.camera = camera;
        job.environment = "none";
        job.width = 240;
        job.height = 136;
        job.views.assign(std::begin(kViews), std::end(kViews));
        job.settings.reflections.screen.highlights = true;
        job.settings.reflections.screen.thicknessMode = ThicknessMode::Constant;
        job.settings.reflections.screen.thickness = 0.1f;
        // Sharp and without a history: every ray is compared.
        job.settings.reflections.denoise.enabled = false;
        job.settings.reflections.reflect.roughnessFadeStart = 0.2f;
        job.settings.reflections.reflect.maxRoughness = 0.4f;
        job.statistics = true;
        return job;
    }

    /// Draws a frame of our renderer and writes its G-buffer and camera.
    void write(const std::string& scene, const std::string& camera = "", const std::string& environment = "none") {
        render::RenderJob job = drawnJob(scene, camera);
        job.environment = environment;
        drawn_ = must(render::runJob(gpu(), job));
        writeFiles(must(render::loadJobInputs(job)).camera, gbuffer_, camera_);
    }

    /// Writes `drawn_` as layers of floats, and the camera that drew it.
    void writeFiles(const scene::Camera& camera, const std::string& gbuffer, const std::string& cameraFile,
                    std::vector<scene::ExrLayer> layers = {}) const {
        for (const render::RenderedView& view : drawn_.views) {
            const std::string channels = view.name == "depth" || view.name == "roughness" ? "Z"
                                         : view.name == "normal"                          ? "XYZ"
                                                                                          : "RGB";
            layers.push_back({"Frame." + view.name, channels, false, view.rgba});
        }
        must(scene::writeExr(gbuffer, drawn_.width, drawn_.height, layers));
        const glm::vec3 p(camera.viewToWorld[3]), t = p - glm::vec3(camera.viewToWorld[2]);
        must(writeFile(cameraFile, fmt::format(R"({{"position":[{},{},{}],"target":[{},{},{}],"fovY":{},"near":{}}})",
                                               p.x, p.y, p.z, t.x, t.y, t.z, glm::degrees(camera.fovY), camera.near)));
    }

    render::TraceJob traceJob() const {
        render::TraceJob job;
        job.picture = drawnJob(gbuffer_);
        job.picture.camera = camera_;
        job.mapping = "glint";
        return job;
    }

    render::RenderResult trace(const render::TraceJob& job, const render::TraceInputs& inputs) {
        const auto ignore = [](size_t, const render::TraceInputs&, const render::RenderResult&) {
            return Result<void>();
        };
        return must(render::runTraces(gpu(), {&job, 1}, inputs, ignore));
    }

    const std::vector<float>& drawnView(std::string_view name) const {
        return std::ranges::find(drawn_.views, name, &render::RenderedView::name)->rgba;
    }

    const TempFolder temp_;
    const std::string gbuffer_ = temp_ + "frame.exr", camera_ = temp_ + "camera.json";
    render::RenderResult drawn_;
};

/// Pixels that differ by more than 5 %.
size_t differing(const std::vector<float>& tested, const std::vector<float>& expected) {
    size_t differ = 0;
    for (size_t i = 0; i < expected.size(); i += 4) {
        float error = 0;
        for (size_t c = 0; c < 3; ++c)
            error = std::max(error, std::abs(tested[i + c] - expected[i + c]) / (0.1f + expected[i + c]));
        differ += error > 0.05f;
    }
    return differ;
}

TEST_F(TraceTest, AFileGivesTheReflectionsOfTheFrameThatWroteIt) {
    for (const char* scene : {"builtin:exact", "builtin:mirror", "builtin:motion-still"}) {
        write(scene);
        const render::TraceInputs inputs = must(render::loadTraceInputs(traceJob()));
        EXPECT_THAT(inputs.health.findings, IsEmpty()) << scene;
        EXPECT_GT(inputs.health.normalsAgree, 0.8) << scene;
        const render::RenderResult traced = trace(traceJob(), inputs);
        EXPECT_NEAR(double(traced.stats.rays), double(drawn_.stats.rays), 0.002 * double(drawn_.stats.rays));
        const std::vector<float>& expected = drawnView("composite");
        const std::vector<float>& lit = drawnView("scene");
        const std::vector<float>& composite = traced.views.front().rgba;
        ASSERT_EQ(composite.size(), expected.size());
        // The file keeps normals to 16 bits and depth to 24: few rays take another path.
        size_t reflective = 0;
        for (size_t i = 0; i < expected.size(); i += 4)
            reflective += std::abs(expected[i] - lit[i]) + std::abs(expected[i + 1] - lit[i + 1]) > 0.01f;
        EXPECT_GT(reflective, 1000u) << scene;
        EXPECT_LT(double(differing(composite, expected)), 0.02 * double(reflective)) << scene;
    }
}

/// The environment is in the lit picture already: what reflections replace comes off it.
TEST_F(TraceTest, AnEnvironmentIsReflectedOnce) {
    write("builtin:exact", "", "sky");
    render::TraceJob job = traceJob();
    job.picture.environment = "sky";
    const std::vector<float>& expected = drawnView("composite");
    const std::vector<float>& fallback = drawnView("fallbackSpecular");
    size_t reflective = 0;
    for (size_t i = 0; i < fallback.size(); i += 4)
        reflective += fallback[i + 2] > 0.05f;
    EXPECT_GT(reflective, 1000u);
    const render::TraceInputs inputs = must(render::loadTraceInputs(job));
    EXPECT_LT(double(differing(trace(job, inputs).views.front().rgba, expected)), 0.02 * double(reflective));
    job.mapping = temp_ + "without.json";
    std::string text(must(scene::mappingPresetText("glint")));
    const std::string line = R"("fallbackSpecular": "fallbackSpecular",)";
    must(writeFile(job.mapping, text.erase(text.find(line), line.size())));
    const render::TraceInputs without = must(render::loadTraceInputs(job));
    EXPECT_GT(double(differing(trace(job, without).views.front().rgba, expected)), 0.5 * double(reflective));
}

TEST_F(TraceTest, WithoutSourcesThePictureIsThatOfTheFile) {
    write("builtin:exact");
    render::TraceJob job = traceJob();
    job.picture.settings.reflections.screen.enabled = false;
    job.picture.settings.reflections.sky.enabled = false;
    const render::TraceInputs inputs = must(render::loadTraceInputs(job));
    const render::RenderResult traced = trace(job, inputs);
    const std::vector<float>& lit = drawnView("scene");
    for (size_t i = 0; i < lit.size(); ++i) {
        if (i % 4 != 3) {
            ASSERT_EQ(traced.views.front().rgba[i], lit[i]) << i;
        }
    }
}

TEST_F(TraceTest, TheSkyFillsWhatTheScreenDoesNotShow) {
    write("builtin:exact");
    render::TraceJob job = traceJob();
    job.picture.environment = "sky";
    job.picture.views = {"composite", "weights"};
    const render::TraceInputs inputs = must(render::loadTraceInputs(job));
    const render::RenderResult traced = trace(job, inputs);
    size_t bySky = 0;
    for (size_t i = 1; i < traced.views[1].rgba.size(); i += 4)
        bySky += traced.views[1].rgba[i] > 0.5f;
    EXPECT_GT(bySky, 100u);
}

/// A mistake in a mapping or a camera file, and what must be said of it.
struct Mistake {
    const char* name;
    void (*make)(scene::GBufferLayers& layers, scene::GBufferMapping& mapping, scene::Camera& camera);
    const char* finding;
};

using scene::StoredAxes;
using scene::StoredDepth;
using scene::StoredSpace;
using Layers = scene::GBufferLayers;
using Mapping = scene::GBufferMapping;
using scene::Camera;

void toViewSpace(Layers& layers, const Camera& camera) {
    for (glm::vec3& normal : layers.normal)
        normal = glm::transpose(glm::mat3(camera.viewToWorld)) * normal;
}

const Mistake kMistakes[] = {
    {"view normals declared world", [](Layers& l, Mapping&, Camera& c) { toViewSpace(l, c); },
     "normal.space view, not world as declared"},
    {"world normals declared view", [](Layers&, Mapping& m, Camera&) { m.meaning.normalSpace = StoredSpace::View; },
     "normal.space world, not view as declared"},
    {"Z-up normals declared Y-up",
     [](Layers& l, Mapping&, Camera&) {
         for (glm::vec3& n : l.normal)
             n = {n.x, -n.z, n.y};
     },
     "axes zUp, not yUp as declared"},
    {"Y-up normals declared Z-up", [](Layers&, Mapping& m, Camera&) { m.meaning.axes = StoredAxes::ZUp; },
     "axes yUp, not zUp as declared"},
    {"unorm normals declared signed",
     [](Layers& l, Mapping&, Camera&) {
         for (glm::vec3& n : l.normal)
             n = n * 0.5f + 0.5f;
     },
     "normal.unorm true, not false as declared"},
    {"signed normals declared unorm", [](Layers&, Mapping& m, Camera&) { m.meaning.normalUnorm = true; },
     "normal.unorm false, not true as declared"},
    {"normals that point inward",
     [](Layers& l, Mapping&, Camera&) {
         for (glm::vec3& n : l.normal)
             n = -n;
     },
     "normal.inward true, not false as declared"},
    {"distance declared viewZ",
     [](Layers& l, Mapping&, Camera& c) {
         const scene::PixelLens lens(c, l.width, l.height);
         for (uint32_t i = 0; i < l.depth.size(); ++i)
             l.depth[i] *= glm::length(lens.positionVS(i % l.width, i / l.width, 1));
     },
     "depth.is distance, not viewZ as declared"},
    {"viewZ declared distance", [](Layers&, Mapping& m, Camera&) { m.meaning.depth = StoredDepth::Distance; },
     "depth.is viewZ, not distance as declared"},
    {"negative depth",
     [](Layers& l, Mapping&, Camera&) {
         for (float& z : l.depth)
             z = -z;
     },
     "depth.is negativeViewZ, not viewZ as declared"},
    {"reversed device depth declared viewZ",
     [](Layers& l, Mapping&, Camera& c) {
         for (float& z : l.depth)
             z = z > 0 ? c.near / z : 0;
     },
     "depth.is reversedDevice, not viewZ as declared"},
    {"rows from the bottom",
     [](Layers& l, Mapping&, Camera&) {
         for (uint32_t y = 0; y < l.height / 2; ++y)
             for (uint32_t x = 0; x < l.width; ++x) {
                 std::swap(l.depth[y * l.width + x], l.depth[(l.height - 1 - y) * l.width + x]);
                 std::swap(l.normal[y * l.width + x], l.normal[(l.height - 1 - y) * l.width + x]);
             }
     },
     "rowsFromBottom true, not false as declared"},
    {"centimetres declared metres",
     [](Layers& l, Mapping&, Camera& c) {
         for (float& z : l.depth)
             z *= 100;
         c.far = 200;
     },
     "correct \"metres\""},
    {"normals of back faces",
     [](Layers& l, Mapping&, Camera&) {
         for (size_t i = 0; i < l.normal.size(); i += 5)
             l.normal[i] = -l.normal[i];
     },
     "point away from the camera"},
    {"a camera that is turned",
     [](Layers&, Mapping&, Camera& c) {
         c.viewToWorld = scene::lookAt(glm::vec3(c.viewToWorld[3]),
                                       glm::vec3(c.viewToWorld[3] - c.viewToWorld[2] + 0.8f * c.viewToWorld[0]));
     },
     "agree with a camera that is turned by"},
    {"a field of view that is too wide", [](Layers&, Mapping&, Camera& c) { c.fovY *= 1.2f; },
     "depth and normals agree with a camera of about fovY "},
    {"a field of view that is much too wide", [](Layers&, Mapping&, Camera& c) { c.fovY *= 1.75f; },
     "depth and normals agree with a camera of about fovY "},
    {"a perspective picture declared orthographic",
     [](Layers&, Mapping&, Camera& c) {
         c.orthographic = true;
         c.orthoHeight = 6;
     },
     "depth and normals agree with a perspective camera of about fovY "},
    {"an orthographic picture declared perspective",
     [](Layers& l, Mapping&, Camera& c) {
         // A room around the camera, seen without perspective: its floor, walls and ceiling come nearer row by row.
         constexpr float kHeight = 6, kSlope = 0.7f;
         for (uint32_t i = 0; i < l.depth.size(); ++i) {
             const float x = (float(i % l.width) + 0.5f) / float(l.width) - 0.5f;
             const float y = 0.5f - (float(i / l.width) + 0.5f) / float(l.height);
             const bool wall = std::abs(x) > std::abs(y);
             const float out = (wall ? std::abs(x) * float(l.width) / float(l.height) : std::abs(y)) * kHeight;
             l.depth[i] = 8 - out / kSlope;
             const glm::vec3 normalVS =
                 glm::normalize(wall ? glm::vec3(x > 0 ? -1 : 1, 0, kSlope) : glm::vec3(0, y > 0 ? -1 : 1, kSlope));
             l.normal[i] = glm::mat3(c.viewToWorld) * normalVS;
         }
     },
     "depth and normals agree with an orthographic camera of about orthoHeight "},
};

/// The camera is turned and pitched: with one that looks along -Z, view and world normals are the same.
TEST_F(TraceTest, EveryWrongDeclarationIsNamed) {
    write("builtin:hall", "metals");
    const Camera camera = must(scene::readCameraFile(camera_));
    const scene::ExrChannels file = must(scene::ExrChannels::open(gbuffer_));
    const Mapping mapping = must(scene::readMapping("glint"));
    const Layers layers = must(scene::readLayers(file, file, mapping));
    EXPECT_THAT(scene::examine(layers, mapping, camera).findings, IsEmpty());
    for (const Mistake& mistake : kMistakes) {
        Layers wrongLayers = layers;
        Mapping wrongMapping = mapping;
        Camera wrongCamera = camera;
        mistake.make(wrongLayers, wrongMapping, wrongCamera);
        const scene::GBufferHealth health = scene::examine(wrongLayers, wrongMapping, wrongCamera);
        ASSERT_FALSE(health.findings.empty()) << mistake.name;
        EXPECT_THAT(health.findings.front(), HasSubstr(mistake.finding)) << mistake.name;
        // One mistake is one difference: nothing that is declared right is blamed.
        EXPECT_THAT(health.findings.front(), Not(HasSubstr("as declared and"))) << mistake.name;
    }
}

/// Bumps are no camera: nothing is said of a picture full of them. A wrong camera is named where they are not stronger
/// than its error.
TEST_F(TraceTest, NormalMapsDoNotHideTheCamera) {
    write("builtin:hall", "metals");
    const Camera camera = must(scene::readCameraFile(camera_));
    const scene::ExrChannels file = must(scene::ExrChannels::open(gbuffer_));
    const Mapping mapping = must(scene::readMapping("glint"));
    const Layers layers = must(scene::readLayers(file, file, mapping));
    std::mt19937 random(1);
    for (const float degrees : {2.0f, 4.0f, 8.0f}) {
        std::normal_distribution<float> bump(0, std::tan(glm::radians(degrees)));
        Layers mapped = layers;
        for (glm::vec3& normal : mapped.normal)
            if (normal != glm::vec3(0))
                normal = glm::normalize(normal + glm::vec3(bump(random), bump(random), bump(random)));
        EXPECT_THAT(scene::examine(mapped, mapping, camera).findings, IsEmpty()) << degrees;
        Camera wide = camera;
        wide.fovY *= 1.5f;
        if (degrees > 4)
            continue;
        EXPECT_THAT(scene::examine(mapped, mapping, wide).findings,
                    testing::Contains(HasSubstr("agree with a camera of about fovY")))
            << degrees;
    }
}

/// Where no meaning explains the normals, the other declarations are not blamed for those of another layer.
TEST_F(TraceTest, AWrongLayerIsTheOnlyFinding) {
    write("builtin:hall", "metals");
    const Camera camera = must(scene::readCameraFile(camera_));
    const scene::ExrChannels file = must(scene::ExrChannels::open(gbuffer_));
    Mapping mapping = must(scene::readMapping("glint"));
    mapping.normal = "albedo";
    Layers layers = must(scene::readLayers(file, file, mapping));
    const scene::PixelLens lens(camera, layers.width, layers.height);
    for (uint32_t i = 0; i < layers.pixels(); ++i)
        layers.position.emplace_back(
            camera.viewToWorld * glm::vec4(lens.positionVS(i % layers.width, i / layers.width, layers.depth[i]), 1));
    EXPECT_THAT(
        scene::examine(layers, mapping, camera).findings,
        testing::ElementsAre(HasSubstr("no other meaning agrees better"), HasSubstr("do not have unit length")));
}

TEST_F(TraceTest, PositionsMustProjectToTheirPixels) {
    write("builtin:hall");
    const Camera camera = must(scene::readCameraFile(camera_));
    const scene::ExrChannels file = must(scene::ExrChannels::open(gbuffer_));
    const Mapping mapping = must(scene::readMapping("glint"));
    Layers layers = must(scene::readLayers(file, file, mapping));
    const scene::PixelLens lens(camera, layers.width, layers.height);
    for (uint32_t i = 0; i < layers.pixels(); ++i)
        layers.position.emplace_back(
            camera.viewToWorld * glm::vec4(lens.positionVS(i % layers.width, i / layers.width, layers.depth[i]), 1));
    EXPECT_THAT(scene::examine(layers, mapping, camera).findings, IsEmpty());
    Camera moved = camera;
    moved.fovY *= 1.1f;
    EXPECT_THAT(scene::examine(layers, mapping, moved).findings,
                testing::Contains(HasSubstr("pixels from their own pixels")));
    for (float& depth : layers.depth)
        depth *= 100;
    EXPECT_THAT(scene::examine(layers, mapping, camera).findings,
                testing::Contains(HasSubstr("positions lie 0.01 times as far away as depth says")));
}

/// A camera that moves over strips of every roughness, denoised: each frame needs those before it.
class TraceSequenceTest : public TraceTest {
protected:
    static constexpr size_t kFrames = 4;

    static void denoise(render::RenderJob& job) {
        Settings& settings = job.settings.reflections;
        settings.reflect.roughnessFadeStart = 1;
        settings.reflect.maxRoughness = 1;
        settings.denoise.enabled = true;
    }

    std::string gbufferOf(size_t frame) const { return temp_ + fmt::format("g{}.exr", frame); }
    std::string cameraOf(size_t frame) const { return temp_ + fmt::format("c{}.json", frame); }

    /// Motion of surfaces that stand still, as Blender's Vector pass stores it: from the definition of the cameras.
    static std::vector<float> vectorPass(const render::RenderResult& drawn, const scene::Camera& camera,
                                         const scene::Camera& previous) {
        const std::vector<float>& depth = std::ranges::find(drawn.views, "depth", &render::RenderedView::name)->rgba;
        const double tanY = std::tan(double(camera.fovY) / 2), tanX = tanY * drawn.width / drawn.height;
        const glm::dmat4 toPrevious = glm::inverse(glm::dmat4(previous.viewToWorld)) * glm::dmat4(camera.viewToWorld);
        std::vector<float> motion(depth.size(), 0.0f);
        for (uint32_t y = 0; y < drawn.height; ++y)
            for (uint32_t x = 0; x < drawn.width; ++x) {
                const size_t i = 4 * (size_t{y} * drawn.width + x);
                const double z = depth[i], ndcX = (x + 0.5) / drawn.width * 2 - 1,
                             ndcY = 1 - (y + 0.5) / drawn.height * 2;
                const glm::dvec4 before = toPrevious * glm::dvec4(ndcX * tanX * z, ndcY * tanY * z, -z, 1);
                motion[i] = float((before.x / -before.z / tanX - ndcX) / 2 * drawn.width);
                motion[i + 1] = float((before.y / -before.z / tanY - ndcY) / 2 * drawn.height);
            }
        return motion;
    }

    void SetUp() override {
        TraceTest::SetUp();
        render::RenderJob job = drawnJob("builtin:motion-still");
        denoise(job);
        job.width = 160;
        job.height = 90;
        render::ReflectionSession session = must(render::openJob(gpu(), job));
        scene::Camera camera = session.inputs().camera, previous = camera;
        for (size_t frame = 0; frame < kFrames; ++frame) {
            must(session.setCamera(camera));
            drawn_ = must(render::renderFrames(session, job, uint32_t(frame)));
            writeFiles(camera, gbufferOf(frame), cameraOf(frame),
                       {{"Frame.Vector", "XY", false, vectorPass(drawn_, camera, previous)}});
            previous = camera;
            camera.viewToWorld[3] += 0.15f * camera.viewToWorld[0] + 0.12f * camera.viewToWorld[1];
        }
    }

    std::vector<render::TraceJob> jobs(const std::string& mapping = "glint") const {
        std::vector<render::TraceJob> jobs;
        for (size_t frame = 0; frame < kFrames; ++frame) {
            jobs.push_back(traceJob());
            denoise(jobs.back().picture);
            jobs.back().picture.scene = gbufferOf(frame);
            jobs.back().picture.camera = cameraOf(frame);
            jobs.back().mapping = mapping;
        }
        return jobs;
    }

    /// The last frame's composite.
    std::vector<float> traceAll(const std::vector<render::TraceJob>& jobs) {
        size_t taken = 0;
        const auto take = [&](size_t frame, const render::TraceInputs& inputs, const render::RenderResult&) {
            EXPECT_EQ(frame, taken++);
            EXPECT_THAT(inputs.health.findings, IsEmpty()) << frame;
            return Result<void>();
        };
        const render::TraceInputs first = must(render::loadTraceInputs(jobs.front()));
        const render::RenderResult last = must(render::runTraces(gpu(), jobs, first, take));
        EXPECT_EQ(taken, jobs.size());
        return last.views.front().rgba;
    }

    /// The preset with motion: pixels with +Y up, as Blender's.
    std::string mappingWithMotion(std::string_view scale) const {
        std::string text(must(scene::mappingPresetText("glint")));
        text.insert(text.find('{') + 1,
                    fmt::format(R"("motion": {{"layer": "Vector", "unit": "pixels", "scale": {}}},)", scale));
        must(writeFile(temp_ + "m.json", text));
        return temp_ + "m.json";
    }
};

TEST_F(TraceSequenceTest, FramesShareOneHistory) {
    const std::vector<float>& expected = drawnView("composite");
    const std::vector<render::TraceJob> all = jobs();
    const size_t together = differing(traceAll(all), expected);
    const size_t alone = differing(traceAll({all.back()}), expected);
    EXPECT_LT(together, expected.size() / 4 / 200);
    EXPECT_GT(alone, 10 * together + 100);
    // Motion that says what the cameras say changes nothing but rounding.
    EXPECT_LT(differing(traceAll(jobs(mappingWithMotion("[1, -1]"))), expected), expected.size() / 4 / 100);
}

TEST_F(TraceSequenceTest, MotionOfAnotherMeaningIsNamed) {
    const std::vector<render::TraceJob> all = jobs(mappingWithMotion("[1, 1]"));
    const Camera previous = must(scene::readCameraFile(cameraOf(kFrames - 2)));
    EXPECT_THAT(must(render::loadTraceInputs(all.back(), &previous)).health.findings,
                testing::ElementsAre(HasSubstr("motion agrees with the cameras as motion.unit pixels and motion.scale "
                                               "[1, -1], not motion.unit pixels and motion.scale [1, 1] as declared")));
    EXPECT_THAT(must(render::loadTraceInputs(all.back())).health.findings, IsEmpty());
}

TEST_F(TraceSequenceTest, FramesHaveOneSize) {
    drawn_.height /= 2;
    for (render::RenderedView& view : drawn_.views)
        view.rgba.resize(view.rgba.size() / 2);
    writeFiles(must(scene::readCameraFile(cameraOf(1))), gbufferOf(1), cameraOf(1));
    const std::vector<render::TraceJob> all = jobs();
    const render::TraceInputs first = must(render::loadTraceInputs(all.front()));
    const auto ignore = [](size_t, const render::TraceInputs&, const render::RenderResult&) { return Result<void>(); };
    const auto traced = render::runTraces(gpu(), all, first, ignore);
    ASSERT_FALSE(traced.ok());
    EXPECT_EQ(traced.error().code, ErrorCode::InvalidInput);
    EXPECT_THAT(traced.error().message, HasSubstr("160x45 pixels, but the first frame has 160x90"));
}

} // namespace trace_test
} // namespace glint::test
