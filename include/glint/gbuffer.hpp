// What a host hands over each frame: images that its renderer has anyway, and in which conventions they are.
// `prepare` converts once; nothing behind it knows about conventions.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>

namespace glint {

/// One of the host's images as it stands when Reflections::record is called. Glint returns it in the same layout.
struct HostImage {
    VkImage image = VK_NULL_HANDLE;    ///< null: absent
    VkImageView view = VK_NULL_HANDLE; ///< all that is to be read; of depth images the depth aspect alone
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 0;
    uint32_t height = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT; ///< that last wrote it
    VkAccessFlags2 access = VK_ACCESS_2_MEMORY_WRITE_BIT;                ///< with which they did
    uint32_t samples = 1;                                                ///< a pixel
    explicit operator bool() const { return image != VK_NULL_HANDLE; }
};

enum class DepthKind : uint8_t {
    Device, ///< as the rasterizer wrote it with View::viewToClip: reversed or not, finite or infinite is seen there
    LinearViewZ, ///< metres along the view axis, 0 for the background
};
enum class NormalSpace : uint8_t { World, View };
enum class NormalEncoding : uint8_t {
    Signed,          ///< xyz in [-1, 1]
    Unorm,           ///< xyz stored as n * 0.5 + 0.5
    Octahedral,      ///< two channels in [-1, 1]
    OctahedralUnorm, ///< two channels stored as p * 0.5 + 0.5
};
enum class Handedness : uint8_t { Right, Left }; ///< of view space: looks down -Z or +Z

/// What GBuffer::material holds.
enum class MaterialKind : uint8_t {
    F0Roughness,        ///< F0 in rgb, linear; roughness in a channel
    MetallicRoughness,  ///< metallic and roughness in a channel each, beside GBuffer::baseColor: glTF's own model
    SpecularGlossiness, ///< specular colour (F0) in rgb, linear; glossiness, 1 - perceptual roughness, in a channel
    /// A specular colour in rgb, linear, and no roughness: all that it reflects is sharp. Without an image every
    /// surface has (1, 1, 1), a full mirror.
    Standard,
};

/// Defaults are Glint's own conventions.
struct Conventions {
    DepthKind depth = DepthKind::Device;
    bool depthMinusOneToOne = false; ///< the clip volume's z is [-1, 1] (OpenGL) and depth stores z * 0.5 + 0.5
    bool clipYDown = false;          ///< +Y of clip space points down the picture (plain Vulkan viewports)
    Handedness handedness = Handedness::Right;
    NormalSpace normalSpace = NormalSpace::World;
    NormalEncoding normalEncoding = NormalEncoding::Octahedral;
    bool smoothness = false;       ///< the roughness channel holds 1 - perceptualRoughness
    uint32_t roughnessChannel = 3; ///< of `material`, [0, 3]; glossiness too
    MaterialKind material = MaterialKind::F0Roughness;
    uint32_t metallicChannel = 2; ///< of `material`, [0, 3]; MaterialKind::MetallicRoughness only
    /// Stored motion times this is previous UV - current UV, x and y: {-1, -1} for the opposite sign, {0.5f, -0.5f} for
    /// clip space with +Y up, {1 / width, 1 / height} for pixels. Jitter is left out of motion.
    float motionScale[2] = {1, 1};
    /// The alpha of `litRadiance` holds the mean of its linear channels without lights' highlights; of what has none
    /// (emission, the background), the mean of its channels. Highlights belong to the eye, and a mirror that shows them
    /// where the eye sees them shows lamps that are not there. With this, hits leave them out (screen.highlights).
    bool highlightsInAlpha = false;
};

/// All images have one size (but for backDepth) and are sampled (VK_IMAGE_USAGE_SAMPLED_BIT). A host that draws with
/// several samples a pixel hands over depth, normal, material and baseColor with all of them, unresolved: their means
/// would be surfaces that do not exist. The others are means over the samples, one a pixel.
struct GBuffer {
    HostImage depth;
    HostImage normal;    ///< shading normals; 16 bits a channel keep mirrors sharp, 8 do not
    HostImage material;  ///< as Conventions::material says; absent only with MaterialKind::Standard
    HostImage baseColor; ///< linear base colour in rgb; MaterialKind::MetallicRoughness only
    /// The host's whole lit picture, linear and scene-referred: where reflected colours come from.
    HostImage litRadiance;
    /// Optional: the part of litRadiance that stands in for reflections (environment or probe specular). Glint
    /// replaces exactly that. Absent: reflections are added to what is there.
    HostImage fallbackSpecular;
    /// Optional: where each pixel's surface was in the previous frame. screen.colorSource previous follows moving
    /// objects with it; without, it takes everything for at rest.
    HostImage motion;
    /// Optional: depth of the nearest surfaces that face away from the camera, drawn with the same camera and stored
    /// as `depth` is; of any size. screen.thicknessMode backface takes each surface to reach back to it.
    HostImage backDepth;
    Conventions conventions;
};

} // namespace glint
