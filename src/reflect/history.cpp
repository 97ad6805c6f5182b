#include "reflect/history.hpp"

#include <array>

namespace glint::reflect {

std::string_view textOf(HistoryReset reason) {
    constexpr std::array<std::string_view, 7> kTexts = {"none",
                                                        "off",
                                                        "first frame",
                                                        "settings changed",
                                                        "view changed",
                                                        "asked",
                                                        "the frame before was no picture of light"};
    return kTexts[static_cast<size_t>(reason)];
}

Result<void> History::make(std::span<const StageImage> images, bool remembers) {
    wanted_.assign(images.begin(), images.end());
    for (StageImage& image : wanted_)
        image.more |= kCleared;
    for (Pair& pair : images_)
        for (gpu::Image& image : pair.turns)
            stages_.retired.keep(std::move(image));
    images_.clear();
    images_.resize(images.size());
    turn_ = 0;
    for (size_t i = 0; i < wanted_.size(); ++i)
        GLINT_CHECK(makeImage(stages_.gpu, images_[i].turns[0], wanted_[i]));
    reset(HistoryReset::First);
    blank_.ask();
    return remembers && kind_ == Kind::Turns ? remember() : Result<void>();
}

Result<void> History::remember() {
    for (size_t i = 0; i < wanted_.size(); ++i)
        GLINT_CHECK(makeImage(stages_.gpu, images_[i].turns[turn_ ^ 1], wanted_[i]));
    if (tags_)
        return {};
    GLINT_TRY(tags,
              gpu::Buffer::create(stages_.gpu, {"glint/historyTags", 2 * sizeof(uint32_t),
                                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                gpu::BufferHome::Device}));
    tags_ = std::move(tags);
    return {};
}

void History::reset(HistoryReset reason) {
    next_ = reason;
}

bool History::begin(gpu::Frame& frame, bool wanted) {
    why_ = wanted ? next_ : HistoryReset::Off;
    if (frame.rehearsing() || (!wanted && kind_ == Kind::Turns))
        return valid();
    if (kind_ == Kind::Turns)
        turn_ ^= 1;
    else if (wanted && !valid())
        blank_.ask(); // the content belongs to other frames
    if (blank_.isNeeded(stages_.progress)) {
        for (size_t i = 0; i < images_.size(); ++i) {
            frame.clear(before(i), {});
            if (kind_ == Kind::Turns && images_[i].turns[turn_])
                frame.clear(now(i), {}); // some settings leave an image unwritten
        }
        blank_.recorded(stages_.progress);
        if (valid())
            why_ = HistoryReset::First;
    }
    return valid();
}

void History::end(gpu::Frame& frame, HistoryReset reason) {
    if (frame.rehearsing())
        return;
    next_ = why_ == HistoryReset::Off ? HistoryReset::First : reason;
    if (why_ != HistoryReset::Off && reason == HistoryReset::None && kind_ == Kind::Turns) {
        lastRecording_ = stages_.progress.recording();
        frame.update(tags_, &lastRecording_, sizeof(lastRecording_), turn_ * sizeof(uint32_t));
    }
}

void History::copyTag(gpu::Frame& frame, gpu::Buffer& target, size_t offset) {
    frame.copyBytes(tags_, (turn_ ^ 1) * sizeof(uint32_t), target, offset, sizeof(uint32_t));
}

} // namespace glint::reflect
