#include "lab/view/viewer.hpp"

#include "base/file.hpp"
#include "base/text.hpp"
#include "gpu/transfer.hpp"
#include "lab/cli/inspect/inspect_output.hpp"
#include "lab/cli/render/render_output.hpp"
#include "lab/gpu/swapchain.hpp"
#include "lab/scene/images/image_file.hpp"
#include "lab/scene/pick.hpp"
#include "lab/session/views.hpp"
#include "lab/view/canvas.hpp"
#include "lab/view/command_line.hpp"
#include "lab/view/frame_pace.hpp"
#include "lab/view/gui.hpp"
#include "lab/view/input_handler.hpp"
#include "lab/view/live_shaders.hpp"
#include "lab/view/panels.hpp"
#include "lab/view/picture_pair.hpp"
#include "lab/view/ray_overlay.hpp"
#include "lab/view/render_doc.hpp"
#include "lab/view/script_player.hpp"
#include "lab/view/window.hpp"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>
#include <thread>

namespace glint::view {
namespace {

constexpr uint32_t kWidth = 1280, kHeight = 720; ///< pixels, by default
constexpr double kScriptFrame = 1.0 / 60;        ///< seconds per frame in a script, independent of real time
constexpr uint32_t kMostSurfacesLost = 10;       ///< in a row
constexpr double kIdle = 0.1;                    ///< seconds to sleep while nothing happens

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::string ending(const std::string& path) {
    std::string text = std::filesystem::path(path).extension().string();
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
    return text;
}

/// The file in which changes of the materials are saved.
std::string materialFile(const render::RenderJob& job) {
    return job.materials.empty() || job.materials == render::kNoMaterials ? render::materialFileFor(job.scene)
                                                                          : job.materials;
}

class Viewer {
public:
    Viewer(const ViewOptions& options, SettingsModel model, render::RenderJob job)
        : options_(options), job_(std::move(job)), state_(std::move(model)) {}

    Result<void> open();
    void setView(std::string view) { state_.view = std::move(view); }
    Result<void> run();
    Result<void> validated() const;

private:
    Result<void> makeSwapchain();
    Result<void> openScene(const render::RenderJob& job);
    std::vector<InputEvent> input();
    void advanceTime(double step);
    Result<void> drawLoading();
    Result<void> resizeCanvas(glm::uvec2 size);
    Result<void> present();
    Result<void> checkWindow() const;
    bool closeIsAllThatIsAsked() const;
    Result<void> drawWindow(std::span<const InputEvent> events, double step);
    void drawPictures();
    Result<void> serveRequests();
    Result<void> serve(const Request& request);
    Result<void> screenshot(const std::string& path);
    Result<void> savePicture(const std::string& path);
    Result<void> saveSettings(const std::string& path);
    Result<void> saveMaterials(const std::string& path);
    Result<void> openMaterials(const std::string& path);
    void chooseMaterial();
    Result<void> openFile(const std::string& path);
    Result<void> openOtherScene(const std::string& path);
    Result<void> openEnvironment(const std::string& path);
    Result<void> openSceneAgain(render::RenderJob job);
    Result<void> remakePipelines();
    Result<void> startCapture();
    void endCapture();
    std::string probesElsewhere() const;

    ViewOptions options_;
    render::RenderJob job_;
    ViewerState state_;
    // In the order of their dependencies.
    LiveShaders shaders_;
    std::unique_ptr<Window> window_;
    std::unique_ptr<gpu::Context> context_;
    std::unique_ptr<gpu::Swapchain> swapchain_;
    std::unique_ptr<Gui> gui_;
    std::optional<GuiRenderer> renderer_;
    gpu::Image canvasImage_; ///< the window's content
    std::optional<PicturePair> pictures_;
    InputHandler handler_;
    ScriptPlayer script_;
    std::optional<SavedCamera> savedCamera_;
    std::optional<RenderDoc> capturing_;
    bool scripted_ = false;
    uint32_t shownFrames_ = 0;
    uint32_t surfacesLost_ = 0; ///< in a row
    bool closing_ = false;
};

Result<void> Viewer::open() {
    if (!options_.script.empty()) {
        GLINT_TRY(text, readFile(options_.script, 1 << 20));
        GLINT_TRY(steps, readScript(text, options_.script));
        script_ = ScriptPlayer(std::move(steps));
    }
    GLINT_CHECK(shaders_.follow(options_.shaders));
    GLINT_TRY(window, Window::create("Glint: " + job_.scene, job_.width, job_.height));
    window_ = std::move(window);
    gpu::ContextDesc desc = {job_.device, job_.validate};
    desc.windowExtensions = window_->vulkanExtensions();
    if (desc.windowExtensions.empty())
        return makeError(ErrorCode::Unsupported, "no Vulkan driver here can draw into a window; `glint render` makes "
                                                 "pictures without one");
    GLINT_TRY(context, gpu::Context::create(desc));
    context_ = std::move(context);
    GLINT_CHECK(makeSwapchain());
    gui_ = std::make_unique<Gui>(window_->scale(),
                                 Gui::Clipboard{[this](const std::string& t) { window_->setClipboard(t); },
                                                [this] { return window_->clipboard(); }});
    GLINT_TRY(renderer, GuiRenderer::create(*context_));
    renderer_.emplace(std::move(renderer));
    pictures_.emplace(*context_);
    GLINT_CHECK(drawLoading());
    GLINT_CHECK(openScene(job_));
    state_.recent = RecentFiles(RecentFiles::usualFile());
    state_.recent.add(job_.scene);
    return {};
}

Result<void> Viewer::makeSwapchain() {
    swapchain_.reset(); // a window has one surface at a time
    const auto make = [&]() -> Result<void> {
        GLINT_TRY(surface, window_->makeSurface(context_->instance()));
        GLINT_TRY(swapchain, gpu::Swapchain::create(*context_, surface));
        swapchain_ = std::move(swapchain);
        return {};
    };
    Result<void> made = make();
    if (!made)
        GLINT_CHECK(checkWindow()); // the driver calls a destroyed window what it likes, such as a lack of memory
    return made;
}

Result<void> Viewer::openScene(const render::RenderJob& job) {
    GLINT_CHECK(pictures_->open(job));
    job_ = job;
    const render::JobInputs& inputs = pictures_->picture().session().inputs();
    const scene::Bounds& bounds = inputs.pose.boundsWS;
    const glm::vec3 center = bounds.empty() ? glm::vec3(0) : (bounds.min + bounds.max) * 0.5f;
    const float size = bounds.empty() ? 1 : glm::length(bounds.max - bounds.min);
    const glm::vec3 position(inputs.camera.viewToWorld[3]);
    const float ahead = glm::dot(center - position, -glm::vec3(inputs.camera.viewToWorld[2]));
    state_.scene = job.scene;
    state_.materials = MaterialsModel(inputs, materialFile(job));
    state_.camera = OrbitCamera(inputs.camera, std::max(ahead, size * 0.05f));
    state_.cameras = inputs.pose.cameras;
    state_.cameraIndex = -1;
    for (size_t i = 0; i < state_.cameras.size() && state_.cameraIndex < 0; ++i)
        if (state_.cameras[i].viewToWorld == inputs.camera.viewToWorld)
            state_.cameraIndex = static_cast<int>(i);
    state_.animation = {job.time, 0, false};
    for (const scene::Animation& animation : inputs.scene->animations)
        for (const scene::AnimationChannel& channel : animation.channels)
            if (!channel.times.empty())
                state_.animation.length = std::max(state_.animation.length, static_cast<double>(channel.times.back()));
    savedCamera_.reset();
    state_.asked.reset();
    state_.ray.reset();
    state_.second.placed = false;
    state_.showSettings = job.width >= 640; // it would cover a smaller window
    handler_.setScale(size);
    window_->setTitle("Glint: " + printable(job.scene));
    return {};
}

std::vector<InputEvent> Viewer::input() {
    const bool busy = !pictures_->complete() || script_.playing() || handler_.holding() || state_.animation.playing ||
                      !options_.screenshot.empty() || !state_.requests.empty();
    std::vector<InputEvent> events = window_->poll(busy ? 0 : kIdle);
    if (!script_.playing())
        return events;
    const ScriptTarget target = {
        [this](uint32_t width, uint32_t height) { window_->resize(width, height); },
        [this] { window_->minimize(); },
        [this] { window_->restore(); },
        [this] {
            if (!state_.messageIsError)
                state_.message.clear();
        },
        [this](const ScriptStep& step) {
            state_.ask(step.kind == ScriptStep::Kind::Screenshot ? Request::Kind::Screenshot
                       : step.kind == ScriptStep::Kind::Picture  ? Request::Kind::Picture
                       : step.kind == ScriptStep::Kind::Stats    ? Request::Kind::Stats
                                                                 : Request::Kind::Save,
                       step.text);
        },
    };
    // A script's result must not depend on the machine's real mouse.
    std::erase_if(events, [](const InputEvent& event) { return event.kind == InputKind::Move; });
    for (InputEvent& event : script_.frame(target, pictures_->complete(), !state_.requests.empty()))
        events.push_back(std::move(event));
    return events;
}

void Viewer::advanceTime(double step) {
    Animation& animation = state_.animation;
    if (animation.playing && animation.length > 0)
        animation.seconds = std::fmod(animation.seconds + step, animation.length);
    if (state_.cameraIndex >= 0 && !state_.camera.moved()) { // a scene's camera may be animated
        const auto& cameras = pictures_->picture().session().inputs().pose.cameras;
        if (static_cast<size_t>(state_.cameraIndex) < cameras.size())
            state_.camera.follow(cameras[static_cast<size_t>(state_.cameraIndex)]);
    }
}

Result<void> Viewer::run() {
    scripted_ = script_.playing();
    double last = seconds();
    while (!closing_) {
        const std::vector<InputEvent> events = input();
        const double now = seconds();
        const double step = scripted_ ? kScriptFrame : std::clamp(now - last, 1e-4, 0.25);
        last = now;
        state_.now += step;
        handler_.handle(events, state_, *gui_, window_->size(), step);
        chooseMaterial();
        GLINT_CHECK(checkWindow());
        if (closeIsAllThatIsAsked()) // no further frame is needed
            break;
        advanceTime(step);
        if (!scripted_) // a script requests reloads itself
            shaders_.look(state_);
        if (capturing_)
            capturing_->start();
        GLINT_CHECK(pictures_->update(state_, window_->size()));
        GLINT_CHECK(drawWindow(events, step));
        endCapture();
        GLINT_CHECK(serveRequests());
        if (!options_.screenshot.empty() && !script_.playing() && pictures_->complete() &&
            shownFrames_ >= options_.scene.frames) {
            GLINT_CHECK(screenshot(options_.screenshot));
            closing_ = true;
        }
        if (scripted_ && !script_.playing() && state_.requests.empty())
            closing_ = true;
    }
    return {};
}

Result<void> Viewer::checkWindow() const {
    if (window_->lost())
        return makeError(ErrorCode::Io, "the window is gone: something else has destroyed it");
    return {};
}

bool Viewer::closeIsAllThatIsAsked() const {
    return state_.requests.size() == 1 && state_.requests.front().kind == Request::Kind::Close;
}

/// Draws the picture to the left of the dividing line, the second picture to its right.
void Viewer::drawPictures() {
    const ImVec2 size = ImGui::GetIO().DisplaySize;
    const Canvas canvas = makeCanvas(state_.zoom, window_->size());
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    // Magnified pixels are drawn as squares (nearest filter).
    const bool squares =
        size.x / (canvas.highUV.x - canvas.lowUV.x) > static_cast<float>(state_.width) + 0.5f && state_.zoom.factor > 1;
    const auto show = [&](uint32_t picture, float left, float right) {
        const glm::vec2 low = canvas.toUV({left, 0}), high = canvas.toUV({right, size.y});
        const GuiTexture texture = squares ? GuiRenderer::squares(picture) : GuiRenderer::smooth(picture);
        list.AddImage(reinterpret_cast<ImTextureID>(uintptr_t{texture}), {left, 0}, {right, size.y}, {low.x, low.y},
                      {high.x, high.y});
    };
    const bool heat = state_.heat != Heat::None && state_.beside == Beside::Settings;
    const float line = state_.beside == Beside::Nothing ? size.x : std::round(size.x * state_.line);
    show(heat ? PicturePair::kHeat : PicturePair::kPicture, 0, line);
    if (state_.beside != Beside::Nothing) {
        show(state_.beside == Beside::View ? PicturePair::kBesideView : PicturePair::kBesideSettings, line, size.x);
        list.AddLine({line, 0}, {line, size.y}, IM_COL32(0, 0, 0, 200), 3);
        list.AddLine({line, 0}, {line, size.y}, IM_COL32(255, 255, 255, 255), 1);
    }
    if (state_.asked && state_.ray)
        drawRayOverlay(*state_.ray, canvas, {state_.width, state_.height});
}

Result<void> Viewer::resizeCanvas(glm::uvec2 size) {
    if (!canvasImage_ || canvasImage_.width() != size.x || canvasImage_.height() != size.y) {
        GLINT_TRY(image,
                  gpu::Image::create(*context_,
                                     {"view/window", GuiRenderer::kFormat, size.x, size.y, 1, 1, gpu::ImageShape::Flat,
                                      VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
        canvasImage_ = std::move(image);
        state_.placePanels = true;
    }
    return {};
}

Result<void> Viewer::present() {
    GLINT_CHECK(renderer_->draw(*ImGui::GetDrawData(), canvasImage_));
    GLINT_TRY(presented, swapchain_->present(canvasImage_));
    if (presented == gpu::Presented::Shown)
        surfacesLost_ = 0;
    if (presented != gpu::Presented::SurfaceLost)
        return {};
    GLINT_CHECK(checkWindow());
    if (++surfacesLost_ > kMostSurfacesLost)
        return makeError(ErrorCode::Io, "the window system takes the window's surface away again and again");
    return makeSwapchain();
}

/// Drawn while a scene is read.
Result<void> Viewer::drawLoading() {
    const glm::uvec2 size = window_->size();
    if (size.x == 0 || size.y == 0)
        return {};
    GLINT_CHECK(resizeCanvas(size));
    gui_->begin({}, size, kScriptFrame);
    const std::string text = "reading " + printable(job_.scene) + " ...";
    ImGui::GetBackgroundDrawList()->AddText({static_cast<float>(size.x) * 0.4f, static_cast<float>(size.y) * 0.5f},
                                            IM_COL32_WHITE, text.c_str());
    gui_->end();
    return present();
}

Result<void> Viewer::drawWindow(std::span<const InputEvent> events, double step) {
    const glm::uvec2 size = window_->size();
    if (size.x == 0 || size.y == 0) { // minimized
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
        return {};
    }
    GLINT_CHECK(resizeCanvas(size));
    if (pictures_->imagesChanged())
        GLINT_CHECK(renderer_->setPictures(pictures_->images()));
    gui_->begin(events, size, step);
    drawPictures();
    if (state_.showPanels) {
        drawViewBar(state_);
        drawSettingsPanel(state_);
        drawMaterialsPanel(state_);
        drawHelpPanel(state_);
        drawTimesPanel(state_);
        drawRayPanel(state_);
        drawSecondPanel(state_);
    }
    state_.placePanels = false;
    drawPalette(state_);
    drawOpenPanel(state_);
    drawShaderError(state_);
    drawMessage(state_);
    gui_->end();
    GLINT_CHECK(present());
    ++shownFrames_;
    return {};
}

Result<void> Viewer::serveRequests() {
    std::vector<Request> later;
    for (const Request& request : std::exchange(state_.requests, {})) {
        const bool whole = request.kind == Request::Kind::Picture || request.kind == Request::Kind::Save;
        const bool writes = whole || request.kind == Request::Kind::SaveMaterials ||
                            request.kind == Request::Kind::Screenshot || request.kind == Request::Kind::Stats;
        if (whole && !pictures_->complete()) { // not of a coarse picture in motion
            later.push_back(request);
            continue;
        }
        if (auto served = serve(request); !served) {
            if (served.error().code == ErrorCode::DeviceLost)
                return served;
            if (scripted_ && writes) // a script's user needs the files and reads no messages
                return makeError(ErrorCode::Io, "{}: {}", printable(options_.script), served.error().message);
            state_.say(served.error().message, true);
        }
    }
    state_.requests.insert(state_.requests.end(), later.begin(), later.end());
    return {};
}

Result<void> Viewer::serve(const Request& request) {
    switch (request.kind) {
    case Request::Kind::Screenshot: return screenshot(request.text);
    case Request::Kind::Picture: return savePicture(request.text);
    case Request::Kind::Stats:
        return writeFile(request.text, figuresJson(state_.figures, state_.stats, state_.history.passes(),
                                                   pictures_->picture().session().deviceBytes()));
    case Request::Kind::Save: return saveSettings(request.text);
    case Request::Kind::SaveMaterials: return saveMaterials(request.text);
    case Request::Kind::Open:
        GLINT_CHECK(openFile(request.text));
        state_.recent.add(request.text);
        return {};
    case Request::Kind::CopyCommandLine:
        window_->setClipboard(commandLine(state_, job_, savedCamera_));
        state_.say(std::string("copied") +
                   (cameraIsLost(state_, savedCamera_) ? " without the camera, which Ctrl+S saves" : "") +
                   (state_.materials.unsaved() ? " without the materials, which their panel saves" : "") + ": " +
                   commandLine(state_, job_, savedCamera_));
        return {};
    case Request::Kind::CopyRay: {
        render::RenderResult result;
        result.width = state_.width;
        result.height = state_.height;
        result.inspection = state_.ray;
        result.notes = state_.notes;
        if (result.inspection)
            window_->setClipboard(cli::inspectionJson(pictures_->picture().job(), result));
        state_.say(result.inspection ? "copied the ray as JSON" : "no pixel was asked");
        return {};
    }
    case Request::Kind::Capture: return startCapture();
    case Request::Kind::ReloadShaders:
        return shaders_.reload(request.text == "all", *context_, state_, [this] { return remakePipelines(); });
    case Request::Kind::Close: closing_ = true; return {};
    }
    return {};
}

Result<void> Viewer::screenshot(const std::string& path) {
    if (ending(path) != ".png")
        return invalidArgument("{}: a screenshot's name must end in .png", printable(path));
    GLINT_TRY(raw, gpu::downloadImage(*context_, canvasImage_));
    std::vector<uint8_t> rgb;
    rgb.reserve(raw.size() / 4 * 3);
    for (size_t i = 0; i < raw.size(); ++i)
        if (i % 4 != 3)
            rgb.push_back(static_cast<uint8_t>(raw[i]));
    GLINT_CHECK(scene::writePng(path, canvasImage_.width(), canvasImage_.height(), 3, rgb));
    state_.say("screenshot " + path);
    return {};
}

/// Uses the functions of `glint render`, so the bytes are the same.
Result<void> Viewer::savePicture(const std::string& path) {
    GLINT_TRY(kind, cli::pictureKind(path));
    ScenePicture& picture = pictures_->picture();
    std::vector<std::string> views = {state_.view};
    if (kind == cli::PictureKind::Exr && state_.view != "composite")
        views.insert(views.begin(), "composite");
    render::RenderResult result;
    result.width = picture.width();
    result.height = picture.height();
    for (const std::string& view : views) {
        GLINT_TRY(read, picture.session().readView(view));
        result.views.push_back(std::move(read));
    }
    GLINT_CHECK(cli::writePictures(path, result));
    state_.say("picture " + path);
    return {};
}

Result<void> Viewer::saveSettings(const std::string& path) {
    GLINT_CHECK(state_.settings.save(path));
    const std::string camera = std::filesystem::path(path).replace_extension(".camera.json").string();
    GLINT_CHECK(writeFile(camera, state_.camera.json(state_.width, state_.height)));
    GLINT_TRY(read, scene::readCameraFile(camera)); // an unmoved scene camera loses its roll
    if (state_.camera.moved())                      // continue from the file's rounded numbers
        state_.camera.settle(read);
    savedCamera_ = {camera, read};
    state_.say(fmt::format("settings {}, camera {}", path, camera));
    return {};
}

Result<void> Viewer::saveMaterials(const std::string& path) {
    GLINT_CHECK(state_.materials.save(path));
    state_.say("materials " + path);
    return {};
}

/// Opens the same scene with another file of material overrides.
Result<void> Viewer::openMaterials(const std::string& path) {
    render::RenderJob job = job_;
    job.materials = path;
    GLINT_CHECK(openSceneAgain(job));
    state_.say("materials from " + path);
    return {};
}

/// The material of the surface at the clicked point.
void Viewer::chooseMaterial() {
    if (!state_.materialAsked || !pictures_ || state_.width == 0)
        return;
    const glm::vec2 uv = *std::exchange(state_.materialAsked, std::nullopt);
    const scene::Pose& pose = pictures_->picture().session().inputs().pose;
    const float aspectRatio = static_cast<float>(state_.width) / static_cast<float>(state_.height);
    const scene::CameraRay ray = scene::cameraRay(state_.camera.camera(), uv, aspectRatio);
    const std::optional<size_t> item = scene::pickItem(pose, ray.originWS, ray.directionWS);
    if (item && pose.items[*item].material >= 0)
        state_.materials.chosen = static_cast<size_t>(pose.items[*item].material);
    else
        state_.say("no material there");
}

Result<void> Viewer::openFile(const std::string& path) {
    const std::string kind = ending(path);
    if (path.ends_with(".camera.json")) { // a saved view
        GLINT_TRY(camera, scene::readCameraFile(path));
        state_.camera.settle(camera);
        savedCamera_ = {path, camera};
        state_.say("camera " + path);
        return {};
    }
    if (path.ends_with(".materials.json"))
        return openMaterials(path);
    if (kind == ".json") {
        GLINT_CHECK(state_.settings.load(path));
        state_.say("settings from " + path);
        return {};
    }
    const std::string probes = job_.probes;
    if (kind == ".hdr" || kind == ".exr")
        GLINT_CHECK(openEnvironment(path));
    else if (kind == ".glb" || kind == ".gltf" || path.starts_with("builtin:"))
        GLINT_CHECK(openOtherScene(path));
    else
        return invalidInput("{}: what is dropped must end in .glb, .gltf, .hdr, .exr or .json", printable(path));
    state_.say(job_.probes == probes ? "opened " + path : fmt::format("opened {}, without probes", path));
    return {};
}

/// Succeeds or changes nothing.
Result<void> Viewer::remakePipelines() {
    GLINT_TRY(renderer, GuiRenderer::create(*context_));
    GLINT_CHECK(pictures_->remake());
    renderer_.emplace(std::move(renderer));
    return {};
}

/// Captures all passes of the next frame, including the scene's.
Result<void> Viewer::startCapture() {
    capturing_ = RenderDoc::find();
    if (!capturing_)
        return makeError(ErrorCode::NotFound, "RenderDoc is not here: start `renderdoccmd capture glint view ...`, or "
                                              "the program from within qrenderdoc");
    pictures_->restart();
    return {};
}

void Viewer::endCapture() {
    if (!capturing_)
        return;
    const bool captured = capturing_->end();
    state_.say(captured ? "captured a frame for RenderDoc" : "RenderDoc captured nothing", !captured);
    capturing_.reset();
}

/// Returns the probes option for another scene or lighting: a file of probes fits only its own.
std::string Viewer::probesElsewhere() const {
    return job_.probes == "auto" ? job_.probes : std::string();
}

/// As `glint render` with the same options, without files that belong to the previous scene.
Result<void> Viewer::openOtherScene(const std::string& path) {
    cli::RenderOptions options = options_.scene;
    options.scene = path;
    SettingsModel settings = state_.settings;
    GLINT_CHECK(settings.suitScene(cli::settingsRequest(options).defaults));
    render::RenderJob job = job_;
    job.scene = path;
    job.settings = settings.settings();
    job.camera.clear();
    job.environment = options_.scene.environment;
    job.probes = probesElsewhere();
    if (job.materials != render::kNoMaterials) // a file belongs to its scene
        job.materials.clear();
    job.time = 0;
    GLINT_CHECK(openScene(job));
    state_.settings = std::move(settings);
    return {};
}

/// Opens the same scene with another environment.
Result<void> Viewer::openEnvironment(const std::string& path) {
    render::RenderJob job = job_;
    job.environment = path;
    job.probes = probesElsewhere();
    const MaterialsModel materials = state_.materials;
    GLINT_CHECK(openSceneAgain(job));
    state_.materials = materials;
    return {};
}

/// Keeps settings, time and camera.
Result<void> Viewer::openSceneAgain(render::RenderJob job) {
    job.settings = state_.settings.settings();
    job.time = state_.animation.seconds;
    const OrbitCamera camera = state_.camera;
    const int cameraIndex = state_.cameraIndex;
    const std::optional<SavedCamera> saved = savedCamera_;
    GLINT_CHECK(openScene(job));
    state_.camera = camera;
    state_.cameraIndex = cameraIndex;
    savedCamera_ = saved;
    return {};
}

Result<void> Viewer::validated() const {
    if (!context_ || context_->validationMessages().empty())
        return {};
    return makeError(ErrorCode::Unsupported, "the validation layer has {} messages; the first: {}",
                     context_->validationMessages().size(), context_->validationMessages().front());
}

} // namespace

Result<void> runViewer(const ViewOptions& options) {
    ViewOptions checked = options;
    GLINT_TRY(job, cli::makePictureJob(checked.scene));
    GLINT_TRY(view, render::findView(checked.view));
    if (job.width == 0) {
        job.width = kWidth;
        job.height = kHeight;
    }
    if (!checked.screenshot.empty()) {
        GLINT_CHECK(cli::checkFolder("--screenshot", checked.screenshot));
        if (ending(checked.screenshot) != ".png")
            return invalidArgument("--screenshot {}: the name must end in .png", printable(checked.screenshot));
    }
    job.display = job.statistics = job.smoothStill = true;
    job.inspect = std::array<uint32_t, 2>{};
    Viewer viewer(checked, SettingsModel(cli::settingsRequest(checked.scene), job.settings), job);
    GLINT_CHECK(viewer.open());
    viewer.setView(std::string(view->name));
    GLINT_CHECK(viewer.run());
    return viewer.validated();
}

} // namespace glint::view
