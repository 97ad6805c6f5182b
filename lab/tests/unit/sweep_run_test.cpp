// Jobs of a sweep run without a device: what is kept, what is made again, what fails, and the tables that result.
#include "lab/cli/sweep/sweep_run.hpp"

#include "base/file.hpp"
#include "base/log.hpp"
#include "lab/cli/sweep/sweep_tables.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>

namespace glint::cli {
namespace sweep_run_test {

constexpr const char* kRunPlan = R"({
    "scenes": ["builtin:exact", "builtin:hall"], "sizes": ["64x36"], "seeds": 2,
    "configs": ["fast", {"name": "a \"quoted\", name", "config": "quality"}]})";

/// Warnings of failed jobs are part of these tests, not of their output.
class NoWarnings {
public:
    NoWarnings() {
        log::setSink([](std::string_view, void*) {}, nullptr);
    }
    ~NoWarnings() { log::setSink(nullptr, nullptr); }
    NoWarnings(const NoWarnings&) = delete;
    NoWarnings& operator=(const NoWarnings&) = delete;
};

class SweepRun : public testing::Test {
protected:
    SweepRun() {
        jobs_ = test::must(makeSweepJobs(test::must(readSweepPlan(kRunPlan, "plan.json")), "glint", "plan.json"));
        start(folder_);
    }

    void start(const SweepFolder& folder) const {
        test::must(folder.create());
        test::must(folder.writeList("glint", "plan.json", jobs_));
    }

    /// A result that depends on the job alone, but for the times.
    SweepResult resultOf(const SweepJob& job) const {
        SweepResult result;
        result.description = job.description;
        result.program = "glint";
        result.device = device_;
        result.driver = "driver 1";
        result.width = 64;
        result.height = 36;
        const double quality = job.description["config"] == "fast" ? 1 : 0.5;
        result.figures = {{"error.flip", 0.1 * quality + 0.01 * job.config.job.seed}, {"cost.floors", 10 / quality}};
        if (job.description["scene"] == "builtin:exact")
            result.figures["exact.oneBounceWrong"] = 0.25;
        result.run = {{"host", "here"}, {"seconds", ++measured_}, {"effectMs", 0.5}};
        return result;
    }

    /// Runs the shard's jobs; those whose names are in `fail` fail.
    SweepFailures run(const SweepFolder& folder, const std::string& shard = "0/1", const std::string& fail = {}) const {
        return test::must(runSweepJobs(folder, pendingJobs(folder, jobs_, test::must(readShard(shard))),
                                       [&](const SweepJob& job) -> Result<SweepResult> {
                                           order_.push_back(job.name);
                                           if (job.name == fail)
                                               return makeError(ErrorCode::OutOfMemory, "not enough memory");
                                           return resultOf(job);
                                       }));
    }

    std::vector<std::string> files(const std::string& folder) const {
        std::vector<std::string> names;
        for (const auto& entry : std::filesystem::directory_iterator(temp_ + "sweep/" + folder))
            names.push_back(entry.path().filename().string());
        std::ranges::sort(names);
        return names;
    }
    std::string resultFile(size_t job) const { return temp_ + "sweep/jobs/" + jobs_[job].name + ".json"; }

    static std::vector<std::string> tables(const SweepFolder& folder) {
        test::must(writeSweepTables(folder, test::must(readSweepTables(folder))));
        std::vector<std::string> texts;
        for (const char* name : {"/table.json", "/table.csv", "/index.html"})
            texts.push_back(test::must(readFile(folder.path() + name, size_t{1} << 24)));
        return texts;
    }

    const test::TempFolder temp_;
    const SweepFolder folder_{temp_ + "sweep"};
    const NoWarnings noWarnings_;
    std::string device_ = "device";
    std::vector<SweepJob> jobs_;
    mutable std::vector<std::string> order_; ///< jobs in the order in which they ran
    mutable int measured_ = 0;
};

TEST_F(SweepRun, WhatIsDoneIsNotDoneAgain) {
    EXPECT_EQ(run(folder_, "1/2").count, 0u);
    EXPECT_EQ(order_, (std::vector{jobs_[1].name, jobs_[3].name, jobs_[5].name, jobs_[7].name}));
    EXPECT_EQ(files("jobs").size(), 4u) << "and nothing else is left there";
    EXPECT_TRUE(files("failed").empty());
    order_.clear();
    run(folder_);
    EXPECT_EQ(order_, (std::vector{jobs_[0].name, jobs_[2].name, jobs_[4].name, jobs_[6].name}));
    order_.clear();
    run(folder_);
    EXPECT_TRUE(order_.empty());
}

TEST_F(SweepRun, DamagedResultsAreMadeAgain) {
    run(folder_);
    const std::string whole = test::must(readFile(resultFile(2), 1 << 20));
    const SweepJson json = SweepJson::parse(whole);
    std::vector<std::string> damaged = {"", "{}", "null", "[1]", whole.substr(0, whole.size() / 2), whole + "x"};
    const auto changed = [&](const char* key, SweepJson value) {
        SweepJson other = json;
        other[key] = std::move(value);
        damaged.push_back(other.dump());
    };
    changed("format", "glint sweep result 0");
    changed("job", jobs_[3].description);
    changed("figures", {{"error.flip", nullptr}});
    changed("figures", {{"error.flip", "0.1"}});
    changed("width", 0);
    changed("height", 100000);
    changed("device", "device");
    changed("run", 3);
    for (const std::string& text : damaged) {
        ASSERT_TRUE(writeFile(resultFile(2), text));
        order_.clear();
        run(folder_);
        EXPECT_EQ(order_, std::vector{jobs_[2].name}) << text;
    }
}

TEST_F(SweepRun, AFailureStopsNoOtherJob) {
    const SweepFailures failures = run(folder_, "0/1", jobs_[1].name);
    EXPECT_EQ(failures.count, 1u);
    EXPECT_EQ(failures.first, "builtin:exact, 64x36, fast, seed 1: not enough memory");
    EXPECT_EQ(order_.size(), jobs_.size());
    EXPECT_EQ(files("failed"), std::vector{jobs_[1].name + ".json"});
    EXPECT_EQ(folder_.readFailure(jobs_[1].name), "not enough memory");
    std::filesystem::remove(resultFile(5));
    order_.clear();
    EXPECT_EQ(run(folder_).count, 0u);
    EXPECT_EQ(order_, (std::vector{jobs_[5].name, jobs_[1].name})) << "what failed is tried again, last";
    EXPECT_TRUE(files("failed").empty());
}

TEST_F(SweepRun, AJobThatEndsTheProcessIsTriedLast) {
    struct Ended {};
    const auto end = [&](const SweepJob& job) -> Result<SweepResult> {
        if (job.name == jobs_[1].name)
            throw Ended();
        return resultOf(job);
    };
    const Shard all;
    EXPECT_THROW((void)runSweepJobs(folder_, pendingJobs(folder_, jobs_, all), end), Ended);
    EXPECT_EQ(files("jobs").size(), 1u);
    EXPECT_NE(folder_.readFailure(jobs_[1].name).find("process ended"), std::string::npos);
    EXPECT_THROW((void)runSweepJobs(folder_, pendingJobs(folder_, jobs_, all), end), Ended);
    EXPECT_EQ(files("jobs").size(), jobs_.size() - 1) << "it held up no other one";
}

TEST_F(SweepRun, AFolderThatCannotBeWrittenEndsTheRun) {
    std::filesystem::remove_all(temp_ + "sweep/jobs");
    const auto ended = runSweepJobs(folder_, pendingJobs(folder_, jobs_, {}),
                                    [&](const SweepJob& job) -> Result<SweepResult> { return resultOf(job); });
    ASSERT_FALSE(ended.ok());
    EXPECT_NE(ended.error().message.find("jobs/"), std::string::npos) << ended.error().message;
}

TEST_F(SweepRun, TablesDoNotDependOnWhoRanTheJobs) {
    run(folder_);
    const SweepFolder shards(temp_ + "shards");
    start(shards);
    for (const char* shard : {"2/3", "0/3", "1/3"})
        run(shards, shard);
    EXPECT_EQ(tables(folder_), tables(shards));
    EXPECT_NE(test::must(readFile(folder_.path() + "/times.csv", 1 << 20)),
              test::must(readFile(shards.path() + "/times.csv", 1 << 20)))
        << "the times differ, so the test can fail";
}

TEST_F(SweepRun, TablesHaveEveryJobAndMeansOverSeeds) {
    run(folder_);
    const SweepTables read = test::must(readSweepTables(folder_));
    EXPECT_EQ(read.missing(), 0u);
    EXPECT_EQ(read.devices(), std::vector<std::string>{"device, driver 1"});
    const SweepJson json = sweepTableJson(read);
    ASSERT_EQ(json["rows"].size(), 8u);
    EXPECT_EQ(json["rows"][3]["config"], "a \"quoted\", name");
    EXPECT_EQ(json["rows"][3]["seed"], 1);
    EXPECT_EQ(json["rows"][3]["figures"]["cost.floors"], 20);
    ASSERT_EQ(json["means"].size(), 4u) << "scenes and configs";
    const SweepJson& mean = json["means"][0];
    EXPECT_EQ(mean["seeds"], 2);
    EXPECT_NEAR(mean["figures"]["error.flip"]["mean"].get<double>(), 0.105, 1e-12);
    EXPECT_NEAR(mean["figures"]["error.flip"]["standardError"].get<double>(), 0.005, 1e-12);
    EXPECT_FALSE(json["means"][2]["figures"].contains("exact.oneBounceWrong")) << "not known of that scene";

    const std::string csv = sweepTableCsv(read);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 9);
    EXPECT_EQ(csv.substr(0, csv.find("\r\n")),
              "job,kind,scene,width,height,config,seed,cost.floors,error.flip,exact.oneBounceWrong");
    EXPECT_NE(csv.find(",\"a \"\"quoted\"\", name\",1,20.0,"), csv.npos) << csv;
    EXPECT_NE(csv.find("fast,0,10.0,0.1,\r\n"), csv.npos) << "unknown figures are empty";
    const std::string page = sweepPage(json, "<plan>");
    EXPECT_NE(page.find("<title>Glint sweep: &lt;plan&gt;</title>"), page.npos);
    EXPECT_EQ(page.find("<plan>"), page.npos);
}

TEST_F(SweepRun, MissingResultsAreKnown) {
    run(folder_, "0/2", jobs_[2].name);
    const SweepTables read = test::must(readSweepTables(folder_));
    EXPECT_EQ(read.missing(), 5u);
    EXPECT_EQ(read.rows[2].failure, "not enough memory");
    EXPECT_EQ(read.rows[1].failure, "");
    EXPECT_EQ(sweepTableJson(read)["missing"].size(), 5u);
    EXPECT_EQ(sweepTableJson(read)["rows"].size(), 3u);
}

TEST_F(SweepRun, OtherDevicesAreKnown) {
    run(folder_, "0/2");
    device_ = "another";
    run(folder_, "1/2");
    EXPECT_EQ(test::must(readSweepTables(folder_)).devices(),
              (std::vector<std::string>{"another, driver 1", "device, driver 1"}));
}

TEST_F(SweepRun, DamagedListsAreRefused) {
    const std::string list = temp_ + "sweep/sweep.json";
    const std::string whole = test::must(readFile(list, 1 << 20));
    for (const std::string& text :
         {std::string("{"), std::string("{}"), whole.substr(0, whole.size() / 2),
          std::string(R"({"format": "glint sweep 1", "program": "", "plan": "", "jobs": [1]})")}) {
        ASSERT_TRUE(writeFile(list, text));
        const auto read = folder_.readList();
        ASSERT_FALSE(read.ok()) << text;
        EXPECT_EQ(read.error().code, ErrorCode::InvalidInput);
        EXPECT_NE(read.error().message.find("no list of a sweep's jobs"), std::string::npos);
    }
    std::filesystem::remove(list);
    EXPECT_EQ(folder_.readList().error().code, ErrorCode::NotFound);
}

TEST_F(SweepRun, TheListIsWrittenOnce) {
    const auto written = std::filesystem::last_write_time(temp_ + "sweep/sweep.json");
    start(folder_);
    EXPECT_EQ(std::filesystem::last_write_time(temp_ + "sweep/sweep.json"), written);
    jobs_.pop_back();
    start(folder_);
    EXPECT_EQ(test::must(folder_.readList()).jobs.size(), jobs_.size()) << "a changed plan replaces it";
}

TEST_F(SweepRun, ReferencesAreKeptToTheBit) {
    measure::ReferenceImages images;
    for (int i = 0; i < 3 * 2; ++i) {
        for (const int byte : {10, 20, 30})
            images.displayed.push_back(static_cast<uint8_t>(byte + i));
        for (const float value : {0.1f, 1e-40f, 1e30f, 0.0f})
            images.radiance.push_back(value * static_cast<float>(i + 1));
        for (std::vector<float>* view : {&images.roughness, &images.reflectivity})
            view->insert(view->end(), {0.3f * static_cast<float>(i), 0, 0, 0});
    }
    EXPECT_FALSE(folder_.hasReference("abc"));
    ASSERT_TRUE(folder_.writeReference("abc", images, 3, 2));
    EXPECT_TRUE(folder_.hasReference("abc"));
    const auto read = folder_.readReference("abc", 3, 2);
    ASSERT_TRUE(read.has_value());
    EXPECT_EQ(read->displayed, images.displayed);
    EXPECT_EQ(read->radiance, images.radiance);
    EXPECT_EQ(read->roughness, images.roughness);
    EXPECT_EQ(read->reflectivity, images.reflectivity);

    EXPECT_FALSE(folder_.readReference("abc", 2, 3).has_value()) << "another size of as many pixels";
    EXPECT_FALSE(folder_.readReference("abc", 3, 3).has_value());
    EXPECT_FALSE(folder_.readReference("abd", 3, 2).has_value());
    const std::string file = temp_ + "sweep/references/abc.reference";
    const std::string whole = test::must(readFile(file, 1 << 20));
    for (size_t at = 0; at < whole.size(); at += 7) {
        std::string damaged = whole;
        damaged[at] = static_cast<char>(damaged[at] ^ 4);
        ASSERT_TRUE(writeFile(file, damaged));
        EXPECT_FALSE(folder_.readReference("abc", 3, 2).has_value()) << "byte " << at;
    }
    ASSERT_TRUE(writeFile(file, whole.substr(0, whole.size() - 1)));
    EXPECT_FALSE(folder_.readReference("abc", 3, 2).has_value());
}

} // namespace sweep_run_test
} // namespace glint::cli
