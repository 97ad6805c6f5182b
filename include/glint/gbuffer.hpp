// SPDX-License-Identifier: MIT
// The images that a host provides each frame, and their conventions.
// `prepare` converts depth, normals and materials once. docs/conventions.md lists the images that later passes read.
#pragma once

#include <vulkan/vulkan_core.h>

#include <cstdint>
#include <optional>

namespace glint {

/// One of the host's images, in its state when Reflections::record is called. Glint leaves it in the same layout.
struct HostImage {
    VkImage image = VK_NULL_HANDLE;    ///< null: absent
    VkImageView view = VK_NULL_HANDLE; ///< the subresources to read; depth images: the depth aspect only
    VkFormat format = VK_FORMAT_UNDEFINED;
    uint32_t width = 0;
    uint32_t height = 0;
    VkImageLayout layout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
    VkPipelineStageFlags2 stages = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT; ///< stages of the last write
    VkAccessFlags2 access = VK_ACCESS_2_MEMORY_WRITE_BIT;                ///< access of the last write
    uint32_t samples = 1;                                                ///< samples per pixel
    // Optional facts, used to detect errors before the GPU runs. Vulkan has no query for them.
    VkImageUsageFlags usage = 0;             ///< usage that the image was created with; 0: not stated
    uint32_t mips = 0;                       ///< mip levels of `view`; 0: not stated
    std::optional<VkImageViewType> viewType; ///< type of `view`; absent: not stated
    explicit operator bool() const { return image != VK_NULL_HANDLE; }
};

enum class DepthKind : uint8_t {
    Device,      ///< device depth as rasterized with View::viewToClip; the matrix tells reversed and infinite depth
    LinearViewZ, ///< linear along the view axis: stored * Conventions::linearDepthScale is metres; 0: background
};
enum class NormalSpace : uint8_t { World, View };
enum class NormalEncoding : uint8_t {
    Signed,          ///< xyz in [-1, 1]
    Unorm,           ///< xyz stored as n * 0.5 + 0.5
    Octahedral,      ///< two channels in [-1, 1]
    OctahedralUnorm, ///< two channels stored as p * 0.5 + 0.5
};
enum class Handedness : uint8_t { Right, Left }; ///< of view space: the camera looks down -Z (Right) or +Z (Left)

/// The host's material model. GBuffer::roughness, metallic and specular state where its scalars are stored.
enum class MaterialKind : uint8_t {
    F0Roughness,        ///< F0 in the rgb of GBuffer::material, linear; roughness
    MetallicRoughness,  ///< GBuffer::baseColor, roughness, metallic, and optionally specular: glTF's model
    SpecularGlossiness, ///< F0 in the rgb of GBuffer::material, linear; GBuffer::roughness holds glossiness
    /// F0 in the rgb of GBuffer::material, linear; roughness is 0, so all reflections are sharp. Without an image F0 is
    /// (1, 1, 1), a perfect mirror.
    Standard,
};

/// What the value of GBuffer::roughness means.
enum class RoughnessKind : uint8_t {
    Perceptual, ///< perceptual roughness, the value that artists set
    Alpha,      ///< alpha of the GGX distribution: the square of perceptual roughness
    Smoothness, ///< 1 - perceptual roughness
};

/// Where a scalar of the material is stored: value = texel[channel] * scale + bias. Values below 0 count as 0, values
/// above 1 as 1, except for specular.
struct MaterialChannel {
    /// The image that holds the channel; absent: GBuffer::material. May be an image that the G-buffer states already,
    /// like normal or baseColor: state the same HostImage again.
    HostImage image = {};
    uint32_t channel = 0; ///< [0, 3]; the format must have it
    float scale = 1;      ///< 0: every pixel has the value `bias`, and no image is read
    float bias = 0;
};

/// Conventions of the host's images and matrices. Defaults are Glint's own conventions.
struct Conventions {
    DepthKind depth = DepthKind::Device;
    bool depthMinusOneToOne = false; ///< clip space z is in [-1, 1] (OpenGL); depth stores z * 0.5 + 0.5
    bool clipYDown = false;          ///< +Y of clip space points down in the image (default Vulkan viewports)
    Handedness handedness = Handedness::Right;
    NormalSpace normalSpace = NormalSpace::World;
    NormalEncoding normalEncoding = NormalEncoding::Octahedral;
    MaterialKind material = MaterialKind::F0Roughness;
    RoughnessKind roughness = RoughnessKind::Perceptual;
    /// Factor on stored linear depth that gives positive metres: -1 for the z of a right-handed view space, 0.01 for
    /// centimetres, the far distance for depth in [0, 1]. DepthKind::LinearViewZ only.
    float linearDepthScale = 1;
    /// Factor on stored motion, x and y, which gives previous UV - current UV: {-1, -1} for the opposite sign,
    /// {0.5f, -0.5f} for clip space with +Y up, {1 / width, 1 / height} for pixels. Motion must be non-jittered.
    float motionScale[2] = {1, 1};
    /// Factor that converts the third channel of motion ("2.5D motion") to viewZ in the previous frame - viewZ in this
    /// one, in metres: 1 if the channel holds that difference, -1 for the opposite sign. 0: there is no such channel;
    /// moved surfaces then count as having kept their viewZ, so histories of what approaches or recedes trail.
    /// Differences of device depth are not supported. A pixel's motion must be that of the surface in `depth`, not a
    /// mean over samples.
    float motionDepthScale = 0;
    /// True if the alpha of `litRadiance` holds the mean of its linear channels without lights' highlights. Where there
    /// are no highlights (emission, background) alpha holds the mean of the channels. Highlights depend on the view
    /// direction, so highlights copied from the frame appear at wrong places in a mirror. With this mean, hits exclude
    /// them (screen.highlights).
    bool highlightsInAlpha = false;

    bool operator==(const Conventions&) const = default;
};

/// The host's images of one frame. Requires the same size for all images except backDepth, VK_IMAGE_USAGE_SAMPLED_BIT
/// and a 2D view in a format that shaders read as float. Depth formats (D32, D24, D16, with or without stencil) are
/// allowed for depth and backDepth only. A host that draws with several samples per pixel provides depth, normal,
/// material, baseColor, coatNormal and the images of the material's scalars but occlusion unresolved, with all samples:
/// their means would describe surfaces that do not exist. It provides the other images resolved, with one sample per
/// pixel.
struct GBuffer {
    HostImage depth;
    HostImage normal; ///< shading normals; sharp mirrors need 16 bits per channel, 8 bits show stair-steps
    /// F0 in rgb, or with MaterialKind::MetallicRoughness no colour; and the scalars below that name no other image.
    /// Optional if none does, and with MaterialKind::Standard.
    HostImage material;
    HostImage baseColor;                        ///< linear base colour in rgb; MaterialKind::MetallicRoughness only
    MaterialChannel roughness = {.channel = 3}; ///< as Conventions::roughness states; glossiness: SpecularGlossiness
    MaterialChannel metallic = {.channel = 2};  ///< MaterialKind::MetallicRoughness only
    /// Specular of the dielectric part, whose F0 is 0.08 * value: 0.5 is glTF's 4 %. A host that stores F0 itself sets
    /// scale 12.5. MaterialKind::MetallicRoughness only.
    MaterialChannel specular = {.scale = 0, .bias = 0.5f};
    /// F90, the reflectance at grazing angles; with MaterialKind::MetallicRoughness that of the dielectric part, as
    /// metals have 1. The factor of KHR_materials_specular, which scales F90 as it scales F0. Not with
    /// MaterialKind::Standard.
    MaterialChannel f90 = {.scale = 0, .bias = 1};
    /// Strength of a clear coat over the surface, [0, 1], as KHR_materials_clearcoat: a second lobe of F0 0.04, which
    /// reflects the scene by itself and dims the surface by what it reflects. Where a coat is stated, F0 is the
    /// surface's own, not dimmed, and fallbackSpecular holds what both lobes reflect. Costs passes and memory only
    /// where it is stated: scale and bias not both 0.
    MaterialChannel coat = {.scale = 0, .bias = 0};
    MaterialChannel coatRoughness = {.scale = 0, .bias = 0}; ///< as Conventions::roughness states
    HostImage coatNormal; ///< optional: the coat's own normals, encoded as `normal` is; absent: those of `normal`
    /// Ambient occlusion: 1 is unoccluded. Darkens reflections from probes and the environment, whose visibility no ray
    /// has tested; the answers of rays are exact. One sample per pixel.
    MaterialChannel occlusion = {.scale = 0, .bias = 1};
    /// The host's lit image, linear and scene-referred (sRGB-encoded with input.colorIsGamma). Hits take their colour
    /// from it.
    HostImage litRadiance;
    /// Optional: the part of litRadiance that approximates reflections (environment or probe specular). Glint replaces
    /// exactly this part. Absent: reflections are added to litRadiance.
    HostImage fallbackSpecular;
    /// Optional: motion of each pixel's surface since the previous frame, in UV, and with Conventions::motionDepthScale
    /// in depth. Histories (screen.colorSource previous, the denoiser's) follow moving objects with it. Absent: all
    /// objects are treated as static.
    HostImage motion;
    /// Optional: depth of the nearest surfaces that face away from the camera, drawn with the same camera and stored
    /// like `depth`, in any size. With screen.thicknessMode backface each surface extends back to this depth.
    HostImage backDepth;
    /// Optional: depth of the nearest transparent surfaces, drawn with the same camera and stored like `depth`, with
    /// one sample per pixel; background depth where there are none. With screen.transparents, screen rays end there.
    HostImage transparentDepth;
    Conventions conventions;
};

} // namespace glint
