// What all stages of the frame share. A stage is a class in a folder of its own: it owns its pipelines and images,
// `record` records its passes and returns what the next stages read, and `rehearse` runs every pass that any settings
// may need, so that recording cannot fail (gpu::Frame::rehearsal).
#pragma once

#include "glint/reflections.hpp"
#include "gpu/pass.hpp"
#include "gpu/progress.hpp"
#include "gpu/retired.hpp"
#include "reflect/frame_plan.hpp"

#include <glm/glm.hpp>

#include <utility>

namespace glint::reflect {

/// Shared by all stages of one Reflections; outlives them.
struct StageContext {
    gpu::Context& gpu;
    ReflectionsDesc desc; ///< with the settings in force
    gpu::Progress progress;
    gpu::Retired retired; ///< replaced objects that may be in flight
    /// Pixels of the frame's images that the recorded frame uses, from the top left (View::width, height): what passes
    /// are dispatched over. Images are made for `width` x `height`.
    glm::uvec2 extent;
    FramePlan plan; ///< of the settings, inputs and sources in force

    uint32_t width() const { return desc.width; } ///< size of the frame's images in pixels
    uint32_t height() const { return desc.height; }
    const Settings& settings() const { return desc.settings; }
};

/// A host's images are fetched texel by texel, as many of their formats (depth, 16-bit normals) need not be filterable.
inline constexpr gpu::SamplerKind kTexels = gpu::SamplerKind::NearestClamp;

inline constexpr VkImageUsageFlags kCleared = VK_IMAGE_USAGE_TRANSFER_DST_BIT;
/// Usage of images that hosts may copy or draw over.
inline constexpr VkImageUsageFlags kShown =
    kCleared | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;

struct StageImage {
    const char* name;
    VkFormat format;
    uint32_t width;
    uint32_t height;
    VkImageUsageFlags more = 0; ///< in addition to sampled and storage usage
};

/// Creates the image if it does not exist. Errors: OutOfMemory.
inline Result<void> makeImage(gpu::Context& context, gpu::Image& image, const StageImage& wanted) {
    if (image)
        return {};
    GLINT_TRY(made, gpu::Image::create(
                        context, {wanted.name, wanted.format, wanted.width, wanted.height, 1, 1, gpu::ImageShape::Flat,
                                  VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT | wanted.more}));
    image = std::move(made);
    return {};
}

/// As makeImage, but also replaces an image that is smaller; frames in flight may still use that one. Returns true if
/// the image is new.
inline Result<bool> growImage(StageContext& stages, gpu::Image& image, const StageImage& wanted) {
    if (image && image.width() >= wanted.width && image.height() >= wanted.height)
        return false;
    gpu::Image made;
    GLINT_CHECK(makeImage(stages.gpu, made, wanted));
    stages.retired.keep(std::move(image));
    image = std::move(made);
    return true;
}

} // namespace glint::reflect
