// The command line from arguments to files and exit codes, with a renderer that needs no GPU.
#include "lab/cli/program.hpp"
#include "lab/cli/render/render_output.hpp"

#include "base/file.hpp"
#include "lab/scene/builtin/builtin.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/session/views.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <optional>

namespace glint::cli {
namespace cli_test {

struct Ended {
    int code = 0;
    std::string out, error;
};

class CliTest : public testing::Test {
protected:
    Ended run(std::vector<std::string> arguments) {
        std::vector<const char*> argv = {"glint"};
        for (const std::string& argument : arguments)
            argv.push_back(argument.c_str());
        testing::internal::CaptureStdout();
        testing::internal::CaptureStderr();
        Ended ended;
        ended.code = runProgram(static_cast<int>(argv.size()), argv.data(),
                                [this](const render::RenderJob& job) { return render(job); });
        ended.out = testing::internal::GetCapturedStdout();
        ended.error = testing::internal::GetCapturedStderr();
        return ended;
    }

    /// `glint render builtin:exact ...`
    Ended runRender(std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"render", "builtin:exact"});
        return run(std::move(arguments));
    }

    /// Four pixels a view, each view with a value of its own.
    Result<render::RenderResult> render(const render::RenderJob& job) {
        job_ = job;
        if (failure_)
            return *failure_;
        render::RenderResult result;
        result.width = result.height = 2;
        for (const std::string& name : job.views) {
            const float value = 0.25f * static_cast<float>(result.views.size() + 1);
            result.views.push_back({name, std::vector<float>(16, value), std::vector<uint8_t>(12, 100)});
        }
        result.stats = {"device",
                        "driver 1",
                        true,
                        {{"trace/linear", 1.5}, {"composite/composite", 0.5}},
                        3,
                        12.5,
                        40,
                        {},
                        {{"hit", 2}, {"sky", 0}}};
        result.stats.plan = {{"denoise", true}, {"trace/picture", false}};
        if (job.inspect)
            result.inspection = inspection_;
        return result;
    }

    std::vector<std::string> files() const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(folder_))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }

    void expectError(const Ended& ended, int code, std::string_view part) {
        EXPECT_EQ(ended.code, code);
        EXPECT_EQ(ended.error.substr(0, 14), "glint: error: ") << ended.error;
        EXPECT_NE(ended.error.find(part), ended.error.npos) << ended.error;
        EXPECT_EQ(std::ranges::count(ended.error, '\n'), 1) << ended.error;
        EXPECT_EQ(ended.out, "");
        EXPECT_TRUE(files().empty());
    }

    const test::TempFolder temp_;
    const std::string& folder_ = temp_.path();
    std::optional<render::RenderJob> job_;
    std::optional<Error> failure_;
    RayInspection inspection_;
};

TEST_F(CliTest, RenderFillsTheJobFromItsOptions) {
    const Ended ended = run({"render",   "builtin:hall",
                             "-o",       folder_ + "a.png",
                             "--camera", "2",
                             "--env",    "none",
                             "--size",   "640x360",
                             "--time",   "1.5",
                             "--frames", "4",
                             "--seed",   "7",
                             "--device", "llvm",
                             "--preset", "babylon",
                             "--set",    "thickness=0.25",
                             "--set",    "display.exposure=-1"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_EQ(ended.out + ended.error, "");
    EXPECT_EQ(job_->scene, "builtin:hall");
    EXPECT_EQ(job_->camera, "2");
    EXPECT_EQ(job_->environment, "none");
    EXPECT_EQ(job_->width, 640u);
    EXPECT_EQ(job_->height, 360u);
    EXPECT_EQ(job_->time, 1.5);
    EXPECT_EQ(job_->frames, 4u);
    EXPECT_EQ(job_->seed, 7u);
    EXPECT_EQ(job_->device, "llvm");
    EXPECT_EQ(job_->views, std::vector<std::string>{"composite"});
    EXPECT_TRUE(job_->display);
    EXPECT_FALSE(job_->statistics);
    EXPECT_EQ(job_->settings.reflections.screen.thickness, 0.25f);
    EXPECT_EQ(job_->settings.render.display.exposure, -1);
    EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
}

TEST_F(CliTest, BuiltinScenesBringTheirEnvironmentStrength) {
    const scene::BuiltinInfo& info = scene::builtinScenes().front();
    ASSERT_NE(info.environmentStrength, 1) << "the show piece no longer tells its default from the table's";
    const std::string name = "builtin:" + std::string(info.name);
    ASSERT_EQ(run({"render", name, "-o", folder_ + "a.png"}).code, kDone);
    EXPECT_EQ(job_->settings.render.environment.strength, info.environmentStrength);
    ASSERT_EQ(run({"render", name, "-o", folder_ + "a.png", "--set", "environment.strength=1"}).code, kDone);
    EXPECT_EQ(job_->settings.render.environment.strength, 1);
    ASSERT_EQ(run({"render", "hall.glb", "-o", folder_ + "a.png"}).code, kDone);
    EXPECT_EQ(job_->settings.render.environment.strength, 1);
}

TEST_F(CliTest, SeveralViewsAsPngAreSeveralFiles) {
    const Ended ended = runRender({"-o", folder_ + "a.b.png", "--view", "outcome,depth", "--view", "depth"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_EQ(job_->views, (std::vector<std::string>{"outcome", "depth"}));
    EXPECT_EQ(files(), (std::vector<std::string>{"a.b.depth.png", "a.b.png"}));
}

TEST_F(CliTest, ExrHasTheFrameBareAndTheViewsAsLayers) {
    const Ended ended = runRender({"-o", folder_ + "a.exr", "--view", "reflection,depth"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_EQ(job_->views, (std::vector<std::string>{"composite", "reflection", "depth"}));
    EXPECT_FALSE(job_->display);
    const auto image = scene::readHdrImage(folder_ + "a.exr");
    ASSERT_TRUE(image.ok());
    EXPECT_EQ(image->rgb[0], glm::vec3(0.25f));
    const std::string bytes = *readFile(folder_ + "a.exr", 1 << 20);
    for (const std::string channel : {"reflection.R", "reflection.B", "depth.Z"})
        EXPECT_NE(bytes.find(channel + '\0'), bytes.npos) << channel;
    EXPECT_EQ(bytes.find("depth.R"), bytes.npos);
}

TEST_F(CliTest, StatsAreJsonWithTheSettingsInForce) {
    const Ended ended = runRender({"-o", folder_ + "a.png", "--stats", folder_ + "a.json", "--set", "screen.step=4"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_TRUE(job_->statistics);
    const auto json = nlohmann::json::parse(*readFile(folder_ + "a.json", 1 << 20));
    EXPECT_EQ(json["scene"], "builtin:exact");
    EXPECT_EQ(json["device"]["name"], "device");
    EXPECT_EQ(json["width"], 2);
    EXPECT_EQ(json["gpuMs"], 2.0);
    EXPECT_EQ(json["passes"][0], (nlohmann::json{{"name", "trace/linear"}, {"ms", 1.5}}));
    EXPECT_EQ(json["plan"], (nlohmann::json{{"denoise", true}, {"trace/picture", false}}));
    EXPECT_EQ(json["rays"], 3);
    EXPECT_EQ(json["lookupsPerRay"], 12.5);
    EXPECT_EQ(json["outcomes"], (nlohmann::json{{"hit", 2}, {"sky", 0}}));
    EXPECT_EQ(json["settings"]["screen"]["step"], 4);
    EXPECT_EQ(json["settings"]["display"]["tonemap"], "neutral");
}

TEST_F(CliTest, BadArgumentsEndWithTwoAndOneLine) {
    expectError(run({}), kBadInput, "subcommand");
    expectError(run({"paint"}), kBadInput, "paint");
    expectError(run({"render"}), kBadInput, "SCENE");
    expectError(runRender({"--colour"}), kBadInput, "--colour");
    const std::string out = folder_ + "a.png";
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{"--size", "0x0"}, "--size 0x0: each side must be 1 to 16384 pixels"},
        {{"--size", "100000x100000"}, "--size 100000x100000: each side must be 1 to 16384 pixels"},
        {{"--size", "16385x1"}, "each side must be 1 to 16384"},
        {{"--size", "99999999999999999999x1"}, "expected WIDTHxHEIGHT"},
        {{"--size", "640"}, "expected WIDTHxHEIGHT"},
        {{"--size", "-640x360"}, "expected WIDTHxHEIGHT"},
        {{"--size", "640x360x2"}, "expected WIDTHxHEIGHT"},
        {{"--time", "nan"}, "--time"},
        {{"--time", "soon"}, "--time"},
        {{"--frames", "0"}, "--frames 0: expected 1 to"},
        {{"--frames", "-1"}, "--frames -1: expected 1 to"},
        {{"--settle", "-1"}, "--settle -1: expected 0 to 255"},
        {{"--settle", "nan"}, "--settle nan: expected 0 to 255"},
        {{"--seed", "x"}, "--seed"},
        {{"--view", "outcomes"}, "did you mean 'outcome'?"},
        {{"--view", ""}, "--view"},
        {{"--preset", "slow"}, "unknown preset 'slow'"},
        {{"--settings", folder_ + "none.json"}, "none.json: No such file"},
        {{"--set", "screen.stpe=1"}, "did you mean 'screen.step'?"},
        {{"--set", "screen.step"}, "expected KEY=VALUE"},
        {{"--set", "screen.step=0"}, "out of range [1, 64] px"},
        {{"--set", "thickness=1"}, "'babylon:thickness' or 'compute-ssr:thickness'"},
        {{"--stats", folder_ + "none/a.json"}, "there is no folder"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.end(), {"-o", out});
        expectError(runRender(arguments), kBadInput, part);
        EXPECT_FALSE(job_) << "the renderer ran";
    }
    expectError(runRender({"-o", folder_ + "a.jpg"}), kBadInput, "must end in .png or .exr");
    expectError(runRender({"-o", folder_ + "none/a.png"}), kBadInput, "there is no folder");
}

TEST_F(CliTest, RenderSettlesWithinTheFramesOfTheHistory) {
    const auto frames = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"-o", folder_ + "a.png"});
        const Ended ended = runRender(more);
        EXPECT_EQ(ended.code, kDone) << ended.error;
        return job_->frames;
    };
    EXPECT_EQ(frames({}), 30u);
    EXPECT_EQ(job_->settle, 0);
    EXPECT_EQ(frames({"--settle", "0.5"}), 30u);
    EXPECT_EQ(job_->settle, 0.5);
    EXPECT_EQ(frames({"--settle", "0.5", "--frames", "12"}), 12u);
    EXPECT_EQ(frames({"--settle", "0.5", "--preset", "reference"}), 1024u) << "a mean over frames without end";
    EXPECT_EQ(frames({"--preset", "reference"}), 1u);
}

TEST_F(CliTest, InspectPrintsThePixelsRay) {
    inspection_.pixel = inspection_.rayPixel = {1, 0};
    inspection_.traced = inspection_.hit = inspection_.answered = true;
    inspection_.outcome = "hit";
    inspection_.hitPixel = {0, 1};
    inspection_.fades = {{"roughness", 0.1f}};
    inspection_.samples = {{.positionPX = {1.5f, 0.5f}, .level = 3, .rayDepth = 2, .decision = "front"},
                           {.slabEndDepth = std::numeric_limits<float>::infinity(), .decision = "hit"}};
    inspection_.sources = {{"screen", 0.75f, {1, 2, 3}}};
    const Ended ended = run({"inspect", "builtin:exact", "--pixel", "1,0", "--size", "2x2", "--frames", "3", "--set",
                             "screen.march=adaptive"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_EQ(ended.error, "");
    EXPECT_EQ(job_->inspect, (std::array<uint32_t, 2>{1, 0}));
    EXPECT_EQ(job_->frames, 3u);
    EXPECT_TRUE(job_->views.empty()) << "no picture was asked for";
    const auto json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json["march"], "adaptive");
    EXPECT_EQ(json["outcome"], "hit");
    EXPECT_EQ(json["hitSuccess"], true);
    EXPECT_EQ(json["ray"]["answer"]["fades"]["roughness"], 0.1) << "a float's own digits";
    EXPECT_EQ(json["ray"]["answer"]["pixel"], (nlohmann::json{0, 1}));
    EXPECT_FALSE(json["ray"].contains("projection")) << "only of march proxy";
    EXPECT_EQ(json["ray"]["samples"][0]["px"], (nlohmann::json{1.5, 0.5}));
    EXPECT_EQ(json["ray"]["samples"][0]["level"], 3);
    EXPECT_EQ(json["ray"]["samples"][0]["slabEndDepth"], nullptr);
    EXPECT_EQ(json["ray"]["samples"][1]["decision"], "hit");
    EXPECT_EQ(json["sources"][0], (nlohmann::json{{"name", "screen"}, {"weight", 0.75}, {"radiance", {1, 2, 3}}}));
    EXPECT_TRUE(files().empty());
}

TEST_F(CliTest, InspectSaysWhatProxyTheRayMeets) {
    using Projection = RayInspection::Projection;
    inspection_.traced = true;
    const std::vector<std::string> arguments = {"inspect", "builtin:exact", "--pixel", "1,0", "--size", "2x2"};
    inspection_.projection = Projection{7, "sphere", 0.1f};
    EXPECT_EQ(nlohmann::json::parse(run(arguments).out)["ray"]["projection"],
              (nlohmann::json{{"probe", 7}, {"proxy", "sphere"}, {"distance", 0.1}}));
    inspection_.projection = Projection{{}, "none", std::numeric_limits<float>::infinity()};
    EXPECT_EQ(nlohmann::json::parse(run(arguments).out)["ray"]["projection"],
              (nlohmann::json{{"probe", nullptr}, {"proxy", "none"}, {"distance", nullptr}}));
}

TEST_F(CliTest, InspectDrawsOverTheViewThatWasAskedFor) {
    inspection_.whyNoRay = "the pixel shows no surface";
    const Ended ended = run({"inspect", "builtin:exact", "--pixel", "0,1", "-o", folder_ + "a.png", "--view", "depth"});
    ASSERT_EQ(ended.code, kDone) << ended.error;
    EXPECT_EQ(job_->views, std::vector<std::string>{"depth"});
    EXPECT_EQ(files(), std::vector<std::string>{"a.png"});
    const auto json = nlohmann::json::parse(ended.out);
    EXPECT_EQ(json["whyNoRay"], "the pixel shows no surface");
    EXPECT_EQ(json["ray"], nullptr);
}

TEST_F(CliTest, InspectFindsBadArgumentsBeforeAnyWork) {
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{}, "--pixel"},
        {{"--pixel", "12"}, "--pixel 12: expected X,Y"},
        {{"--pixel", "1,2,3"}, "--pixel 1,2,3: expected X,Y"},
        {{"--pixel", "-1,2"}, "--pixel -1,2: expected X,Y"},
        {{"--pixel", "1.5,2"}, "expected X,Y"},
        {{"--pixel", "a,b"}, "expected X,Y"},
        {{"--pixel", "99999999999,2"}, "expected X,Y"},
        {{"--pixel", "640,2", "--size", "640x360"}, "--pixel 640,2: it lies outside the picture of 640x360"},
        {{"--pixel", "1,360", "--size", "640x360"}, "outside the picture"},
        {{"--pixel", "1,1", "--size", "0x0"}, "--size 0x0"},
        {{"--pixel", "1,1", "--view", "dept"}, "did you mean 'depth'?"},
        {{"--pixel", "1,1", "-o", folder_ + "a.exr"}, ".png"},
        {{"--pixel", "1,1", "-o", folder_ + "none/a.png"}, "there is no folder"},
        {{"--pixel", "1,1", "--set", "screen.step=0"}, "out of range"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), {"inspect", "builtin:exact"});
        expectError(run(arguments), kBadInput, part);
        EXPECT_FALSE(job_) << "the renderer ran";
    }
}

TEST_F(CliTest, CompareFindsBadArgumentsBeforeAnyWork) {
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{}, "--config"},
        {{"--config", "slow"}, "--config slow: no preset of this name"},
        {{"--config", "fast", "--config", "screen.stpe=1"}, "did you mean 'screen.step'?"},
        {{"--config", folder_ + "none.json"}, "none.json: No such file"},
        {{"--config", "fast", "--size", "0x0"}, "--size 0x0"},
        {{"--config", "fast", "--frames", "0"}, "--frames 0: expected 1 to"},
        {{"--config", "fast", "--json", folder_ + "none/a.json"}, "--json"},
        {{"--config", "fast", "--report", folder_ + "none/a.html"}, "there is no folder"},
        {{"--config", "fast", "--set", "screen.step=0"}, "out of range"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), {"compare", "builtin:exact"});
        expectError(run(arguments), kBadInput, part);
    }
}

TEST_F(CliTest, ReportFindsBadArgumentsBeforeAnyWork) {
    const std::string page = folder_ + "a.html";
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{"-o", folder_ + "a.png"}, "the name must end in .html"},
        {{"-o", folder_ + "none/a.html"}, "there is no folder"},
        {{"-o", page, "--json", folder_ + "none/a.json"}, "there is no folder"},
        {{"-o", page, "--config", "slow"}, "--config slow: no preset of this name"},
        {{"-o", page, "--reference", "slow"}, "slow: no preset of this name"},
        {{"-o", page, "--seeds", "1"}, "--seeds 1: expected 2 to 64"},
        {{"-o", page, "--frames", "0"}, "--frames 0: expected 1 to"},
        {{"-o", page, "--reference-frames", "0"}, "--reference-frames 0: expected 1 to"},
        {{"-o", page, "--motion-frames", "1"}, "nothing moves in one frame"},
        {{"-o", page, "--motion-size", "0x0"}, "--size 0x0"},
        {{"-o", page, "--path", "zoom"}, "--path zoom: expected still"},
        {{"-o", page, "--threshold", "nan"}, "--threshold nan"},
        {{"-o", page, "--time-threshold", "-1"}, "--time-threshold -1"},
        {{"-o", page, "--curve", folder_ + "none.json"}, "--curve"},
        {{"-o", page, "--against", folder_ + "none.json"}, "--against"},
        {{"-o", page, "--pictures", folder_ + "none.json"}, "none.json"},
        {{"-o", page, "--pictures-size", "0x0"}, "--pictures-size 0x0"},
        {{"-o", page, "--set", "screen.step=0"}, "out of range"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), {"report", "builtin:exact"});
        expectError(run(arguments), kBadInput, part);
    }
}

TEST_F(CliTest, SequenceFindsBadArgumentsBeforeAnyWork) {
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{"--path", "zoom"}, "--path zoom: expected still, pan, dolly, truck, orbit or a .json file"},
        {{"--path", folder_ + "none.json"}, "none.json: No such file"},
        {{"--frames", "0"}, "--frames 0: expected 1 to"},
        {{"--fps", "0"}, "--fps 0: expected 1 to 1000"},
        {{"--fps", "nan"}, "--fps nan: expected 1 to 1000"},
        {{"--speed", "1e9"}, "--speed"},
        {{"--stop", "-2"}, "--stop -2"},
        {{"--config", "slow"}, "--config slow: no preset of this name"},
        {{"--config", "fast", "--preset", "fast"}, "--config excludes --preset"},
        {{"--preset", "slow"}, "slow"},
        {{"--set", "screen.stpe=1"}, "did you mean 'screen.step'?"},
        {{"--size", "0x0"}, "--size 0x0"},
        {{"--reference-samples", "-1"}, "--reference-samples -1"},
        {{"--reference-samples", "64", "--reference", "balanced"}, "need rays.enabled and rays.accumulate"},
        {{"--frames", "8", "--warm-up", "8"}, "--warm-up 8: expected 0 to 7"},
        {{"--json", folder_ + "none/a.json"}, "there is no folder"},
        {{"-o", folder_ + "frame.png"}, "expected one %d or %04d"},
        {{"-o", folder_ + "frame_%d.jpg"}, "must end in .png or .exr"},
        {{"-o", folder_ + "none/deep/frame_%d.png"}, "there is no folder"},
        {{"--config", "frames=a.exr"}, "--config frames=a.exr: expected frames=A/%04d.exr, or"},
        {{"--config", "frames=" + folder_ + "%d.exr", "--frames", "3"}, "0.exr: no such frame; the files of 3 frames"},
        {{"--dump", folder_ + "none/dump"}, "there is no folder"},
        {{"--dump", folder_ + "dump", "--preset", "fast"}, "these settings denoise nothing: they need denoise.enabled"},
        {{"--dump", folder_ + "dump", "--config", "balanced", "--config", "real-time"}, "one configuration is dumped"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), {"sequence", "builtin:exact"});
        expectError(run(arguments), kBadInput, part);
    }
}

TEST_F(CliTest, BenchFindsBadArgumentsBeforeAnyWork) {
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{"--config", "slow"}, "--config slow: no preset of this name"},
        {{"--sizes", "640x360,64"}, "--sizes 64: expected WIDTHxHEIGHT"},
        {{"--shares", "0,101"}, "--shares 101: expected percentages"},
        {{"--shares", "half"}, "--shares half: expected percentages"},
        {{"--frames", "0"}, "--frames 0"},
        {{"--warm-up", "-1"}, "--warm-up -1"},
        {{"--budget", "-1"}, "--budget -1"},
        {{"--config", "display.antialias=msaa4"}, "one sample a pixel"},
        {{"--json", folder_ + "none/a.json"}, "there is no folder"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), {"bench", "builtin:mirror"});
        expectError(run(arguments), kBadInput, part);
    }
}

TEST_F(CliTest, BenchOfRaysFindsBadArgumentsBeforeAnyWork) {
    const std::pair<std::vector<std::string>, std::string_view> cases[] = {
        {{"--rays", "--triangles", "0"}, "--triangles 0: expected numbers from 100 to"},
        {{"--rays", "--triangles", "1e12"}, "--triangles 1e12: expected numbers"},
        {{"--rays", "--triangles", "1e3,abc"}, "--triangles abc: expected numbers"},
        {{"--rays", "--triangles", "nan"}, "--triangles nan: expected numbers"},
        {{"--rays", "--triangles", "-1e3"}, "--triangles -1e3: expected numbers"},
        {{"--rays", "--ray-count", "63"}, "--ray-count 63: expected 64 to"},
        {{"--rays", "--repeats", "0"}, "--repeats 0: expected 1 to"},
        {{"--rays", "builtin:hall"}, "SCENE excludes --rays"},
        {{"--rays", "--config", "fast"}, "--config excludes --rays"},
        {{"--triangles", "1e3"}, "--triangles requires --rays"},
        {{"--rays", "--json", folder_ + "none/a.json"}, "there is no folder"},
    };
    for (auto [arguments, part] : cases) {
        arguments.insert(arguments.begin(), "bench");
        expectError(run(arguments), kBadInput, part);
    }
}

TEST_F(CliTest, FailuresOfTheRendererHaveTheirExitCodes) {
    const std::pair<ErrorCode, int> cases[] = {
        {ErrorCode::InvalidArgument, kBadInput},
        {ErrorCode::InvalidInput, kBadInput},
        {ErrorCode::NotFound, kBadInput},
        {ErrorCode::Unsupported, kFailed},
        {ErrorCode::DeviceLost, kFailed},
        {ErrorCode::OutOfMemory, kFailed},
        {ErrorCode::Io, kFailed},
    };
    for (const auto& [error, code] : cases) {
        failure_ = Error{error, "it broke\nat pass trace/linear"};
        expectError(runRender({"-o", folder_ + "a.png"}), code, "it broke?at pass trace/linear");
    }
}

TEST_F(CliTest, HelpListsOnlyWhatIsThere) {
    const Ended with = run({"--help"});
    EXPECT_EQ(with.code, kDone);
    for (const char* command : {"render", "inspect", "compare", "sequence", "bench", "settings", "views", "devices"})
        EXPECT_NE(with.out.find(command), with.out.npos) << command;
    const char* argv[] = {"glint", "--help"};
    testing::internal::CaptureStdout();
    EXPECT_EQ(runProgram(2, argv, {}), kDone);
    EXPECT_EQ(testing::internal::GetCapturedStdout().find("Render a scene"), std::string::npos);
}

TEST_F(CliTest, SettingsPrintsEveryKeyInThreeForms) {
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"settings"}, {"settings", "--json"}, {"settings", "--markdown"}}) {
        const Ended ended = run(arguments);
        EXPECT_EQ(ended.code, kDone);
        for (const auto& table : render::allSettings()) {
            for (const SettingInfo& info : table)
                EXPECT_NE(ended.out.find(info.key), ended.out.npos) << info.key;
        }
    }
    expectError(run({"settings", "--json", "--markdown"}), kBadInput, "--json");
}

TEST_F(CliTest, ProbesAreHandedToTheRenderer) {
    const test::TempFolder folder;
    EXPECT_EQ(runRender({"--probes", "hall.probes", "-o", folder + "a.png"}).code, kDone);
    EXPECT_EQ(job_->probes, "hall.probes");
    EXPECT_EQ(runRender({"-o", folder + "a.png"}).code, kDone);
    EXPECT_EQ(job_->probes, "");
}

TEST_F(CliTest, BakeSaysWhatItCannotDo) {
    const auto errorOf = [&](const std::string& option, const std::string& value) {
        const Ended ended = run({"bake", "builtin:mirror", option, value});
        EXPECT_EQ(ended.code, kBadInput) << option;
        EXPECT_NE(ended.error.find(option + " " + value), std::string::npos) << ended.error;
    };
    errorOf("--count", "0");
    errorOf("--count", "257");
    errorOf("--face", "48");
    errorOf("--face", "8");
    errorOf("--bounces", "0");
    errorOf("-o", "/no/such/folder/x.probes");
    EXPECT_EQ(run({"bake", "no_such_scene.glb"}).code, kBadInput);
    EXPECT_EQ(run({"bake", "builtin:mirror", "--probes", "no_such_places.json"}).code, kBadInput);
}

TEST_F(CliTest, TuneRefusesWhatItCannotSearch) {
    const auto refused = [this](std::vector<std::string> arguments) {
        arguments.insert(arguments.begin(), {"tune", "builtin:exact"});
        const Ended ended = run(std::move(arguments));
        EXPECT_EQ(ended.code, kBadInput) << ended.error;
        return ended.error;
    };
    EXPECT_NE(refused({}).find("exactly one of --budget-ms"), std::string::npos);
    EXPECT_NE(refused({"--budget", "0.5", "--max-error", "1"}).find("exactly one of"), std::string::npos);
    EXPECT_NE(refused({"--budget", "-1"}).find("above 0"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--population", "10"}).find("--population 10"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--paths", "walk"}).find("--paths walk"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--start", "slow"}).find("--start slow"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--presets", "slow"}).find("--presets slow"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--vary", "hiz.foo"}).find("--vary hiz.foo"), std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "--reference", "balanced"}).find("--reference-frames 1"), std::string::npos);
    EXPECT_NE(refused({"builtin:hall", "builtin:mirror", "--camera", "0", "--camera", "own", "--budget", "1"})
                  .find("2 cameras for 3 scenes"),
              std::string::npos);
    EXPECT_NE(refused({"--budget", "1", "-o", "/no/such/folder/a.json"}).find("-o"), std::string::npos);
}

} // namespace cli_test
} // namespace glint::cli
