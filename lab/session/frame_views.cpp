#include "lab/session/frame_views.hpp"

#include "gpu/transfer.hpp"
#include "lab/renderer/lending.hpp"

namespace glint::render {

Result<FrameViews> FrameViews::create(gpu::Context& context) {
    FrameViews views(context);
    GLINT_TRY(viewPass, ViewPass::create(context));
    views.viewPass_ = std::move(viewPass);
    GLINT_TRY(opacity, gpu::Pipeline::compute(context, {"render/opacity", sizeof(glm::uvec2), {}}));
    views.opacity_ = std::move(opacity);
    return views;
}

Result<void> FrameViews::resize(uint32_t width, uint32_t height) {
    const auto make = [&](const char* name, VkFormat format, VkImageUsageFlags usage) {
        return gpu::Image::create(*context_, {name, format, width, height, 1, 1, gpu::ImageShape::Flat,
                                              usage | VK_IMAGE_USAGE_TRANSFER_SRC_BIT});
    };
    GLINT_TRY(display,
              make("job/display", VK_FORMAT_R8G8B8A8_UNORM, VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_SAMPLED_BIT));
    display_ = std::move(display);
    GLINT_TRY(scene, make("job/scene", kRadianceFormat,
                          VK_IMAGE_USAGE_TRANSFER_DST_BIT | VK_IMAGE_USAGE_SAMPLED_BIT |
                              VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT));
    scene_ = std::move(scene);
    return {};
}

void FrameViews::keepScene(gpu::Frame& frame, GBuffer& gbuffer) {
    frame.copy(gbuffer.litRadiance, scene_);
    frame
        .pass(opacity_) // the alpha of the host's image is not opacity (Conventions::highlightsInAlpha)
        .read("albedo", gbuffer.albedo, gpu::SamplerKind::NearestClamp)
        .readWrite("picture", scene_)
        .push(glm::uvec2(scene_.width(), scene_.height()))
        .dispatch(scene_.width(), scene_.height());
}

Result<void> FrameViews::prepareMean(bool restart) {
    if (restart)
        mean_.clear();
    return mean_.prepare(*context_, scene_.width(), scene_.height());
}

void FrameViews::addToMean(gpu::Frame& frame, HostFrame& host) {
    host.display(frame, composite_, display_);
    mean_.add(frame, composite_, scene_, display_);
}

Result<void> FrameViews::show(const std::string& name, HostFrame& host, Reflections& reflections, gpu::Image& target) {
    GLINT_TRY(info, findView(name));
    Result<void> done;
    GLINT_CHECK(context_->submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(*context_, commands);
        if (name == "composite" && mean_.frames() > 0) {
            mean_.display(frame, target);
        } else if (name == "composite" || name == "scene") {
            host.display(frame, name == "composite" ? composite_ : scene_, target);
        } else if (info->drawn) {
            gpu::Image& drawn = host.gbuffer().*info->drawn;
            if (info->kind == ViewKind::Radiance)
                host.display(frame, drawn, target);
            else
                viewPass_.draw(frame, drawn, info->kind, target);
        } else if (const auto recorded = reflections.recordView(commands, name); !recorded) {
            done = recorded.error();
            return;
        } else {
            gpu::Image image = borrow(*recorded, "job/view");
            if (info->kind == ViewKind::Radiance)
                host.display(frame, image, target);
            else
                viewPass_.draw(frame, image, info->kind, target);
            frame.hand(image, kSampled);
        }
        frame.hand(composite_, kSampled); // the state in which the library left it
        frame.hand(target, kSampled);
    }));
    return done;
}

Result<RenderedView> FrameViews::read(const std::string& name, HostFrame& host, Reflections& reflections,
                                      bool display) {
    GLINT_TRY(info, findView(name));
    if (name == "composite")
        return readComposite(host, display);
    RenderedView view;
    view.name = name;
    if (name == "scene") {
        GLINT_TRY(rgba, gpu::downloadImageAsFloats(*context_, scene_));
        view.rgba = std::move(rgba);
        if (display)
            GLINT_CHECK(displayInto(view, host, scene_));
        return view;
    }
    if (info->drawn) {
        gpu::Image& drawn = host.gbuffer().*info->drawn;
        GLINT_TRY(rgba, gpu::downloadImageAsFloats(*context_, drawn));
        view.rgba = std::move(rgba);
        if (info->kind == ViewKind::Radiance && display)
            GLINT_CHECK(displayInto(view, host, drawn));
        return view;
    }
    Result<HostImage> recorded = HostImage{};
    GLINT_CHECK(
        context_->submitAndWait([&](VkCommandBuffer commands) { recorded = reflections.recordView(commands, name); }));
    GLINT_CHECK(recorded);
    gpu::Image image = borrow(*recorded, "job/view");
    GLINT_TRY(rgba, gpu::downloadImageAsFloats(*context_, image));
    view.rgba = std::move(rgba);
    if (info->kind == ViewKind::Radiance && display)
        GLINT_CHECK(displayInto(view, host, image));
    GLINT_CHECK(handBack(image));
    return view;
}

Result<void> FrameViews::handBack(gpu::Image& image) {
    return context_->submitAndWait(
        [&](VkCommandBuffer commands) { gpu::Frame(*context_, commands).hand(image, kSampled); });
}

Result<RenderedView> FrameViews::readComposite(HostFrame& host, bool display) {
    RenderedView view;
    view.name = "composite";
    if (mean_.frames() > 0) {
        GLINT_TRY(rgba, gpu::downloadImageAsFloats(*context_, mean_.radiance()));
        view.rgba = std::move(rgba);
        if (display)
            GLINT_CHECK(displayInto(view, [&](gpu::Frame& frame) { mean_.display(frame, display_); }));
        return view;
    }
    GLINT_TRY(rgba, gpu::downloadImageAsFloats(*context_, composite_));
    GLINT_TRY(scene, gpu::downloadImageAsFloats(*context_, scene_)); // both show the same surfaces
    view.rgba = std::move(rgba);
    for (size_t i = 3; i < scene.size(); i += 4)
        view.rgba[i] = scene[i];
    if (display)
        GLINT_CHECK(displayInto(view, host, composite_));
    GLINT_CHECK(handBack(composite_)); // the next frame's paths may end in it
    return view;
}

Result<void> FrameViews::displayInto(RenderedView& view, HostFrame& host, gpu::Image& radiance) {
    return displayInto(view, [&](gpu::Frame& frame) { host.display(frame, radiance, display_); });
}

Result<void> FrameViews::displayInto(RenderedView& view, const std::function<void(gpu::Frame&)>& draw) {
    GLINT_CHECK(context_->submitAndWait([&](VkCommandBuffer commands) {
        gpu::Frame frame(*context_, commands);
        draw(frame);
    }));
    GLINT_TRY(bytes, gpu::downloadImage(*context_, display_));
    view.rgb8.reserve(bytes.size() / 4 * 3);
    for (size_t i = 0; i < bytes.size(); ++i)
        if (i % 4 != 3)
            view.rgb8.push_back(static_cast<uint8_t>(bytes[i]));
    return {};
}

} // namespace glint::render
