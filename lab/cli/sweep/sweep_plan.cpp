#include "lab/cli/sweep/sweep_plan.hpp"

#include "base/text.hpp"
#include "lab/cli/plan_place.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <set>
#include <span>

namespace glint::cli {
namespace {

constexpr int kDeepestPlanSettings = 4;
constexpr uint32_t kMostPlanFrames = 100000;
constexpr uint32_t kMostPlanSamples = 1 << 20;

/// {"screen": {"step": 4}} and {"screen.step": 4} become "screen.step=4".
Result<void> addPlanSettings(const PlanPlace& place, const std::string& prefix, int depth,
                             std::vector<std::string>& assignments) {
    if (!place.json().is_object() || depth > kDeepestPlanSettings)
        return place.wrong("an object of settings");
    for (const auto& [key, value] : place.json().items()) {
        const std::string name = prefix.empty() ? key : fmt::format("{}.{}", prefix, key);
        const PlanPlace inner = place.at(key.c_str());
        if (value.is_object())
            GLINT_CHECK(addPlanSettings(inner, name, depth + 1, assignments));
        else if (value.is_string())
            assignments.push_back(fmt::format("{}={}", name, value.get<std::string>()));
        else if (value.is_number() || value.is_boolean())
            assignments.push_back(fmt::format("{}={}", name, value.dump()));
        else
            return inner.wrong("a number, a text, true or false");
    }
    return {};
}

Result<SweepScene> readScene(const PlanPlace& place) {
    SweepScene scene;
    RenderOptions& options = scene.options;
    if (place.json().is_string()) {
        GLINT_TRY(name, place.text());
        scene.name = options.scene = std::move(name);
        return scene;
    }
    constexpr std::array<std::string_view, 9> kKeys = {"name",   "scene",  "camera", "env", "materials",
                                                       "probes", "planar", "time",   "set"};
    GLINT_CHECK(place.checkKeys(kKeys));
    if (!place.has("scene"))
        return place.says("it has no \"scene\"");
    const std::array<std::pair<const char*, std::string*>, 7> texts = {{{"scene", &options.scene},
                                                                        {"name", &scene.name},
                                                                        {"camera", &options.camera},
                                                                        {"env", &options.environment},
                                                                        {"materials", &options.materials},
                                                                        {"probes", &options.probes},
                                                                        {"planar", &options.planar}}};
    for (const auto& [key, value] : texts) {
        if (!place.has(key))
            continue;
        GLINT_TRY(text, place.at(key).text());
        *value = std::move(text);
    }
    if (place.has("time")) {
        GLINT_TRY(time, place.at("time").number(-1e9, 1e9));
        options.time = time;
    }
    if (place.has("set")) {
        GLINT_TRY(assignments, place.at("set").texts());
        options.settings.assignments = std::move(assignments);
    }
    if (scene.name.empty())
        scene.name =
            options.camera.empty() ? options.scene : fmt::format("{} camera {}", options.scene, options.camera);
    return scene;
}

Result<SweepConfig> readSweepConfig(const PlanPlace& place) {
    SweepConfig config;
    if (place.json().is_string()) {
        GLINT_TRY(request, place.config());
        config.settings = std::move(request);
        config.name = place.json().get<std::string>();
        return config;
    }
    constexpr std::array<std::string_view, 3> kKeys = {"name", "config", "settings"};
    GLINT_CHECK(place.checkKeys(kKeys));
    if (!place.has("name"))
        return place.says("it has no \"name\", which tables need");
    GLINT_TRY(name, place.at("name").text());
    config.name = std::move(name);
    if (place.has("config")) {
        GLINT_TRY(request, place.at("config").config());
        config.settings = std::move(request);
    }
    if (place.has("settings"))
        GLINT_CHECK(addPlanSettings(place.at("settings"), "", 1, config.settings.assignments));
    return config;
}

/// Multiplies the configs by each setting's values.
Result<void> expandGrid(const PlanPlace& place, std::vector<SweepConfig>& configs) {
    if (!place.json().is_object() || place.json().empty())
        return place.wrong("an object of settings, each with a list of values");
    bool first = true;
    for (const auto& [key, value] : place.json().items()) {
        const PlanPlace values = place.at(key.c_str());
        GLINT_TRY(count, values.list());
        if (configs.size() * count > kMostSweepJobs)
            return place.says(fmt::format("more than {} configs", kMostSweepJobs));
        std::vector<std::string> assignments;
        for (size_t i = 0; i < count; ++i) {
            const PlanJson& one = values.json()[i];
            if (!one.is_string() && !one.is_number() && !one.is_boolean())
                return values.at(i).wrong("a number, a text, true or false");
            assignments.push_back(fmt::format("{}={}", key, one.is_string() ? one.get<std::string>() : one.dump()));
        }
        std::vector<SweepConfig> expanded;
        expanded.reserve(configs.size() * count);
        for (const SweepConfig& config : configs)
            for (const std::string& assignment : assignments) {
                SweepConfig next = config;
                next.name +=
                    fmt::format("{}{}", first && next.name.find('=') == std::string::npos ? "+" : ",", assignment);
                next.settings.assignments.push_back(assignment);
                expanded.push_back(std::move(next));
            }
        configs = std::move(expanded);
        first = false;
    }
    return {};
}

/// A list of seeds, or how many of them from 0 on.
Result<std::vector<uint32_t>> readSeeds(const PlanPlace& place) {
    std::vector<uint32_t> seeds;
    if (place.json().is_number()) {
        GLINT_TRY(count, place.count(1, 10000));
        for (uint32_t seed = 0; seed < count; ++seed)
            seeds.push_back(seed);
        return seeds;
    }
    GLINT_TRY(count, place.list());
    for (size_t i = 0; i < count; ++i) {
        GLINT_TRY(seed, place.at(i).count(0, std::numeric_limits<uint32_t>::max()));
        if (std::ranges::find(seeds, seed) != seeds.end())
            return place.at(i).says(fmt::format("the seed {} is there twice", seed));
        seeds.push_back(seed);
    }
    return seeds;
}

Result<SweepReference> readReference(const PlanPlace& place) {
    SweepReference reference;
    if (place.json().is_string()) {
        GLINT_TRY(config, readSweepConfig(place));
        reference.config = std::move(config);
        return reference;
    }
    constexpr std::array<std::string_view, 3> kKeys = {"config", "frames", "seed"};
    GLINT_CHECK(place.checkKeys(kKeys));
    if (!place.has("config"))
        return place.says("it has no \"config\"");
    GLINT_TRY(config, readSweepConfig(place.at("config")));
    reference.config = std::move(config);
    if (place.has("frames")) {
        GLINT_TRY(frames, place.at("frames").count(1, kMostPlanFrames));
        reference.frames = frames;
    }
    if (place.has("seed")) {
        GLINT_TRY(seed, place.at("seed").count(0, std::numeric_limits<uint32_t>::max()));
        reference.seed = seed;
    }
    return reference;
}

Result<SweepMotion> readMotion(const PlanPlace& place) {
    constexpr std::array<std::string_view, 6> kKeys = {"path", "speed", "stop", "frames", "fps", "samples"};
    GLINT_CHECK(place.checkKeys(kKeys));
    SweepMotion motion;
    if (place.has("path")) {
        GLINT_TRY(path, place.at("path").text());
        motion.path = std::move(path);
    }
    if (place.has("speed")) {
        GLINT_TRY(speed, place.at("speed").number(-1000, 1000));
        motion.speed = speed;
    }
    if (place.has("stop")) {
        GLINT_TRY(stop, place.at("stop").count(0, kMostPlanFrames));
        motion.stop = stop;
    }
    if (place.has("frames")) {
        GLINT_TRY(frames, place.at("frames").count(2, 10000));
        motion.frames = frames;
    }
    if (place.has("fps")) {
        GLINT_TRY(fps, place.at("fps").number(1, 1000));
        motion.fps = fps;
    }
    if (place.has("samples")) {
        GLINT_TRY(samples, place.at("samples").count(0, kMostPlanSamples));
        motion.samples = samples;
    }
    return motion;
}

/// No two entries have one name, as tables could not tell them apart.
template <class Entries>
Result<void> checkNames(const Entries& entries, const std::string& where, std::string_view what) {
    std::set<std::string_view> names;
    for (const auto& entry : entries)
        if (!names.insert(entry.name).second)
            return invalidInput("{} {}: two {} have the name '{}'; give one another \"name\"", where, what, what,
                                printable(entry.name));
    return {};
}

Result<std::vector<std::string>> readSizes(const PlanPlace& place) {
    GLINT_TRY(sizes, place.texts());
    for (size_t i = 0; i < sizes.size(); ++i) {
        GLINT_CHECK(place.at(i).size());
        if (std::ranges::find(sizes.begin(), sizes.begin() + static_cast<std::ptrdiff_t>(i), sizes[i]) !=
            sizes.begin() + static_cast<std::ptrdiff_t>(i))
            return place.at(i).says(fmt::format("the size {} is there twice", printable(sizes[i])));
    }
    return sizes;
}

Result<void> readConfigs(const PlanPlace& root, SweepPlan& plan) {
    GLINT_TRY(count, root.at("configs").list());
    for (size_t i = 0; i < count; ++i) {
        GLINT_TRY(config, readSweepConfig(root.at("configs").at(i)));
        plan.configs.push_back(std::move(config));
    }
    if (root.has("grid"))
        GLINT_CHECK(expandGrid(root.at("grid"), plan.configs));
    return checkNames(plan.configs, root.name(), "configs");
}

/// What every config and the reference have in common: weaker than their own.
void addCommon(const std::vector<std::string>& common, SweepPlan& plan) {
    for (SweepScene& scene : plan.scenes)
        scene.options.settings.assignments.insert(scene.options.settings.assignments.begin(), common.begin(),
                                                  common.end());
}

Result<void> readMeasures(const PlanPlace& root, SweepPlan& plan) {
    const std::array<std::pair<const char*, bool*>, 2> flags = {{{"stills", &plan.stills}, {"hits", &plan.hits}}};
    for (const auto& [key, value] : flags) {
        if (!root.has(key))
            continue;
        GLINT_TRY(flag, root.at(key).flag());
        *value = flag;
    }
    if (root.has("frames")) {
        GLINT_TRY(frames, root.at("frames").count(1, 10000));
        plan.frames = frames;
    }
    if (root.has("reference")) {
        GLINT_TRY(reference, readReference(root.at("reference")));
        plan.reference = std::move(reference);
    }
    if (root.has("motion")) {
        GLINT_TRY(motion, readMotion(root.at("motion")));
        plan.motion = std::move(motion);
    }
    if (!plan.stills && !plan.motion)
        return root.says("\"stills\" is false and there is no \"motion\": nothing would be measured");
    if (plan.motion && plan.motion->samples > 0 && !plan.reference)
        return root.at("motion").at("samples").says("they need a \"reference\"");
    return {};
}

} // namespace

Result<SweepPlan> readSweepPlan(std::string_view text, const std::string& name) {
    const PlanJson json = PlanJson::parse(text, nullptr, false);
    if (json.is_discarded())
        return invalidInput("{}: this is not JSON", printable(name));
    const PlanPlace root(json, printable(name) + ":");
    constexpr std::array<std::string_view, 12> kKeys = {"description", "scenes", "sizes",  "configs",
                                                        "grid",        "set",    "seeds",  "reference",
                                                        "stills",      "hits",   "frames", "motion"};
    GLINT_CHECK(root.checkKeys(kKeys));
    for (const char* required : {"scenes", "configs"})
        if (!root.has(required))
            return root.says(fmt::format("it has no \"{}\"", required));
    SweepPlan plan;
    GLINT_TRY(scenes, root.at("scenes").list());
    for (size_t i = 0; i < scenes; ++i) {
        GLINT_TRY(scene, readScene(root.at("scenes").at(i)));
        plan.scenes.push_back(std::move(scene));
    }
    GLINT_CHECK(checkNames(plan.scenes, root.name(), "scenes"));
    plan.sizes = {""};
    if (root.has("sizes")) {
        GLINT_TRY(sizes, readSizes(root.at("sizes")));
        plan.sizes = std::move(sizes);
    }
    GLINT_CHECK(readConfigs(root, plan));
    if (root.has("set")) {
        GLINT_TRY(common, root.at("set").texts());
        addCommon(common, plan);
    }
    plan.seeds = {0};
    if (root.has("seeds")) {
        GLINT_TRY(seeds, readSeeds(root.at("seeds")));
        plan.seeds = std::move(seeds);
    }
    GLINT_CHECK(readMeasures(root, plan));
    // The product of six numbers of at most 1e5 each fits into a double's range, not into 64 bits.
    const double jobs = double(plan.scenes.size()) * double(plan.sizes.size()) * double(plan.configs.size()) *
                        double(plan.seeds.size() + 1);
    if (jobs > 2.0 * kMostSweepJobs || plan.jobCount() > kMostSweepJobs)
        return root.says(fmt::format("more than {} jobs; part the plan into several", kMostSweepJobs));
    return plan;
}

} // namespace glint::cli
