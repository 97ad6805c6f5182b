#include "lab/cli/sequence/feed_files.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "lab/cli/render/render_options.hpp"
#include "lab/scene/images/image_file.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>

namespace glint::cli {
namespace {

using FeedJson = nlohmann::ordered_json;

std::string frameName(uint32_t index) {
    return fmt::format("{:04}.exr", index);
}

FeedJson matrixJson(const glm::mat4& matrix) {
    FeedJson rows = FeedJson::array();
    for (int row = 0; row < 4; ++row)
        rows.push_back({matrix[0][row], matrix[1][row], matrix[2][row], matrix[3][row]});
    return rows;
}

FeedJson layersJson() {
    FeedJson layers = FeedJson::array();
    for (const measure::FeedLayer& layer : measure::feedLayers())
        layers.push_back(
            {{"name", layer.name}, {"channels", layer.channels}, {"unit", layer.unit}, {"meaning", layer.meaning}});
    return layers;
}

FeedJson conventionsJson() {
    return {{"axes", "right-handed, metres; +Y up in the world; view space looks down -Z"},
            {"matrices", "lists of rows, for column vectors: clip = viewToClip * worldToView * position"},
            {"clip", "+Y up, depth reversed: 1 near, 0 infinitely far"},
            {"pixels", "rows from the top; UV (0, 0) top left, (1, 1) bottom right; pixel centres at .5"},
            {"colour", "linear, Rec.709 primaries"},
            {"result", "layer 'reflection' (R, G, B): the denoised weight * radiance plus layer 'rest'"}};
}

FeedJson framesJson(const std::vector<measure::SequenceMoment>& moments) {
    FeedJson frames = FeedJson::array();
    for (size_t i = 0; i < moments.size(); ++i) {
        const measure::SequenceMoment& now = moments[i];
        const measure::SequenceMoment& previous = moments[i > 0 ? i - 1 : 0];
        frames.push_back({{"index", i},
                          {"file", frameName(static_cast<uint32_t>(i))},
                          {"seconds", now.seconds},
                          {"secondsSincePrevious", now.seconds - previous.seconds},
                          {"worldToView", matrixJson(now.view.worldToView)},
                          {"viewToClip", matrixJson(now.view.viewToClip)},
                          {"prevWorldToView", matrixJson(previous.view.worldToView)},
                          {"prevViewToClip", matrixJson(previous.view.viewToClip)}});
    }
    return frames;
}

/// True if the denoiser gets something.
bool feedsDenoiser(const Settings& settings) {
    const bool sampled = settings.screen.enabled || settings.rays.enabled;
    const bool accumulates = settings.rays.enabled && settings.rays.accumulate;
    return settings.denoise.enabled && sampled && !accumulates && settings.reflect.strength > 0;
}

} // namespace

FeedFiles::FeedFiles(std::string folder, const measure::SequencePlan& plan) : folder_(std::move(folder)) {
    const uint32_t seed = plan.configs.front().job.seed;
    seeds_.push_back(seed);
    if (plan.measure)
        seeds_.push_back(seed + 1);
}

Result<FeedFiles> FeedFiles::create(const std::string& folder, const measure::SequencePlan& plan) {
    if (plan.configs.size() != 1 || !plan.stored.empty())
        return invalidArgument("--dump {}: one configuration is dumped, which is rendered: state one --config, without "
                               "frames=",
                               printable(folder));
    if (!feedsDenoiser(plan.configs.front().job.settings.reflections))
        return invalidArgument(
            "--dump {}: these settings denoise nothing: they need denoise.enabled with screen.enabled "
            "or rays.enabled, reflect.strength above 0, and no rays.accumulate",
            printable(folder));
    std::string clean = std::filesystem::path(folder).lexically_normal().string();
    while (clean.size() > 1 && clean.back() == '/')
        clean.pop_back();
    GLINT_CHECK(checkFolder("--dump", clean));
    return FeedFiles(std::move(clean), plan);
}

std::string FeedFiles::seedFolder(uint32_t seed) const {
    return (std::filesystem::path(folder_) / fmt::format("seed-{}", seed)).string();
}

Result<void> FeedFiles::makeFolders() const {
    for (const uint32_t seed : seeds_) {
        std::error_code error;
        std::filesystem::create_directories(seedFolder(seed), error);
        if (error)
            return makeError(ErrorCode::Io, "--dump {}: {}", printable(seedFolder(seed)), error.message());
    }
    return {};
}

Result<void> FeedFiles::write(const measure::SequenceViews& frame) {
    const std::vector<std::vector<float>> pixels = measure::feedPixels(frame.views);
    std::vector<scene::ExrLayer> layers;
    for (size_t i = 0; i < pixels.size(); ++i) {
        const measure::FeedLayer& layer = measure::feedLayers()[i];
        layers.push_back({std::string(layer.name), std::string(layer.channels), layer.half, pixels[i], 4});
    }
    moments_[frame.seed].push_back(frame.now);
    const std::string path = (std::filesystem::path(seedFolder(frame.seed)) / frameName(frame.index)).string();
    return scene::writeExr(path, frame.now.view.width, frame.now.view.height, layers);
}

Result<void> FeedFiles::writeDescriptions(const measure::Sequence& sequence) const {
    for (const auto& [seed, moments] : moments_) {
        FeedJson json;
        json["scene"] = sequence.scene;
        json["config"] = sequence.configs.front().name;
        json["seed"] = seed;
        json["width"] = sequence.width;
        json["height"] = sequence.height;
        json["fps"] = sequence.fps;
        json["jitter"] = {0, 0};
        json["conventions"] = conventionsJson();
        json["layers"] = layersJson();
        json["frames"] = framesJson(moments);
        json["settings"] = FeedJson::parse(render::settingsJson(sequence.configs.front().settings));
        const std::string path = (std::filesystem::path(seedFolder(seed)) / "sequence.json").string();
        GLINT_CHECK(writeFile(path, json.dump(2, ' ', false, FeedJson::error_handler_t::replace) + "\n"));
    }
    return {};
}

} // namespace glint::cli
