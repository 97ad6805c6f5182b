#include "lab/cli/sequence/sequence_files.hpp"

#include "base/text.hpp"
#include "lab/cli/child_process.hpp"
#include "lab/scene/images/image_file.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>

namespace glint::cli {
namespace {

constexpr int kMostDigits = 9;

/// Size of the "%d" or "%0Nd" that `text` begins with, and N; 0: it begins with neither.
std::pair<size_t, int> numberField(std::string_view text) {
    if (text.starts_with("%d"))
        return {2, 1};
    if (text.size() >= 4 && text.starts_with("%0") && text[2] >= '1' && text[2] <= '0' + kMostDigits && text[3] == 'd')
        return {4, text[2] - '0'};
    return {0, 0};
}

} // namespace

Result<FramePattern> FramePattern::parse(const std::string& text) {
    FramePattern pattern;
    pattern.text_ = text;
    pattern.numberAt_ = text.find('%');
    if (pattern.numberAt_ != text.npos)
        std::tie(pattern.numberSize_, pattern.digits_) = numberField(std::string_view(text).substr(pattern.numberAt_));
    if (pattern.numberSize_ == 0 || std::ranges::count(text, '%') != 1)
        return invalidArgument("-o {}: expected one %d or %04d for the number of the frame, as in frame_%04d.png",
                               printable(text));
    GLINT_TRY(kind, pictureKind(text));
    pattern.kind_ = kind;
    return pattern;
}

std::string FramePattern::path(uint32_t frame) const {
    return fmt::format("{}{:0{}}{}", text_.substr(0, numberAt_), frame, digits_, text_.substr(numberAt_ + numberSize_));
}

std::string FramePattern::folder() const {
    return std::filesystem::path(text_).parent_path().string();
}

FramePattern FramePattern::inFolder(const std::string& name) const {
    const std::filesystem::path file(text_);
    FramePattern moved = *this;
    moved.text_ = (file.parent_path() / name / file.filename()).string();
    moved.numberAt_ = moved.text_.find('%');
    return moved;
}

std::string FramePattern::video() const {
    std::string name = text_.substr(0, numberAt_);
    while (!name.empty() && (name.back() == '_' || name.back() == '-' || name.back() == '.'))
        name.pop_back();
    return (name.empty() || name.back() == '/' ? name + "video" : name) + ".mp4";
}

std::string numberedPath(const std::string& text, uint32_t frame) {
    const size_t at = text.find('%');
    if (at == text.npos || std::ranges::count(text, '%') != 1)
        return text;
    const auto [size, digits] = numberField(std::string_view(text).substr(at));
    return size == 0 ? text : fmt::format("{}{:0{}}{}", text.substr(0, at), frame, digits, text.substr(at + size));
}

Result<void> writeFrame(const std::string& path, PictureKind kind, const measure::SequenceFrame& frame) {
    if (kind == PictureKind::Png)
        return scene::writePng(path, frame.width, frame.height, 3, frame.composite.rgb8);
    const scene::ExrLayer layers[] = {{"", "RGBA", true, frame.composite.rgba, 4},
                                      {"reflection", "RGB", true, frame.reflection.rgba, 4}};
    return scene::writeExr(path, frame.width, frame.height, layers);
}

Result<void> writeVideo(const FramePattern& frames, double fps, const std::string& program) {
    // Most players need even sides.
    GLINT_TRY(made, runChild({program, "-y", "-loglevel", "error", "-framerate", fmt::format("{}", fps),
                              "-start_number", "0", "-i", frames.text(), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
                              "-pix_fmt", "yuv420p", frames.video()}));
    if (made.code != 0)
        return makeError(ErrorCode::Io, "{} failed: {}", program, printable(made.error, 200));
    return {};
}

} // namespace glint::cli
