#include "lab/measure/motion/stored_frames.hpp"

#include "base/assert.hpp"
#include "base/text.hpp"
#include "lab/scene/images/exr_channels.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace glint::measure {
namespace {

constexpr const char* kLayer = "reflection";

using Channels = std::array<size_t, 3>;

/// R, G and B of a layer; of none for "".
std::optional<Channels> colorOf(const scene::ExrChannels& file, std::string_view layer) {
    Channels channels = {};
    for (size_t c = 0; c < 3; ++c) {
        const std::string name = std::string(layer) + (layer.empty() ? "" : ".") + "RGB"[c];
        const auto found = std::ranges::find(file.names(), name);
        if (found == file.names().end())
            return std::nullopt;
        channels[c] = static_cast<size_t>(found - file.names().begin());
    }
    return channels;
}

Result<std::vector<float>> readColor(const scene::ExrChannels& file, const Channels& channels) {
    GLINT_TRY(planes, file.read(channels));
    std::vector<float> rgba(planes[0].size() * 4, 1.0f);
    for (size_t p = 0; p < planes[0].size(); ++p)
        for (size_t c = 0; c < 3; ++c) {
            const float value = planes[c][p];
            if (!std::isfinite(value))
                return invalidInput("{}: channel {} of pixel {}, {} is {}: the denoiser has to write finite numbers in "
                                    "every pixel",
                                    file.name(), file.names()[channels[c]], p % file.width(), p / file.width(), value);
            rgba[4 * p + c] = value;
        }
    return rgba;
}

} // namespace

Result<StoredFrames> StoredFrames::open(std::vector<std::vector<std::string>> files) {
    GLINT_ASSERT(!files.empty() && files.size() <= 2 && !files.front().empty(), "{} seeds", files.size());
    for (const std::vector<std::string>& seed : files) {
        GLINT_ASSERT(seed.size() == files.front().size(), "{} and {} frames", files.front().size(), seed.size());
        for (const std::string& path : seed) {
            std::error_code error;
            if (!std::filesystem::is_regular_file(path, error))
                return makeError(ErrorCode::NotFound, "{}: no such frame; the files of {} frames are needed, {} to {}",
                                 printable(path), seed.size(), printable(seed.front()), printable(seed.back()));
        }
    }
    StoredFrames stored;
    stored.files_ = std::move(files);
    for (const std::vector<std::string>& seed : stored.files_) {
        GLINT_TRY(file, scene::ExrChannels::open(seed.front()));
        const bool first = &seed == &stored.files_.front();
        const bool layer = colorOf(file, kLayer).has_value();
        const bool root = colorOf(file, "").has_value();
        if (!layer && !root)
            return invalidInput("{}: no layer {} with channels R, G, B and no R, G, B without a layer; it has {}",
                                file.name(), kLayer, printable(joinText(file.names(), ", "), 200));
        if (first) {
            stored.width_ = file.width();
            stored.height_ = file.height();
            stored.hasLayer_ = layer;
            stored.hasComposite_ = layer && root;
        } else if (layer != stored.hasLayer_) {
            return invalidInput("{}: {} layer {}, unlike {}: both seeds need the same layers", file.name(),
                                layer ? "it has a" : "it has no", kLayer, printable(stored.files_[0][0]));
        } else {
            stored.hasComposite_ = stored.hasComposite_ && root;
        }
    }
    return stored;
}

Result<StoredFrame> StoredFrames::read(size_t seed, size_t frame) const {
    GLINT_TRY(file, scene::ExrChannels::open(files_[seed][frame]));
    if (file.width() != width_ || file.height() != height_)
        return invalidInput("{}: {}x{} pixels, but {} has {}x{}: all frames need one size", file.name(), file.width(),
                            file.height(), printable(files_[0][0]), width_, height_);
    const auto channels = colorOf(file, hasLayer_ ? kLayer : "");
    const auto composite = hasComposite_ ? colorOf(file, "") : std::nullopt;
    if (!channels || (hasComposite_ && !composite))
        return invalidInput("{}: no channels R, G, B {}, which {} has", file.name(),
                            channels || !hasLayer_ ? "without a layer" : fmt::format("of layer {}", kLayer),
                            printable(files_[0][0]));
    StoredFrame stored;
    GLINT_TRY(reflection, readColor(file, *channels));
    stored.reflection = std::move(reflection);
    if (composite) {
        GLINT_TRY(picture, readColor(file, *composite));
        stored.composite = std::move(picture);
    }
    return stored;
}

} // namespace glint::measure
