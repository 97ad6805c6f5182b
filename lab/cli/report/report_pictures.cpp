#include "lab/cli/report/report_pictures.hpp"

#include "lab/cli/report/report_json.hpp"
#include "lab/scene/images/webp_writer.hpp"

#include <algorithm>

namespace glint::cli {
namespace {

constexpr std::array<std::string_view, 7> kPictures = {"composite", "difference", "flip", "worst",
                                                       "outcome",   "source",     "hits"};

/// An image before it is encoded.
struct Picture {
    std::string name;
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<uint8_t> rgb;
    bool names = false; ///< its colours are names
};

/// Of the names kPictures, in that order.
std::array<std::vector<uint8_t>, kPictures.size()> picturesOf(const ReportScene& scene, size_t config) {
    const measure::ConfigFigures& figures = scene.comparison.configs[config];
    const measure::ComparisonMaps& maps = scene.maps[config];
    return {figures.composite,
            maps.difference,
            maps.flip,
            maps.worst,
            figures.outcome,
            figures.source,
            measure::classColors(figures.hits.classes)};
}

std::vector<Picture> allPictures(const std::vector<ReportScene>& scenes) {
    std::vector<Picture> pictures;
    for (size_t i = 0; i < scenes.size(); ++i) {
        const measure::Comparison& comparison = scenes[i].comparison;
        const auto add = [&](std::string name, const std::vector<uint8_t>& rgb, bool names) {
            pictures.push_back({std::move(name), comparison.width, comparison.height, rgb, names});
        };
        add(scenePictureName(i, "without"), comparison.withoutReflections, false);
        if (!comparison.referencePicture.empty())
            add(scenePictureName(i, "reference"), comparison.referencePicture, false);
        for (size_t config = 0; config < comparison.configs.size(); ++config) {
            const auto made = picturesOf(scenes[i], config);
            for (size_t picture = 0; picture < kPictures.size(); ++picture)
                add(configPictureName(i, config, kPictures[picture]), made[picture], picture >= 4);
        }
    }
    return pictures;
}

size_t base64Size(size_t bytes) {
    return (bytes + 2) / 3 * 4;
}

nlohmann::ordered_json imageJson(uint32_t width, uint32_t height, const std::string& webp) {
    return {{"width", width}, {"height", height}, {"src", "data:image/webp;base64," + base64(webp)}};
}

} // namespace

std::span<const std::string_view> configPictures() {
    return kPictures;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve(base64Size(bytes.size()));
    for (size_t i = 0; i < bytes.size(); i += 3) {
        uint32_t word = 0;
        for (size_t k = 0; k < 3; ++k)
            word = word << 8 | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
        for (size_t k = 0; k < 4; ++k)
            text += i + k < bytes.size() + 1 ? kDigits[word >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

Result<ReportPictures> encodePictures(const std::vector<ReportScene>& scenes, size_t mostBytes) {
    size_t fixed = 0; // bytes that no quality changes
    for (const ReportScene& scene : scenes)
        for (const auto& frames : scene.frames.configs)
            for (const std::string& frame : frames)
                fixed += base64Size(frame.size());
    const std::vector<Picture> pictures = allPictures(scenes);
    std::vector<std::string> encoded(pictures.size());
    for (size_t i = 0; i < pictures.size(); ++i)
        if (pictures[i].names) {
            GLINT_TRY(file, scene::encodeWebp(pictures[i].width, pictures[i].height, pictures[i].rgb));
            encoded[i] = std::move(file);
            fixed += base64Size(encoded[i].size());
        }
    bool fits = false;
    ReportPictures result;
    for (const std::optional<float> quality : {std::optional<float>(), {95.0f}, {85.0f}, {70.0f}, {50.0f}}) {
        size_t bytes = fixed;
        for (size_t i = 0; i < pictures.size() && bytes <= mostBytes; ++i)
            if (!pictures[i].names) {
                GLINT_TRY(file, scene::encodeWebp(pictures[i].width, pictures[i].height, pictures[i].rgb, quality));
                encoded[i] = std::move(file);
                bytes += base64Size(encoded[i].size());
            }
        result.loss = quality ? fmt::format("WebP of quality {:g}", *quality) : std::string("WebP without loss");
        fits = bytes <= mostBytes;
        if (fits)
            break;
    }
    if (!fits)
        return invalidArgument("the images do not fit into a page of {} MB: lower --size, or name fewer scenes and "
                               "configs",
                               mostBytes / 1000000);
    for (size_t i = 0; i < pictures.size(); ++i)
        result.images[pictures[i].name] = imageJson(pictures[i].width, pictures[i].height, encoded[i]);
    for (size_t i = 0; i < scenes.size(); ++i) {
        const MotionFrames& motion = scenes[i].frames;
        for (size_t config = 0; config < motion.configs.size(); ++config)
            for (size_t frame = 0; frame < motion.configs[config].size(); ++frame)
                result.images[framePictureName(i, config, frame)] =
                    imageJson(motion.width, motion.height, motion.configs[config][frame]);
    }
    return result;
}

} // namespace glint::cli
