#include "lab/view/scene_picture.hpp"

#include "gpu/transfer.hpp"
#include "lab/session/frame_mean.hpp"
#include "lab/session/settled_frames.hpp"
#include "lab/view/orbit_camera.hpp"

#include <algorithm>

namespace glint::view {
namespace {

bool sameSettings(const render::ProgramSettings& a, const render::ProgramSettings& b) {
    return render::settingsJson(a) == render::settingsJson(b);
}

} // namespace

Result<std::unique_ptr<ScenePicture>> ScenePicture::create(gpu::Context& context, const render::RenderJob& job) {
    GLINT_TRY(session, render::openJob(context, job));
    std::unique_ptr<ScenePicture> picture(new ScenePicture(context, job, std::move(session)));
    picture->camera_ = picture->session_.inputs().camera;
    picture->width_ = picture->session_.inputs().width;
    picture->height_ = picture->session_.inputs().height;
    GLINT_CHECK(picture->makeImages());
    return picture;
}

Result<gpu::Image> ScenePicture::makeImage() const {
    return gpu::Image::create(
        context_, {"view/picture", VK_FORMAT_R8G8B8A8_UNORM, width_, height_, 1, 1, gpu::ImageShape::Flat,
                   VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
}

Result<void> ScenePicture::makeImages() {
    static uint64_t made = 0; // unique across all pictures
    GLINT_TRY(image, makeImage());
    GLINT_TRY(second, makeImage());
    image_ = std::move(image);
    second_ = std::move(second);
    imagesMade_ = ++made;
    return {};
}

uint32_t ScenePicture::wanted() const {
    if (job_.stillFrames > 0)
        return job_.stillFrames;
    const Settings& settings = job_.settings.reflections;
    if (settings.rays.enabled && settings.rays.accumulate)
        return kAccumulatedFrames;
    const uint32_t settled = render::settledFrames(settings);
    return render::accumulates(job_) ? std::max(settled, render::kSmoothFrames) : settled;
}

Result<void> ScenePicture::setSettings(const render::ProgramSettings& settings) {
    if (!settingsRefused_ && sameSettings(settings, job_.settings))
        return {};
    settingsRefused_ = true; // until the session accepts them
    GLINT_CHECK(session_.setSettings(settings));
    settingsRefused_ = false;
    job_.settings = settings;
    changed();
    return {};
}

/// Call where camera or objects have moved: the denoiser's history goes on, and so must the noise.
void ScenePicture::moved() {
    frames_ = 0;
    if (!job_.settings.reflections.denoise.enabled)
        index_ = 0;
}

Result<void> ScenePicture::setCamera(const scene::Camera& camera) {
    if (sameCamera(camera, camera_))
        return {};
    GLINT_CHECK(session_.setCamera(camera));
    camera_ = camera;
    moved();
    return {};
}

Result<void> ScenePicture::setTime(double seconds) {
    if (seconds == job_.time)
        return {};
    GLINT_CHECK(session_.setTime(seconds));
    job_.time = seconds;
    moved();
    return {};
}

Result<void> ScenePicture::setMaterials(const scene::MaterialOverrides& overrides, uint64_t version) {
    if (version == materialsVersion_)
        return {};
    GLINT_CHECK(session_.setMaterials(overrides));
    materialsVersion_ = version;
    changed();
    return {};
}

Result<void> ScenePicture::resize(uint32_t width, uint32_t height) {
    if (width == width_ && height == height_)
        return {};
    GLINT_CHECK(session_.resize(width, height));
    width_ = width;
    height_ = height;
    changed();
    return makeImages();
}

Result<void> ScenePicture::remake() {
    GLINT_CHECK(session_.remake());
    changed();
    return {};
}

Result<void> ScenePicture::render() {
    render::FrameRequest request;
    if (render::accumulates(job_))
        request.mean = render::meanStep(job_, frames_, wanted());
    GLINT_TRY(times, session_.renderFrame(index_++, request));
    times_ = std::move(times);
    ++frames_;
    ++version_;
    return {};
}

Result<void> ScenePicture::show(const std::string& view) {
    return session_.showView(view, image_);
}

Result<void> ScenePicture::showSecond(const std::string& view) {
    return session_.showView(view, second_);
}

Result<std::vector<uint8_t>> ScenePicture::bytes() {
    GLINT_TRY(raw, gpu::downloadImage(context_, image_));
    GLINT_CHECK(context_.submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame(context_, commands)
            .hand(image_, {VK_PIPELINE_STAGE_2_FRAGMENT_SHADER_BIT, VK_ACCESS_2_SHADER_SAMPLED_READ_BIT,
                           VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }));
    std::vector<uint8_t> bytes;
    bytes.reserve(raw.size() / 4 * 3);
    for (size_t i = 0; i < raw.size(); ++i)
        if (i % 4 != 3)
            bytes.push_back(static_cast<uint8_t>(raw[i]));
    return bytes;
}

} // namespace glint::view
