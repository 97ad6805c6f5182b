#include "lab/view/picture_pair.hpp"

#include "gpu/transfer.hpp"
#include "lab/measure/figures/flip.hpp"

#include <algorithm>
#include <bit>
#include <chrono>
#include <cmath>

namespace glint::view {
namespace {

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Settings of the second picture.
Result<render::ProgramSettings> besideSettings(const ViewerState& state) {
    if (!state.besidePreset.empty()) {
        SettingsModel model = state.settings;
        GLINT_CHECK(model.usePreset(state.besidePreset));
        render::ProgramSettings settings = model.settings();
        // Accumulating settings trace one sample per frame, so that the window stays responsive.
        if (settings.reflections.rays.accumulate)
            settings.reflections.rays.samples = 1;
        return settings;
    }
    render::ProgramSettings settings = state.settings.settings();
    GLINT_CHECK(setSetting(settings.targets(), "screen.march", state.besideMarch, settings.preset));
    return settings;
}

/// Returns four times the absolute difference of displayed colours; `mean` is without the factor.
std::vector<uint8_t> difference(const std::vector<uint8_t>& a, const std::vector<uint8_t>& b, double& mean) {
    std::vector<uint8_t> out(a.size());
    double sum = 0;
    for (size_t i = 0; i < a.size(); ++i) {
        const int error = std::abs(int{a[i]} - int{b[i]});
        sum += error;
        out[i] = static_cast<uint8_t>(std::min(error * 4, 255));
    }
    mean = a.empty() ? 0 : sum / 255 / static_cast<double>(a.size());
    return out;
}

/// Metres along the view axis, one number per pixel.
Result<std::vector<float>> depths(ScenePicture& picture) {
    GLINT_TRY(view, picture.session().readView("depth"));
    std::vector<float> depth(view.rgba.size() / 4);
    for (size_t i = 0; i < depth.size(); ++i)
        depth[i] = view.rgba[i * 4];
    return depth;
}

} // namespace

Result<void> PicturePair::open(const render::RenderJob& job) {
    GLINT_TRY(picture, ScenePicture::create(context_, job));
    picture_ = std::move(picture);
    beside_.reset();
    second_.reset();
    job_ = job;
    shown_.clear();
    complete_ = false;
    return {};
}

Result<void> PicturePair::remake() {
    GLINT_CHECK(picture_->remake());
    beside_.reset(); // created on demand
    second_.reset();
    heat_ = {};
    shown_.clear();
    shownBeside_.clear();
    shownSecond_.clear();
    heatOf_.clear();
    imagesOf_.clear();
    recentOf_.clear();
    complete_ = false;
    return {};
}

void PicturePair::restart() {
    picture_->restart();
    complete_ = false;
}

bool PicturePair::moved(const ViewerState& state, glm::uvec2 window) {
    const bool first = lastWindow_ == glm::uvec2(0);
    const bool moved = lastCamera_ != state.camera.camera().viewToWorld || lastSettings_ != state.settings.version() ||
                       lastSeconds_ != state.animation.seconds || lastMaterials_ != state.materials.version() ||
                       lastWindow_ != window;
    lastCamera_ = state.camera.camera().viewToWorld;
    lastSettings_ = state.settings.version();
    lastSeconds_ = state.animation.seconds;
    lastMaterials_ = state.materials.version();
    lastWindow_ = window;
    return moved && !first;
}

Result<void> PicturePair::prepare(ScenePicture& picture, const ViewerState& state, glm::uvec2 size) {
    GLINT_CHECK(picture.resize(size.x, size.y));
    GLINT_CHECK(picture.setTime(state.animation.seconds));
    GLINT_CHECK(picture.setMaterials(state.materials.overrides(), state.materials.version()));
    return picture.setCamera(state.camera.camera());
}

Result<void> PicturePair::update(ViewerState& state, glm::uvec2 window) {
    if (window.x == 0 || window.y == 0)
        return {};
    if (moved(state, window))
        pace_.moved(state.now);
    const uint32_t divisor = pace_.divisor(state.now);
    const glm::uvec2 size = glm::max(window / divisor, glm::uvec2(1));
    GLINT_CHECK(prepare(*picture_, state, size));
    if (auto set = picture_->setSettings(state.settings.settings()); !set) {
        state.say(set.error().message, true);
        if (!state.settings.undo())
            return set;
        GLINT_CHECK(picture_->setSettings(state.settings.settings()));
    }
    GLINT_CHECK(updatePicture(state, size, divisor));
    GLINT_CHECK(updateBeside(state, size));
    GLINT_CHECK(updateHeat(state));
    if (divisor == 1)
        GLINT_CHECK(answer(state));
    GLINT_CHECK(updateSecond(state));
    complete_ = divisor == 1 && picture_->complete() &&
                (state.beside != Beside::Settings || (beside_ && beside_->complete())) &&
                (!state.second.shown || state.second.size == glm::uvec2(0) || (second_ && second_->complete()));
    return {};
}

Result<void> PicturePair::updatePicture(ViewerState& state, glm::uvec2, uint32_t divisor) {
    const double start = seconds();
    if (!picture_->complete()) {
        GLINT_CHECK(picture_->render());
        pace_.rendered(divisor, picture_->times().wallMs);
        note(state);
    }
    const std::string wanted = fmt::format("{} {} {}", state.view, picture_->version(), picture_->images());
    if (wanted != shown_) {
        GLINT_CHECK(picture_->show(state.view));
        shown_ = wanted;
    }
    frameStart_ = start;
    return {};
}

void PicturePair::note(ViewerState& state) {
    const render::FrameTimes& times = picture_->times();
    const double now = seconds();
    const double interval =
        frameStart_ > 0 && now - frameStart_ < 2 * times.wallMs / 1000 ? (now - frameStart_) * 1000 : 0;
    const std::string of = fmt::format("{}x{} {} {}", picture_->width(), picture_->height(), state.settings.version(),
                                       state.materials.version()); // as --stats counts
    if (std::exchange(recentOf_, of) != of)
        recent_.clear();
    recent_.add(times, interval);
    state.figures = recent_.figures();
    std::vector<std::pair<std::string, double>> passes = times.hostPasses;
    passes.insert(passes.end(), times.effectPasses.begin(), times.effectPasses.end());
    state.history.add(passes);
    state.stats = picture_->session().stats();
    state.notes = picture_->session().notes();
    state.width = picture_->width();
    state.height = picture_->height();
    state.frames = picture_->frames();
}

Result<void> PicturePair::updateBeside(ViewerState& state, glm::uvec2 size) {
    if (state.beside == Beside::Nothing)
        return {};
    if (state.beside == Beside::View) {
        const std::string wanted = fmt::format("{} {} {}", state.besideView, picture_->version(), picture_->images());
        if (wanted == shownBeside_)
            return {};
        shownBeside_ = wanted;
        return picture_->showSecond(state.besideView);
    }
    const std::string asked = fmt::format("{} {} {}", state.settings.version(), state.besidePreset, state.besideMarch);
    if (asked != besideOf_) {
        auto settings = besideSettings(state);
        if (!settings) {
            state.say(settings.error().message, true);
            state.beside = Beside::Nothing;
            return {};
        }
        besideSettings_ = *settings;
        besideOf_ = asked;
    }
    if (!beside_) {
        render::RenderJob job = job_;
        job.settings = besideSettings_;
        GLINT_TRY(made, ScenePicture::create(context_, job));
        beside_ = std::move(made);
    }
    GLINT_CHECK(prepare(*beside_, state, size));
    GLINT_CHECK(beside_->setSettings(besideSettings_));
    if (!beside_->complete())
        GLINT_CHECK(beside_->render());
    state.besideFrames = beside_->frames();
    const std::string wanted = fmt::format("{} {} {} settings", state.view, beside_->version(), beside_->images());
    if (wanted == shownBeside_)
        return {};
    shownBeside_ = wanted;
    return beside_->show(state.view);
}

Result<void> PicturePair::placeSecond(ViewerState& state) {
    const render::View asked = picture_->session().view();
    if (!state.asked || !state.ray || asked.width != state.rayView.width || asked.height != state.rayView.height) {
        state.second.lookAt(state.camera);
        return {};
    }
    GLINT_TRY(depth, depths(*picture_));
    if (depth.size() != size_t{asked.width} * asked.height)
        return {}; // not yet rendered at this size; retry in the next frame
    state.second.lookAt(*state.ray, state.rayView, depth, state.camera.camera());
    return {};
}

/// Renders the same settings from the second camera at its pane's size, and reads the depths that occlude the ray.
Result<void> PicturePair::updateSecond(ViewerState& state) {
    SecondCamera& second = state.second;
    if (!second.shown) {
        second_.reset();
        second.depth.clear();
        return {};
    }
    const bool asked = state.asked && state.ray;
    if (!second.placed || (asked && !second.sawRay && !second.turned))
        GLINT_CHECK(placeSecond(state));
    second.sawRay = asked;
    if (second.size == glm::uvec2(0))
        return {};
    if (!second_) {
        render::RenderJob job = job_;
        job.settings = state.settings.settings();
        job.statistics = false;
        job.inspect.reset();
        GLINT_TRY(made, ScenePicture::create(context_, job));
        second_ = std::move(made);
        shownSecond_.clear();
    }
    GLINT_CHECK(second_->resize(second.size.x, second.size.y));
    GLINT_CHECK(second_->setTime(state.animation.seconds));
    GLINT_CHECK(second_->setMaterials(state.materials.overrides(), state.materials.version()));
    GLINT_CHECK(second_->setSettings(state.settings.settings()));
    scene::Camera camera = second.camera.camera();
    camera.near = std::max(camera.near, second.cut);
    GLINT_CHECK(second_->setCamera(camera));
    if (!second_->complete())
        GLINT_CHECK(second_->render());
    const std::string wanted = fmt::format("{} {} {}", state.view, second_->version(), second_->images());
    if (wanted == shownSecond_)
        return {};
    shownSecond_ = wanted;
    GLINT_CHECK(second_->show(state.view));
    GLINT_TRY(depth, depths(*second_));
    second.depth = std::move(depth);
    second.view = second_->session().view();
    return {};
}

/// Recomputes the metric, which is costly: for accumulating pictures only when the number of frames has doubled.
Result<void> PicturePair::updateHeat(ViewerState& state) {
    if (state.heat == Heat::None || state.beside != Beside::Settings || !beside_)
        return {};
    if (!picture_->complete() && !std::has_single_bit(picture_->frames()))
        return {};
    if (!beside_->complete() && !std::has_single_bit(beside_->frames()))
        return {};
    const std::string wanted =
        fmt::format("{} {} {} {}", shown_, beside_->version(), beside_->images(), static_cast<int>(state.heat));
    if (wanted == heatOf_)
        return {};
    heatOf_ = wanted;
    GLINT_TRY(ours, picture_->bytes());
    GLINT_TRY(theirs, beside_->bytes());
    const uint32_t width = picture_->width(), height = picture_->height();
    std::vector<uint8_t> colors;
    if (state.heat == Heat::Flip) {
        const measure::FlipMap map = measure::flip({width, height, theirs}, {width, height, ours});
        colors = measure::errorColors(map.error);
        state.heatMean = map.mean;
    } else {
        colors = difference(ours, theirs, state.heatMean);
    }
    std::vector<uint8_t> rgba;
    rgba.reserve(colors.size() / 3 * 4);
    for (size_t i = 0; i < colors.size(); i += 3)
        rgba.insert(rgba.end(), {colors[i], colors[i + 1], colors[i + 2], 255});
    if (!heat_ || heat_.width() != width || heat_.height() != height) {
        GLINT_TRY(made, gpu::Image::create(context_, {"view/heat", VK_FORMAT_R8G8B8A8_UNORM, width, height, 1, 1,
                                                      gpu::ImageShape::Flat,
                                                      VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}));
        heat_ = std::move(made);
        imagesOf_.clear();
    }
    return gpu::uploadImage(context_, heat_, std::as_bytes(std::span(rgba)));
}

Result<void> PicturePair::answer(ViewerState& state) {
    if (!state.asked || picture_->frames() == 0) {
        if (!state.asked)
            state.ray.reset();
        rayOf_.clear();
        return {};
    }
    const glm::vec2 size(picture_->width(), picture_->height());
    const glm::uvec2 pixel = glm::clamp(*state.asked * size, glm::vec2(0), size - 1.0f);
    const std::string wanted = fmt::format("{},{} {}", pixel.x, pixel.y, picture_->version());
    if (wanted == rayOf_)
        return {};
    rayOf_ = wanted;
    GLINT_TRY(ray, picture_->session().inspect(pixel.x, pixel.y));
    state.ray = std::move(ray);
    state.rayView = picture_->session().view();
    if (std::exchange(state.focusAsked, false) && !state.ray->background) {
        const Float3& point = state.ray->positionWS;
        state.camera.focus({point[0], point[1], point[2]});
    }
    return {};
}

bool PicturePair::imagesChanged() {
    const std::string now = fmt::format("{} {} {} {}", picture_->images(), beside_ ? beside_->images() : 0,
                                        second_ ? second_->images() : 0, static_cast<bool>(heat_));
    return std::exchange(imagesOf_, now) != now;
}

std::vector<const gpu::Image*> PicturePair::images() const {
    const gpu::Image& none = picture_->secondImage();
    return {&picture_->image(), &none, beside_ ? &beside_->image() : &none, heat_ ? &heat_ : &none,
            second_ ? &second_->image() : &none};
}

} // namespace glint::view
