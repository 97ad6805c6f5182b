// The plan of a sweep, read with every value checked; its jobs, their names, and the shards that run them.
#include "lab/cli/sweep/sweep_plan.hpp"

#include "base/file.hpp"
#include "lab/cli/sweep/sweep_jobs.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

namespace glint::cli {
namespace sweep_plan_test {

SweepJson madeUpPlan() {
    return SweepJson::parse(R"({
        "description": "made up",
        "scenes": ["builtin:exact",
                   {"name": "evening", "scene": "builtin:hall", "camera": "1", "env": "sky", "materials": "none",
                    "planar": "auto", "time": 0.5, "set": ["display.exposure=1"]}],
        "sizes": ["64x36", "128x72"],
        "configs": ["fast", {"name": "mine", "config": "babylon", "settings": {"screen": {"step": 4}}}],
        "grid": {"screen.smooth": [false, true], "screen.maxSteps": [16, 32, 64]},
        "set": ["display.exposure=2", "fade.border=none"],
        "seeds": [3, 5],
        "reference": {"config": "reference", "frames": 2}
    })");
}

SweepPlan plan(const std::function<void(SweepJson&)>& change = {}) {
    SweepJson json = madeUpPlan();
    if (change)
        change(json);
    return test::must(readSweepPlan(json.dump(), "plan.json"));
}

std::vector<SweepJob> jobs(const SweepPlan& plan, const std::string& program = "glint") {
    return test::must(makeSweepJobs(plan, program, "plan.json"));
}

std::set<std::string> names(const std::vector<SweepJob>& jobs) {
    std::set<std::string> names;
    for (const SweepJob& job : jobs)
        names.insert(job.name);
    return names;
}

std::vector<std::string> common(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::vector<std::string> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    return both;
}

TEST(SweepPlan, EveryCombinationIsAJob) {
    const SweepPlan read = plan();
    ASSERT_EQ(read.configs.size(), 12u);
    EXPECT_EQ(read.configs[1].name, "fast+screen.smooth=false,screen.maxSteps=32");
    EXPECT_EQ(read.configs[11].name, "mine+screen.smooth=true,screen.maxSteps=64");
    EXPECT_EQ(read.jobCount(), 2u * 2u * 12u * 2u);
    const std::vector<SweepJob> made = jobs(read);
    EXPECT_EQ(made.size(), read.jobCount());
    EXPECT_EQ(names(made).size(), made.size()) << "every job has a name of its own";
    // Scene, size, config, seed: the last varies first.
    EXPECT_EQ(made[0].title(), "builtin:exact, 64x36, fast+screen.smooth=false,screen.maxSteps=16, seed 3");
    EXPECT_EQ(made[1].title(), "builtin:exact, 64x36, fast+screen.smooth=false,screen.maxSteps=16, seed 5");
    EXPECT_EQ(made.back().title(), "evening, 128x72, mine+screen.smooth=true,screen.maxSteps=64, seed 5");
}

TEST(SweepPlan, JobsHaveTheirOptionsAndSettings) {
    const std::vector<SweepJob> made = jobs(plan());
    const SweepJob& last = made.back();
    const render::RenderJob& job = last.config.job;
    EXPECT_EQ(job.scene, "builtin:hall");
    EXPECT_EQ(job.camera, "1");
    EXPECT_EQ(job.environment, "sky");
    EXPECT_EQ(job.materials, "none");
    EXPECT_EQ(job.planar, render::MirrorSearch::Auto);
    EXPECT_EQ(job.time, 0.5);
    EXPECT_EQ(job.width, 128u);
    EXPECT_EQ(job.seed, 5u);
    EXPECT_EQ(job.settings.preset, "babylon");
    EXPECT_EQ(job.settings.reflections.screen.step, 4);
    EXPECT_EQ(job.settings.reflections.screen.maxSteps, 64);
    EXPECT_TRUE(job.settings.reflections.screen.smooth);
    EXPECT_EQ(job.settings.reflections.fade.border, FadeBorder::None_);
    EXPECT_EQ(job.settings.render.display.exposure, 1) << "a scene's settings are stronger than the plan's";
    EXPECT_EQ(made.front().config.job.settings.render.display.exposure, 2);
    EXPECT_TRUE(last.hits);
    ASSERT_NE(last.reference, nullptr);
    EXPECT_EQ(last.reference->config.job.frames, 2u);
    EXPECT_EQ(last.reference->config.job.seed, kSweepReferenceSeed);
    EXPECT_EQ(last.reference, made[made.size() - 2].reference) << "jobs of one scene share it";
    EXPECT_NE(last.reference->name, made.front().reference->name);
}

TEST(SweepPlan, MovingPicturesAreJobsToo) {
    const SweepPlan read = plan([](SweepJson& json) {
        json["motion"] = {{"path", "dolly"}, {"frames", 12}, {"samples", 4}};
        json["reference"]["config"] = "reference+rays.samples=2";
        json["stills"] = false;
    });
    const std::vector<SweepJob> made = jobs(read);
    EXPECT_EQ(made.size(), 2u * 2u * 12u) << "one for each config: it has two seeds itself";
    ASSERT_NE(made[0].motion, nullptr);
    EXPECT_EQ(made[0].motion->frames, 12u);
    EXPECT_EQ(made[0].motion->path.move, scene::CameraMove::Dolly);
    EXPECT_EQ(made[0].motion->reference->job.frames, 2u) << "4 samples, of which a frame has 2";
    EXPECT_EQ(made[0].description["kind"], "motion");
    EXPECT_EQ(made[0].reference, nullptr);
}

TEST(SweepPlan, NamesAreOfTheContents) {
    const std::set<std::string> before = names(jobs(plan()));
    EXPECT_EQ(names(jobs(plan())), before) << "the same plan has the same names";
    EXPECT_EQ(names(jobs(plan([](SweepJson& json) { json["description"] = "another"; }))), before);
    const auto more = names(jobs(plan([](SweepJson& json) { json["seeds"] = {3, 5, 7}; })));
    EXPECT_EQ(common(more, before).size(), before.size()) << "a longer plan keeps what it had";
    // Whatever a figure depends on is in the name.
    const std::vector<std::function<void(SweepJson&)>> changes = {
        [](SweepJson& json) { json["set"].push_back("screen.thickness=0.3"); },
        [](SweepJson& json) { json["set"].push_back("lights.shadows=none"); },
        [](SweepJson& json) {
            json["sizes"] = {"64x37", "128x73"};
        },
        [](SweepJson& json) {
            json["seeds"] = {4, 6};
        },
        [](SweepJson& json) { json["frames"] = 6; },
        [](SweepJson& json) { json["hits"] = false; },
        [](SweepJson& json) { json["reference"]["frames"] = 3; },
        [](SweepJson& json) { json["reference"]["seed"] = 1; },
        [](SweepJson& json) { json["reference"]["config"] = "real-time"; },
        [](SweepJson& json) { json.erase("reference"); },
    };
    for (size_t i = 0; i < changes.size(); ++i)
        EXPECT_TRUE(common(names(jobs(plan(changes[i]))), before).empty()) << "change " << i;
    EXPECT_TRUE(common(names(jobs(plan(), "glint of another build")), before).empty());
}

TEST(SweepPlan, NamesAreOfTheScenesFiles) {
    const test::TempFolder folder;
    const std::string scene = folder + "scene.gltf";
    const auto write = [&](const std::string& file, const std::string& text) {
        ASSERT_TRUE(writeFile(folder + file, text));
    };
    write("scene.gltf", R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data%20one.bin", "byteLength": 4}]})");
    write("data one.bin", "abcd");
    const auto namesNow = [&] { return names(jobs(plan([&](SweepJson& json) { json["scenes"] = {scene}; }))); };
    const std::set<std::string> before = namesNow();
    EXPECT_EQ(namesNow(), before);
    write("data one.bin", "abce");
    const std::set<std::string> changed = namesNow();
    EXPECT_TRUE(common(changed, before).empty()) << "a buffer beside the scene";
    write("scene.gltf.materials.json", "{}");
    const std::set<std::string> overridden = namesNow();
    EXPECT_TRUE(common(overridden, changed).empty()) << "materials beside the scene";
    write("data one.bin", "abcd");
    std::filesystem::remove(folder + "scene.gltf.materials.json");
    EXPECT_EQ(namesNow(), before) << "what counts is what files contain";
}

/// Reads a plan that is wrong, up to its jobs. Returns the message.
std::string wrong(const std::string& text) {
    auto read = readSweepPlan(text, "plan.json");
    if (!read)
        return read.error().message;
    auto made = makeSweepJobs(*read, "glint", "plan.json");
    EXPECT_FALSE(made.ok()) << text;
    return made ? "" : made.error().message;
}

TEST(SweepPlan, EveryMistakeIsNamed) {
    struct Mistake {
        std::function<void(SweepJson&)> change;
        std::string message; ///< part of it
    };
    const std::vector<Mistake> mistakes = {
        {[](SweepJson& json) { json = SweepJson::array(); }, "plan.json: expected an object"},
        {[](SweepJson& json) { json.erase("scenes"); }, "plan.json: it has no \"scenes\""},
        {[](SweepJson& json) { json.erase("configs"); }, "plan.json: it has no \"configs\""},
        {[](SweepJson& json) { json["seed"] = 1; }, "plan.json: unknown key 'seed'; did you mean 'seeds'?"},
        {[](SweepJson& json) { json["scenes"] = "builtin:hall"; }, "plan.json: scenes: expected a list"},
        {[](SweepJson& json) { json["scenes"] = SweepJson::array(); }, "plan.json: scenes: expected a list"},
        {[](SweepJson& json) { json["scenes"][0] = 3; }, "plan.json: scenes[0]: expected an object"},
        {[](SweepJson& json) { json["scenes"][1].erase("scene"); }, "plan.json: scenes[1]: it has no \"scene\""},
        {[](SweepJson& json) { json["scenes"][1]["time"] = "1"; }, "plan.json: scenes[1].time: expected a number"},
        {[](SweepJson& json) { json["scenes"][1]["envi"] = "sky"; }, "scenes[1]: unknown key 'envi'"},
        {[](SweepJson& json) { json["scenes"][1]["name"] = "builtin:exact"; }, "two scenes have the name"},
        {[](SweepJson& json) { json["scenes"][1]["planar"] = "all"; }, "--planar all: none, named or auto"},
        {[](SweepJson& json) { json["scenes"][0] = "nowhere.glb"; }, "plan.json: nowhere.glb: No such file"},
        {[](SweepJson& json) { json["scenes"][0] = "builtin:hal"; }, "plan.json: builtin:hal: no such scene"},
        {[](SweepJson& json) { json["sizes"][1] = "64"; }, "plan.json: sizes[1]: 64: expected WIDTHxHEIGHT"},
        {[](SweepJson& json) { json["sizes"][1] = "64x36"; }, "sizes[1]: the size 64x36 is there twice"},
        {[](SweepJson& json) { json["sizes"][1] = "0x36"; }, "each side must be 1 to"},
        {[](SweepJson& json) { json["configs"][0] = "fats"; }, "plan.json: configs[0]: --config fats: no preset"},
        {[](SweepJson& json) { json["configs"][1].erase("name"); }, "configs[1]: it has no \"name\""},
        {[](SweepJson& json) { json["configs"][1]["name"] = "fast"; }, "two configs have the name 'fast+screen.smooth"},
        {[](SweepJson& json) { json["configs"][1]["settings"] = 3; }, "configs[1].settings: expected an object"},
        {[](SweepJson& json) { json["configs"][1]["settings"]["screen"]["step"] = nullptr; },
         "configs[1].settings.screen.step: expected a number"},
        {[](SweepJson& json) { json["configs"][1]["settings"]["screen"]["step"] = 9999; },
         "on builtin:exact: --set screen.step"},
        {[](SweepJson& json) { json["grid"] = SweepJson::object(); }, "plan.json: grid: expected an object"},
        {[](SweepJson& json) { json["grid"]["screen.smooth"] = true; }, "grid.screen.smooth: expected a list"},
        {[](SweepJson& json) { json["grid"]["screen.smooth"][0] = {1}; }, "grid.screen.smooth[0]: expected a number"},
        {[](SweepJson& json) { json["grid"]["screen.smoth"] = {true}; }, "screen.smoth"},
        {[](SweepJson& json) { json["seeds"] = 0; }, "plan.json: seeds: expected a whole number from 1"},
        {[](SweepJson& json) {
             json["seeds"] = {1, -1};
         },
         "plan.json: seeds[1]: expected a whole number"},
        {[](SweepJson& json) {
             json["seeds"] = {1, 1};
         },
         "seeds[1]: the seed 1 is there twice"},
        {[](SweepJson& json) { json["seeds"] = {0.5}; }, "seeds[0]: expected a whole number"},
        {[](SweepJson& json) { json["reference"] = 3; }, "plan.json: reference: expected an object"},
        {[](SweepJson& json) { json["reference"]["frames"] = 0; }, "reference.frames: expected a whole number"},
        {[](SweepJson& json) { json["hits"] = 1; }, "plan.json: hits: expected true or false"},
        {[](SweepJson& json) { json["stills"] = false; }, "nothing would be measured"},
        {[](SweepJson& json) {
             json["motion"] = {{"frames", 1}};
         },
         "motion.frames: expected a whole number from 2"},
        {[](SweepJson& json) {
             json["motion"] = {{"path", "up"}};
         },
         "--path up: expected still"},
        {[](SweepJson& json) {
             json["motion"] = {{"samples", 4}}, json.erase("reference");
         },
         "plan.json: motion.samples: they need a \"reference\""},
        {[](SweepJson& json) {
             json["motion"] = {{"samples", 4}}, json["reference"]["config"] = "fast";
         },
         "4 samples need rays.enabled and rays.accumulate"},
        {[](SweepJson& json) { json["grid"]["screen.thickness"] = std::vector<double>(100000, 0.1); },
         "more than 200000"},
    };
    for (const Mistake& mistake : mistakes) {
        SweepJson json = madeUpPlan();
        mistake.change(json);
        const std::string message = wrong(json.dump());
        EXPECT_NE(message.find(mistake.message), message.npos) << message << "\nfor " << mistake.message;
        EXPECT_EQ(std::ranges::count(message, '\n'), 0) << message;
    }
    EXPECT_EQ(wrong("{\"scenes\": ["), "plan.json: this is not JSON");
}

TEST(SweepPlan, TheExampleIsAPlan) {
    const std::string text = test::must(readFile(GLINT_SOURCE_DIR "/examples/sweep/plan.json", 1 << 20));
    const std::vector<SweepJob> made = jobs(test::must(readSweepPlan(text, "plan.json")));
    EXPECT_EQ(made.size(), 32u) << "as docs/sweep.md says";
    EXPECT_EQ(names(made).size(), made.size());
}

TEST(SweepPlan, ShardsPartTheJobs) {
    for (const uint32_t count : {1u, 2u, 3u, 7u, 100u}) {
        std::vector<int> runs(48);
        for (uint32_t index = 0; index < count; ++index) {
            const Shard shard = test::must(readShard(fmt::format("{}/{}", index, count)));
            size_t own = 0;
            for (size_t job = 0; job < runs.size(); ++job)
                if (shard.has(job))
                    ++runs[job], ++own;
            EXPECT_LE(own, runs.size() / count + 1) << "shards are of one size";
        }
        EXPECT_EQ(runs, std::vector<int>(48, 1)) << count << " shards: each job in one of them";
    }
}

TEST(SweepPlan, WrongShardsAreRefused) {
    for (const char* text :
         {"", "1", "/4", "4/4", "1/0", "0/", "a/4", "0/4x", " 0/4", "-1/4", "0/4000000000", "5000000000/6"}) {
        const auto shard = readShard(text);
        ASSERT_FALSE(shard.ok()) << text;
        EXPECT_NE(shard.error().message.find("expected I/N"), std::string::npos) << shard.error().message;
    }
}

} // namespace sweep_plan_test
} // namespace glint::cli
