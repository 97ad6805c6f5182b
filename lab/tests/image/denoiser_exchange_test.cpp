// Denoisers of other programs: what `glint sequence --dump` gives them, and the figures of what they give back
// (`--config frames=...`), by the program itself.
#include "base/file.hpp"
#include "lab/cli/program.hpp"
#include "lab/scene/images/exr_channels.hpp"
#include "lab/scene/images/image_file.hpp"
#include "tests/support/must.hpp"
#include "tests/support/temp_folder.hpp"

#include <glm/glm.hpp>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace glint::test {
namespace denoiser_exchange_test {

using Json = nlohmann::json;
using testing::HasSubstr;

struct Ended {
    int code = 0;
    std::string error;
};

/// `glint sequence ...` at a size of 64x36; any message of the validation layer is an error.
Ended sequence(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"glint", "sequence"});
    arguments.insert(arguments.end(), {"--size", "64x36", "--validate"});
    std::vector<const char*> argv;
    for (const std::string& argument : arguments)
        argv.push_back(argument.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    Ended ended;
    ended.code = cli::runProgram(static_cast<int>(argv.size()), argv.data(), {});
    testing::internal::GetCapturedStdout();
    ended.error = testing::internal::GetCapturedStderr();
    return ended;
}

void mustRun(const std::vector<std::string>& arguments) {
    const Ended ended = sequence(arguments);
    ASSERT_EQ(ended.code, cli::kDone) << ended.error;
}

std::string textOf(const std::string& path) {
    return must(readFile(path, size_t{1} << 24));
}

/// Every channel of a file, by name.
std::map<std::string, std::vector<float>> channelsOf(const std::string& path) {
    const scene::ExrChannels file = must(scene::ExrChannels::open(path));
    std::vector<size_t> all(file.names().size());
    for (size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    std::vector<std::vector<float>> planes = must(file.read(all));
    std::map<std::string, std::vector<float>> channels;
    for (size_t i = 0; i < all.size(); ++i)
        channels.emplace(file.names()[i], std::move(planes[i]));
    return channels;
}

/// Another program: writes channels of its own making.
void writeFrame(const std::string& path, const std::string& layer, const std::array<std::vector<float>, 3>& rgb,
                uint32_t width = 64) {
    std::vector<scene::ExrLayer> layers;
    for (size_t c = 0; c < 3; ++c)
        layers.push_back({layer, std::string(1, "RGB"[c]), false, rgb[c], 1});
    must(scene::writeExr(path, width, static_cast<uint32_t>(rgb[0].size() / width), layers));
}

const std::vector<std::string> kMoving = {
    "builtin:motion-objects", "--path", "dolly", "--frames", "4", "--warm-up", "1"};
const std::vector<std::string> kReference = {"--reference-samples", "1", "--reference", "reuse.rate=full"};

std::vector<std::string> operator+(std::vector<std::string> a, const std::vector<std::string>& b) {
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// Frames are computed as half floats, so their files lose nothing and no figure differs by a bit.
TEST(DenoiserExchange, OurOwnFramesHaveTheFiguresOfTheRun) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    const std::string a = folder + "a%04d.exr", b = folder + "b%04d.exr";
    mustRun(kMoving + kReference + std::vector<std::string>{"--seed", "1", "-o", a, "--json", folder + "run.json"});
    mustRun(kMoving + std::vector<std::string>{"--seed", "2", "-o", b});
    mustRun(kMoving + kReference +
            std::vector<std::string>{"--seed", "1", "--config", "frames=" + a + ":" + b, "--config", "frames=" + b,
                                     "--json", folder + "files.json"});
    const Json run = Json::parse(textOf(folder + "run.json"))["configs"][0]["figures"];
    const Json files = Json::parse(textOf(folder + "files.json"))["configs"];
    ASSERT_EQ(files.size(), 2u);
    EXPECT_EQ(files[0]["storedSeeds"], 2);
    EXPECT_EQ(files[0]["figures"], run);
    EXPECT_GT(run["reflection"]["all"]["noise"]["mean"], 0);
    EXPECT_GT(run["reflection"]["all"]["flicker"]["mean"], 0);
    EXPECT_GT(run["composite"]["rough"]["relMse"]["mean"], 0);
    // One seed has no noise to tell apart.
    const Json& one = files[1]["figures"]["reflection"]["all"];
    EXPECT_EQ(files[1]["storedSeeds"], 1);
    EXPECT_TRUE(one["bias"]["mean"].is_null());
    EXPECT_TRUE(one["noise"]["mean"].is_null());
    EXPECT_TRUE(one["flicker"]["mean"].is_null());
    EXPECT_GT(one["relMse"]["mean"], 0);
    EXPECT_GT(one["energy"]["mean"], 0.5);
}

TEST(DenoiserExchange, FramesThatDoNotFitAreOneLine) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    const std::vector<float> some(64 * 36, 0.5f);
    std::vector<float> bad = some;
    bad[64] = std::nanf("");
    for (const char* name : {"a0.exr", "a1.exr", "b0.exr"})
        writeFrame(folder + name, "reflection", {some, some, some});
    writeFrame(folder + "b1.exr", "reflection", {some, bad, some});
    const std::vector<float> few(4, 0.5f);
    for (const char* name : {"c0.exr", "c1.exr", "d0.exr", "d1.exr"})
        writeFrame(folder + name, "", {few, few, few}, 2);
    const auto expectError = [&](const std::string& frames, const std::string& part) {
        const Ended ended = sequence({"builtin:motion-still", "--frames", "2", "--config", frames});
        EXPECT_EQ(ended.code, cli::kBadInput);
        EXPECT_THAT(ended.error, HasSubstr(part));
        EXPECT_EQ(std::ranges::count(ended.error, '\n'), 1) << ended.error;
    };
    const std::string a = folder + "a%d.exr";
    expectError("frames=" + a + ":" + folder + "b%d.exr", "b1.exr: channel reflection.G of pixel 0, 1 is nan");
    expectError("frames=" + a + ":" + folder + "c%d.exr", "c0.exr: it has no layer reflection, unlike");
    expectError("frames=" + folder + "c%d.exr:" + folder + "d%d.exr",
                "frames of 2x2, but the sequence has 64x36: state --size 2x2");
    expectError("frames=" + a, "frames of one seed have no figures without a reference");
}

TEST(DenoiserExchange, TheDumpOfACommandIsTheSameEachTime) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    for (const char* name : {"once", "twice"})
        mustRun(kMoving + std::vector<std::string>{"--seed", "5", "--dump", folder + name});
    for (const char* file : {"0000.exr", "0003.exr", "sequence.json"})
        EXPECT_TRUE(textOf(folder + "once/seed-5/" + file) == textOf(folder + "twice/seed-5/" + file)) << file;
    EXPECT_FALSE(textOf(folder + "once/seed-5/0001.exr") == textOf(folder + "once/seed-5/0002.exr"));
}

glm::mat4 matrixOf(const Json& rows) {
    glm::mat4 matrix;
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            matrix[column][row] = rows[size_t(row)][size_t(column)];
    return matrix;
}

/// A point of the screen, (0, 0) at the top left.
glm::vec2 toUV(const glm::vec4& clip) {
    return {0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w};
}

/// Matrices, depth and motion of a scene that stands still lead each pixel to the same place in the frame before.
TEST(DenoiserExchange, TheDumpsCamerasDepthAndMotionAgree) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    mustRun({"builtin:motion-still", "--path", "truck", "--speed", "3", "--frames", "2", "--seed", "5", "--dump",
             folder + "dump/"});
    const Json sequence = Json::parse(textOf(folder + "dump/seed-5/sequence.json"));
    ASSERT_EQ(sequence["frames"].size(), 2u);
    EXPECT_EQ(sequence["seed"], 5);
    EXPECT_EQ(sequence["width"], 64);
    const Json& frame = sequence["frames"][1];
    EXPECT_EQ(frame["prevWorldToView"], sequence["frames"][0]["worldToView"]);
    EXPECT_NE(frame["prevWorldToView"], frame["worldToView"]);
    EXPECT_NEAR(frame["secondsSincePrevious"], 1.0 / 60, 1e-9);
    const glm::mat4 viewToClip = matrixOf(frame["viewToClip"]), viewToWorld = inverse(matrixOf(frame["worldToView"]));
    const glm::mat4 prevWorldToClip = matrixOf(frame["prevViewToClip"]) * matrixOf(frame["prevWorldToView"]);
    auto layers = channelsOf(folder + "dump/seed-5/" + std::string(frame["file"]));
    size_t surfaces = 0, wrong = 0, turnedAway = 0;
    float farthest = 0, deepest = 0;
    for (size_t p = 0; p < size_t{64} * 36; ++p) {
        const float viewZ = layers["depth.Z"][p];
        if (viewZ == 0)
            continue;
        ++surfaces;
        const glm::vec2 uv((float(p % 64) + 0.5f) / 64, (float(p / 64) + 0.5f) / 36);
        const glm::vec4 positionVS(viewZ * (2 * uv.x - 1) / viewToClip[0][0], viewZ * (1 - 2 * uv.y) / viewToClip[1][1],
                                   -viewZ, 1);
        const glm::vec4 positionWS = viewToWorld * positionVS;
        const glm::vec2 motion(layers["motion.X"][p], layers["motion.Y"][p]);
        wrong += glm::distance(toUV(prevWorldToClip * positionWS), uv + motion) > 1e-4f;
        const float prevZ = -(matrixOf(frame["prevWorldToView"]) * positionWS).z;
        wrong += std::abs(prevZ - viewZ - layers["motion.Z"][p]) > 1e-3f * viewZ;
        deepest = std::max(deepest, std::abs(layers["motion.Z"][p]));
        farthest = std::max(farthest, glm::length(motion * glm::vec2(64, 36)));
        const glm::vec3 normalWS(layers["normal.X"][p], layers["normal.Y"][p], layers["normal.Z"][p]);
        turnedAway += glm::dot(normalWS, glm::vec3(viewToWorld[3] - positionWS)) < 0;
    }
    EXPECT_GT(surfaces, 1000u);
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(turnedAway, 0u);
    EXPECT_LT(deepest, 0.01f) << "to the side";
    EXPECT_GT(farthest, 1); // what is near moves by more than the 3 pixels of the centre
}

/// Our denoiser passes mirrors untouched where rays have one bounce: there the noisy signal and the rest are the
/// reflection itself. What it averages elsewhere has the mean of the signal.
TEST(DenoiserExchange, TheNoisySignalAndTheRestMakeTheReflection) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    constexpr size_t kFrames = 8;
    mustRun({"builtin:thickness", "--frames", std::to_string(kFrames), "--set", "reuse.rate=full", "--dump",
             folder + "dump", "-o", folder + "own%04d.exr"});
    size_t mirrors = 0, wrong = 0, sent = 0;
    double rest = 0, ours = 0, theirs = 0;
    for (size_t i = 0; i < kFrames; ++i) {
        auto dump = channelsOf(folder + fmt::format("dump/seed-0/{:04}.exr", i));
        auto own = channelsOf(folder + fmt::format("own{:04}.exr", i));
        for (size_t p = 0; p < size_t{64} * 36; ++p) {
            if (dump["reflectivity.R"][p] == 0)
                continue;
            sent += dump["raySent.Y"][p] == 1;
            for (const char channel : {'R', 'G', 'B'}) {
                const float reflection = own[std::string("reflection.") + channel][p];
                const float other = dump[std::string("rest.") + channel][p];
                const float whole = dump[std::string("noisy.") + channel][p] + other;
                rest += other;
                ours += reflection;
                theirs += whole;
                if (dump["roughness.Y"][p] >= 0.005f) // narrower than a pixel at this size
                    continue;
                ++mirrors;
                wrong += std::abs(whole - reflection) > 0.002f * std::max(reflection, 1.0f);
            }
        }
    }
    EXPECT_GT(mirrors, 1000u);
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(sent, 1000u);
    EXPECT_GT(rest, 0.05 * ours); // the sky, where the screen shows nothing
    EXPECT_NEAR(theirs / ours, 1, 0.1);
}

/// A denoiser that does nothing: the figures see its noise, and that nothing is missing.
TEST(DenoiserExchange, TheDumpComesBackAsAnotherDenoisersFrames) {
    const TempFolder temp;
    const std::string& folder = temp.path();
    const std::vector<std::string> scene = {"builtin:motion-still", "--frames", "6", "--set", "reuse.rate=full",
                                            "--reference-samples",  "1"};
    mustRun(scene + std::vector<std::string>{"--reference", "balanced", "--json", folder + "own.json", "--dump",
                                             folder + "dump"});
    for (const int seed : {0, 1})
        for (int i = 0; i < 6; ++i) {
            auto dump = channelsOf(folder + fmt::format("dump/seed-{}/{:04}.exr", seed, i));
            std::array<std::vector<float>, 3> rgb;
            for (size_t c = 0; c < 3; ++c) {
                rgb[c] = dump[std::string("noisy.") + "RGB"[c]];
                std::ranges::transform(rgb[c], dump[std::string("rest.") + "RGB"[c]], rgb[c].begin(), std::plus<>());
            }
            writeFrame(folder + fmt::format("{}-{:02}.exr", seed, i), "reflection", rgb);
        }
    mustRun(scene + std::vector<std::string>{"--reference", "balanced", "--json", folder + "theirs.json", "--config",
                                             "frames=" + folder + "0-%02d.exr:" + folder + "1-%02d.exr"});
    const Json own = Json::parse(textOf(folder + "own.json"))["configs"][0]["figures"];
    const Json theirs = Json::parse(textOf(folder + "theirs.json"))["configs"][0]["figures"];
    EXPECT_FALSE(theirs.contains("composite"));
    const Json& rough = theirs["reflection"]["rough"];
    EXPECT_GT(double(rough["noise"]["mean"]), 4 * double(own["reflection"]["rough"]["noise"]["mean"]));
    EXPECT_GT(double(rough["flicker"]["mean"]), 4 * double(own["reflection"]["rough"]["flicker"]["mean"]));
    EXPECT_NEAR(rough["energy"]["mean"], own["reflection"]["rough"]["energy"]["mean"], 0.05);
}

} // namespace denoiser_exchange_test
} // namespace glint::test
