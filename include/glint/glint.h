// SPDX-License-Identifier: MIT
// Glint for C, and for every language that calls C: Rust, C#, Zig, plug-ins. The same functions as the C++ headers of
// this folder, which describe each in full. C99. docs/embedding.md and examples/embed-c show a host.
//
// Structs. Each begins with `size`, the size of the struct that the host was compiled with. Call its glint_..._init,
// which writes `size` and the defaults, and then change members. Members are only ever appended. If the host's struct
// is shorter than the library's, missing members have their defaults; if it is longer, the excess must be zero, or the
// call fails. `reserved` stays 0. Arrays of structs have elements of one size, that of the first. Structs without
// `size` never change. Pointers to structs may be null where the comment says so. The library reads what pointers refer
// to during the call only.
//
// Objects. glint_..._create makes an object; glint_..._destroy, which accepts null, deletes it. Rules of lifetimes and
// threads are those of C++ (docs/embedding.md): no object is thread-safe, and the device outlives all.
//
// Errors. A function that can fail returns a GlintResult; the text is glint_last_error(). After an error, results are
// unchanged, and an object that was to be created is null. Functions that return text or a number return null or 0 for
// a null object.
#pragma once

#include "glint/api.h"

#include <vulkan/vulkan_core.h>

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/// Number of this interface. It increases when an existing function or member changes its meaning; additions keep it.
#define GLINT_C_ABI 1u

/// The outcome of a call; each error as in glint::ErrorCode.
typedef enum GlintResult {
    GLINT_SUCCESS = 0,
    GLINT_ERROR_INVALID_ARGUMENT = 1, ///< the caller's request is invalid: an unknown name, a value out of range
    GLINT_ERROR_INVALID_INPUT = 2,    ///< external data is malformed: JSON
    GLINT_ERROR_NOT_FOUND = 3,
    GLINT_ERROR_UNSUPPORTED = 4, ///< the request is valid, but this device or this build does not support it
    GLINT_ERROR_DEVICE_LOST = 5,
    GLINT_ERROR_OUT_OF_MEMORY = 6,
    GLINT_ERROR_IO = 7,
    GLINT_RESULT_MAX_ENUM = 0x7fffffff
} GlintResult;

/// glint::DeviceDemands
typedef enum GlintDeviceDemands {
    GLINT_DEVICE_DEMANDS_SCREEN = 0,
    GLINT_DEVICE_DEMANDS_SOURCES = 1,
    GLINT_DEVICE_DEMANDS_MAX_ENUM = 0x7fffffff
} GlintDeviceDemands;

/// glint::DepthKind
typedef enum GlintDepthKind {
    GLINT_DEPTH_DEVICE = 0,
    GLINT_DEPTH_LINEAR_VIEW_Z = 1,
    GLINT_DEPTH_MAX_ENUM = 0x7fffffff
} GlintDepthKind;

/// glint::Handedness
typedef enum GlintHandedness {
    GLINT_HANDEDNESS_RIGHT = 0,
    GLINT_HANDEDNESS_LEFT = 1,
    GLINT_HANDEDNESS_MAX_ENUM = 0x7fffffff
} GlintHandedness;

/// glint::NormalSpace
typedef enum GlintNormalSpace {
    GLINT_NORMAL_SPACE_WORLD = 0,
    GLINT_NORMAL_SPACE_VIEW = 1,
    GLINT_NORMAL_SPACE_MAX_ENUM = 0x7fffffff
} GlintNormalSpace;

/// glint::NormalEncoding
typedef enum GlintNormalEncoding {
    GLINT_NORMAL_ENCODING_SIGNED = 0,
    GLINT_NORMAL_ENCODING_UNORM = 1,
    GLINT_NORMAL_ENCODING_OCTAHEDRAL = 2,
    GLINT_NORMAL_ENCODING_OCTAHEDRAL_UNORM = 3,
    GLINT_NORMAL_ENCODING_MAX_ENUM = 0x7fffffff
} GlintNormalEncoding;

/// glint::MaterialKind
typedef enum GlintMaterialKind {
    GLINT_MATERIAL_F0_ROUGHNESS = 0,
    GLINT_MATERIAL_METALLIC_ROUGHNESS = 1,
    GLINT_MATERIAL_SPECULAR_GLOSSINESS = 2,
    GLINT_MATERIAL_STANDARD = 3,
    GLINT_MATERIAL_MAX_ENUM = 0x7fffffff
} GlintMaterialKind;

/// glint::RoughnessKind
typedef enum GlintRoughnessKind {
    GLINT_ROUGHNESS_PERCEPTUAL = 0,
    GLINT_ROUGHNESS_ALPHA = 1,
    GLINT_ROUGHNESS_SMOOTHNESS = 2,
    GLINT_ROUGHNESS_MAX_ENUM = 0x7fffffff
} GlintRoughnessKind;

/// glint::RayBackend
typedef enum GlintRayBackend {
    GLINT_RAY_BACKEND_AUTO = 0,
    GLINT_RAY_BACKEND_QUERY = 1,
    GLINT_RAY_BACKEND_BVH = 2,
    GLINT_RAY_BACKEND_MAX_ENUM = 0x7fffffff
} GlintRayBackend;

/// glint::InstanceNumbering
typedef enum GlintInstanceNumbering {
    GLINT_INSTANCE_NUMBERING_TOP_LEVEL_INDEX = 0,
    GLINT_INSTANCE_NUMBERING_CUSTOM_INDEX = 1,
    GLINT_INSTANCE_NUMBERING_MAX_ENUM = 0x7fffffff
} GlintInstanceNumbering;

/// glint::SurfaceAlpha
typedef enum GlintSurfaceAlpha {
    GLINT_SURFACE_ALPHA_OPAQUE = 0,
    GLINT_SURFACE_ALPHA_MASK = 1,
    GLINT_SURFACE_ALPHA_BLEND = 2,
    GLINT_SURFACE_ALPHA_MAX_ENUM = 0x7fffffff
} GlintSurfaceAlpha;

/// glint::SurfaceLightKind
typedef enum GlintSurfaceLightKind {
    GLINT_LIGHT_DIRECTIONAL = 0,
    GLINT_LIGHT_POINT = 1,
    GLINT_LIGHT_SPOT = 2,
    GLINT_LIGHT_MAX_ENUM = 0x7fffffff
} GlintSurfaceLightKind;

/// glint::ProbeShape
typedef enum GlintProbeShape {
    GLINT_PROBE_SHAPE_BOX = 0,
    GLINT_PROBE_SHAPE_SPHERE = 1,
    GLINT_PROBE_SHAPE_MAX_ENUM = 0x7fffffff
} GlintProbeShape;

/// glint::ProbeProxy
typedef enum GlintProbeProxy {
    GLINT_PROBE_PROXY_INFINITE = 0,
    GLINT_PROBE_PROXY_BOX = 1,
    GLINT_PROBE_PROXY_SPHERE = 2,
    GLINT_PROBE_PROXY_MAX_ENUM = 0x7fffffff
} GlintProbeProxy;

/// glint::SettingType
typedef enum GlintSettingType {
    GLINT_SETTING_BOOLEAN = 0,
    GLINT_SETTING_INT = 1,
    GLINT_SETTING_FLOAT = 2,
    GLINT_SETTING_CHOICE = 3,
    GLINT_SETTING_MAX_ENUM = 0x7fffffff
} GlintSettingType;

typedef struct GlintContext GlintContext;             ///< glint::Context
typedef struct GlintSettings GlintSettings;           ///< glint::Settings
typedef struct GlintReflections GlintReflections;     ///< glint::Reflections
typedef struct GlintRayScene GlintRayScene;           ///< glint::RayScene
typedef struct GlintSurfaceTable GlintSurfaceTable;   ///< glint::SurfaceTable
typedef struct GlintPlanarMirrors GlintPlanarMirrors; ///< glint::PlanarMirrors
typedef struct GlintProbes GlintProbes;               ///< glint::Probes

// ---------------------------------------------------------------- version and errors

/// Returns the version of the library, as GLINT_VERSION.
GLINT_API uint32_t glint_version(void);
/// Returns the text of this thread's last error: one line, UTF-8, empty before the first. Valid until the thread's next
/// call of Glint.
GLINT_API const char* glint_last_error(void);

// ---------------------------------------------------------------- the device

/// Receives a message for the host's log: one line of UTF-8, valid during the call.
typedef void (*GlintMessageCallback)(void* user, const char* text);

/// glint::HostDevice
typedef struct GlintContextDesc {
    uint32_t size;
    uint32_t queueFamily; ///< family of the command buffers; requires compute, not graphics
    VkInstance instance;
    VkPhysicalDevice physicalDevice;
    VkDevice device;
    PFN_vkGetInstanceProcAddr getInstanceProcAddr;
    VkBool32 rayQuery;                                ///< the host enabled ray queries
    GlintDeviceDemands demands;                       ///< the host enabled their features
    VkPipelineCache pipelineCache;                    ///< null: none
    const VkAllocationCallbacks* allocationCallbacks; ///< copied; null: the driver's own
    GlintMessageCallback message;                     ///< receives each note; null: none
    void* messageUser;
} GlintContextDesc;

GLINT_API void glint_context_desc_init(GlintContextDesc* desc, uint32_t size);

/// Returns the names of the device extensions that the host must enable, and in `count` how many.
GLINT_API const char* const* glint_required_device_extensions(uint32_t* count);
/// Returns the names of the further device extensions that ray queries require.
GLINT_API const char* const* glint_ray_query_extensions(uint32_t* count);
/// Enables every feature that Glint requires. A null struct is skipped.
GLINT_API void glint_require_device_features(VkPhysicalDeviceFeatures* core, VkPhysicalDeviceVulkan12Features* v12,
                                             VkPhysicalDeviceVulkan13Features* v13, GlintDeviceDemands demands);

/// Creates a context on the host's device. `abi`: GLINT_C_ABI, the interface that the host was compiled with.
GLINT_API GlintResult glint_context_adopt(const GlintContextDesc* desc, uint32_t abi, GlintContext** context);
GLINT_API void glint_context_destroy(GlintContext* context);
GLINT_API const char* glint_context_device_name(const GlintContext* context);
GLINT_API const char* glint_context_driver(const GlintContext* context);

/// Device memory of all images and buffers of one name (glint::MemoryUse).
typedef struct GlintMemoryUse {
    const char* name;
    uint64_t bytes;
    uint32_t count;
    uint32_t reserved;
} GlintMemoryUse;

/// glint::MemoryReport
typedef struct GlintMemoryReport {
    uint32_t size;
    uint32_t useCount;
    const GlintMemoryUse*
        uses;       ///< the largest first; valid until the next call of glint_context_memory with this object
    uint64_t bytes; ///< of all images and buffers
    uint64_t taken; ///< of the driver
} GlintMemoryReport;

GLINT_API void glint_memory_report_init(GlintMemoryReport* report, uint32_t size);
/// Device memory in use now. `report->size` must be set.
GLINT_API GlintResult glint_context_memory(GlintContext* context, GlintMemoryReport* report);

// ---------------------------------------------------------------- settings

/// One setting (glint::SettingInfo). Texts belong to the library and last as long as it is loaded.
typedef struct GlintSettingInfo {
    uint32_t size;
    GlintSettingType type;
    const char* key;     ///< "screen.maxDistance"
    const char* unit;    ///< "m"; empty: a plain number
    const char* meaning; ///< one line
    double defaultValue; ///< Boolean: 0 or 1; Choice: index into `choices`
    double min;          ///< Int and Float: the range
    double max;
    VkBool32 minOpen; ///< the range excludes `min`
    VkBool32 maxOpen;
    const char* const* choices; ///< Choice: names of the values
    uint32_t choiceCount;
    uint32_t reserved;
} GlintSettingInfo;

GLINT_API void glint_setting_info_init(GlintSettingInfo* info, uint32_t size);
GLINT_API uint32_t glint_setting_count(void);
/// Describes setting `index`, in the order of docs/settings.md. Errors: InvalidArgument for an index out of range.
GLINT_API GlintResult glint_setting_info(uint32_t index, GlintSettingInfo* info);

GLINT_API uint32_t glint_preset_count(void);
/// Returns the name of a preset; null for an index out of range.
GLINT_API const char* glint_preset_name(uint32_t index);

/// Creates settings with their defaults.
GLINT_API GlintResult glint_settings_create(GlintSettings** settings);
GLINT_API void glint_settings_destroy(GlintSettings* settings);
/// Sets one setting from text: ("screen.step", "4", NULL). `preset` may be null (glint::set).
GLINT_API GlintResult glint_settings_set(GlintSettings* settings, const char* key, const char* value,
                                         const char* preset);
/// Sets one setting from a number: Boolean 0 or 1, Choice its index. Errors: InvalidArgument for an unknown key, a
/// value out of range or, except for Float, one with a fraction.
GLINT_API GlintResult glint_settings_set_number(GlintSettings* settings, const char* key, double value);
/// Reads one setting, as set_number would set it.
GLINT_API GlintResult glint_settings_get_number(const GlintSettings* settings, const char* key, double* value);
/// Sets what the JSON names. `name` states in errors where the text comes from; `preset` may be null (glint::fromJson).
GLINT_API GlintResult glint_settings_from_json(GlintSettings* settings, const char* text, size_t length,
                                               const char* name, const char* preset);
/// Writes all settings as JSON with a terminating zero into `text`, as much as `capacity` bytes hold; returns the
/// length of all of it without the zero. `text` may be null with capacity 0.
GLINT_API size_t glint_settings_to_json(const GlintSettings* settings, char* text, size_t capacity);
/// Defaults, then what the preset says.
GLINT_API GlintResult glint_settings_apply_preset(GlintSettings* settings, const char* name);

// ---------------------------------------------------------------- images

/// One of the host's images, or one that Glint returns (glint::HostImage).
typedef struct GlintImage {
    uint32_t size;
    VkFormat format;
    VkImage image;
    VkImageView view;
    uint32_t width;
    uint32_t height;
    VkImageLayout layout;
    uint32_t samples;
    VkPipelineStageFlags2 stages; ///< stages of the last write
    VkAccessFlags2 access;        ///< access of the last write
    VkImageUsageFlags usage;      ///< 0: not stated
    uint32_t mips;                ///< 0: not stated
    VkImageViewType viewType;     ///< VK_IMAGE_VIEW_TYPE_MAX_ENUM: not stated
    uint32_t reserved;
} GlintImage;

GLINT_API void glint_image_init(GlintImage* image, uint32_t size);

/// Where a scalar of the material is stored (glint::MaterialChannel).
typedef struct GlintMaterialChannel {
    uint32_t size;
    uint32_t channel;        ///< [0, 3]
    const GlintImage* image; ///< null: GlintGBuffer::material
    float scale;
    float bias;
} GlintMaterialChannel;

GLINT_API void glint_material_channel_init(GlintMaterialChannel* channel, uint32_t size);

/// glint::Conventions
typedef struct GlintConventions {
    uint32_t size;
    GlintDepthKind depth;
    VkBool32 depthMinusOneToOne;
    VkBool32 clipYDown;
    GlintHandedness handedness;
    GlintNormalSpace normalSpace;
    GlintNormalEncoding normalEncoding;
    GlintMaterialKind material;
    GlintRoughnessKind roughness;
    float linearDepthScale;
    float motionScale[2];
    VkBool32 highlightsInAlpha;
    float motionDepthScale;
} GlintConventions;

GLINT_API void glint_conventions_init(GlintConventions* conventions, uint32_t size);

/// The host's images of one frame (glint::GBuffer). A null image is absent, a null channel has its default, and null
/// conventions are Glint's own.
typedef struct GlintGBuffer {
    uint32_t size;
    uint32_t reserved;
    const GlintImage* depth;
    const GlintImage* normal;
    const GlintImage* material;
    const GlintImage* baseColor;
    const GlintMaterialChannel* roughness;
    const GlintMaterialChannel* metallic;
    const GlintMaterialChannel* specular;
    const GlintMaterialChannel* occlusion;
    const GlintImage* litRadiance;
    const GlintImage* fallbackSpecular;
    const GlintImage* motion;
    const GlintImage* backDepth;
    const GlintConventions* conventions;
    const GlintImage* transparentDepth;
    const GlintMaterialChannel* f90;
    const GlintMaterialChannel* coat;
    const GlintMaterialChannel* coatRoughness;
    const GlintImage* coatNormal;
} GlintGBuffer;

GLINT_API void glint_gbuffer_init(GlintGBuffer* gbuffer, uint32_t size);

/// glint::EnvironmentMap
typedef struct GlintEnvironmentMap {
    uint32_t size;
    uint32_t mips;
    const GlintImage* cube;
    const GlintImage* diffuse; ///< null: absent
    float strength;
    float rotation; ///< radians
    VkBool32 flipY;
    uint32_t reserved;
} GlintEnvironmentMap;

GLINT_API void glint_environment_map_init(GlintEnvironmentMap* environment, uint32_t size);

/// The host's images for the results (glint::Outputs). Null: absent.
typedef struct GlintOutputs {
    uint32_t size;
    uint32_t reserved;
    const GlintImage* composite;
    const GlintImage* reflection;
} GlintOutputs;

GLINT_API void glint_outputs_init(GlintOutputs* outputs, uint32_t size);

/// A layer of transparent surfaces (glint::TransparentLayer). Null: absent.
typedef struct GlintTransparentLayer {
    uint32_t size;
    uint32_t reserved;
    const GlintImage* depth;
    const GlintImage* normal;
    const GlintImage* material;
    const GlintImage* radiance;
    const GlintImage* fallbackSpecular;
    const GlintImage* transmittance;
    const GlintImage* absorption;
    const GlintImage* body;
    const GlintImage* objectCenter;
    const GlintImage* coverage;
} GlintTransparentLayer;

GLINT_API void glint_transparent_layer_init(GlintTransparentLayer* layer, uint32_t size);

/// The camera of a frame (glint::View). Matrices are column-major.
typedef struct GlintView {
    uint32_t size;
    uint32_t frameIndex;
    float worldToView[16];
    float viewToClip[16];
    uint32_t seed;
    float seconds;
    VkBool32 cut;
    uint32_t width;
    uint32_t height;
    uint32_t reserved;
    uint64_t frameNumber;
} GlintView;

GLINT_API void glint_view_init(GlintView* view, uint32_t size);

// ---------------------------------------------------------------- rays

/// Triangles in local space (glint::RayMesh).
typedef struct GlintRayMesh {
    uint32_t size;
    uint32_t vertexCount;
    const float* positions;  ///< x, y, z of each vertex
    const uint32_t* indices; ///< three per triangle
    uint32_t indexCount;
    uint32_t vertexStride; ///< bytes
    VkBool32 deforms;
    uint32_t reserved;
} GlintRayMesh;

GLINT_API void glint_ray_mesh_init(GlintRayMesh* mesh, uint32_t size);

/// glint::RayInstance
typedef struct GlintRayInstance {
    uint32_t size;
    uint32_t mesh;
    float localToWorld[16];
    uint32_t mask; ///< [0, 255]
    VkBool32 opaque;
    VkBool32 doubleSided;
} GlintRayInstance;

GLINT_API void glint_ray_instance_init(GlintRayInstance* instance, uint32_t size);

/// glint::RaySceneDesc
typedef struct GlintRaySceneDesc {
    uint32_t size;
    uint32_t meshCount;
    const GlintRayMesh* meshes;
    const GlintRayInstance* instances;
    uint32_t instanceCount;
    uint32_t maxInstances;
    GlintRayBackend backend;
    uint32_t reserved;
} GlintRaySceneDesc;

GLINT_API void glint_ray_scene_desc_init(GlintRaySceneDesc* desc, uint32_t size);

/// A top-level acceleration structure of the host (glint::HostAccelerationStructure).
typedef struct GlintHostAccelerationStructure {
    uint32_t size;
    uint32_t instanceCount;
    VkAccelerationStructureKHR topLevel;
    const uint32_t* triangleCounts; ///< instanceCount numbers; null: unknown
    GlintInstanceNumbering numbering;
    float transparentLowWS[3];
    float transparentHighWS[3];
    uint32_t reserved;
} GlintHostAccelerationStructure;

GLINT_API void glint_host_acceleration_structure_init(GlintHostAccelerationStructure* host, uint32_t size);

/// glint::RaySceneTimes
typedef struct GlintRaySceneTimes {
    uint32_t size;
    uint32_t reserved;
    double cpuBuildMs;
    double cpuUpdateMs;
    double gpuBuildMs;
    double gpuUpdateMs;
} GlintRaySceneTimes;

GLINT_API void glint_ray_scene_times_init(GlintRaySceneTimes* times, uint32_t size);

GLINT_API GlintResult glint_ray_scene_create(GlintContext* context, const GlintRaySceneDesc* desc,
                                             GlintRayScene** scene);
/// A scene of the host's own top level, which the host builds and owns (glint::RayScene::adopt).
GLINT_API GlintResult glint_ray_scene_adopt(GlintContext* context, const GlintHostAccelerationStructure* host,
                                            GlintRayScene** scene);
GLINT_API void glint_ray_scene_destroy(GlintRayScene* scene);
GLINT_API GlintRayBackend glint_ray_scene_backend(const GlintRayScene* scene);
/// Replaces the host's top level of an adopted scene, from the next recording on.
GLINT_API GlintResult glint_ray_scene_set_acceleration_structure(GlintRayScene* scene,
                                                                 const GlintHostAccelerationStructure* host);
GLINT_API GlintResult glint_ray_scene_set_instances(GlintRayScene* scene, const GlintRayInstance* instances,
                                                    uint32_t count);
/// Replaces `count` instances from `first` on and leaves the others.
GLINT_API GlintResult glint_ray_scene_update_instances(GlintRayScene* scene, uint32_t first,
                                                       const GlintRayInstance* instances, uint32_t count);
GLINT_API GlintResult glint_ray_scene_deform(GlintRayScene* scene, uint32_t mesh, const float* positions,
                                             uint32_t vertexCount, uint32_t vertexStride);
GLINT_API void glint_ray_scene_record(GlintRayScene* scene, VkCommandBuffer commands);
GLINT_API void glint_ray_scene_release_staging(GlintRayScene* scene);
GLINT_API GlintResult glint_ray_scene_times(GlintRayScene* scene, GlintRaySceneTimes* times);

/// glint::SurfaceTexture
typedef struct GlintSurfaceTexture {
    VkImageView view;
    VkSampler sampler;
} GlintSurfaceTexture;

/// One use of a texture by a material (glint::SurfaceTextureRef).
typedef struct GlintSurfaceTextureRef {
    uint32_t index;    ///< 0xffffffff: the factor only
    uint32_t texCoord; ///< 0: uv0, 1: uv1
    float uvTransform[6];
} GlintSurfaceTextureRef;

/// A material of glTF 2.0 and its extensions (glint::SurfaceMaterial).
typedef struct GlintSurfaceMaterial {
    uint32_t size;
    GlintSurfaceAlpha alpha;
    float alphaCutoff;
    VkBool32 unlit;
    float baseColorFactor[4];
    GlintSurfaceTextureRef baseColorTexture;
    float metallicFactor;
    float roughnessFactor;
    GlintSurfaceTextureRef metallicRoughnessTexture;
    GlintSurfaceTextureRef normalTexture;
    float normalScale;
    GlintSurfaceTextureRef occlusionTexture;
    float occlusionStrength;
    float emissiveFactor[3];
    GlintSurfaceTextureRef emissiveTexture;
    float specularFactor;
    GlintSurfaceTextureRef specularTexture;
    float specularColorFactor[3];
    GlintSurfaceTextureRef specularColorTexture;
    float ior;
    float transmissionFactor;
    GlintSurfaceTextureRef transmissionTexture;
    float thicknessFactor;
    GlintSurfaceTextureRef thicknessTexture;
    float attenuationColor[3];
    float attenuationDistance;
    float clearcoatFactor;
    float clearcoatRoughnessFactor;
    GlintSurfaceTextureRef clearcoatTexture;
    GlintSurfaceTextureRef clearcoatRoughnessTexture;
    GlintSurfaceTextureRef clearcoatNormalTexture;
    float clearcoatNormalScale;
    VkBool32 specularGlossiness;
    float specularGlossinessFactor[3];
    float glossinessFactor;
    GlintSurfaceTextureRef specularGlossinessTexture;
} GlintSurfaceMaterial;

GLINT_API void glint_surface_material_init(GlintSurfaceMaterial* material, uint32_t size);

/// glint::VertexStream
typedef struct GlintVertexStream {
    VkDeviceAddress address; ///< 0: absent
    uint32_t stride;         ///< bytes
    uint32_t reserved;
} GlintVertexStream;

/// glint::SurfaceMesh
typedef struct GlintSurfaceMesh {
    uint32_t size;
    uint32_t reserved;
    GlintVertexStream positions;
    GlintVertexStream normals;
    GlintVertexStream tangents;
    GlintVertexStream uv0;
    GlintVertexStream uv1;
    GlintVertexStream colors;
    VkDeviceAddress indices;
    GlintVertexStream previousPositions;
} GlintSurfaceMesh;

GLINT_API void glint_surface_mesh_init(GlintSurfaceMesh* mesh, uint32_t size);

/// glint::SurfaceInstance
typedef struct GlintSurfaceInstance {
    uint32_t size;
    uint32_t mesh;
    uint32_t material;
    float localToWorld[16];
} GlintSurfaceInstance;

GLINT_API void glint_surface_instance_init(GlintSurfaceInstance* instance, uint32_t size);

/// glint::SurfaceLight
typedef struct GlintSurfaceLight {
    uint32_t size;
    GlintSurfaceLightKind kind;
    float color[3];
    float positionWS[3];
    float directionWS[3];
    float range;
    float innerConeAngle;
    float outerConeAngle;
    VkBool32 castsShadow;
} GlintSurfaceLight;

GLINT_API void glint_surface_light_init(GlintSurfaceLight* light, uint32_t size);

/// glint::SurfaceTableDesc
typedef struct GlintSurfaceTableDesc {
    uint32_t size;
    uint32_t textureCount;
    const GlintSurfaceTexture* textures;
    const GlintSurfaceMaterial* materials;
    const GlintSurfaceMesh* meshes;
    const GlintSurfaceInstance* instances;
    const GlintSurfaceLight* lights;
    uint32_t materialCount;
    uint32_t meshCount;
    uint32_t instanceCount;
    uint32_t lightCount;
    uint32_t maxInstances;
    uint32_t maxLights;
} GlintSurfaceTableDesc;

GLINT_API void glint_surface_table_desc_init(GlintSurfaceTableDesc* desc, uint32_t size);

GLINT_API GlintResult glint_surface_table_create(GlintContext* context, const GlintSurfaceTableDesc* desc,
                                                 GlintSurfaceTable** table);
GLINT_API void glint_surface_table_destroy(GlintSurfaceTable* table);
GLINT_API GlintResult glint_surface_table_set_instances(GlintSurfaceTable* table, const GlintSurfaceInstance* instances,
                                                        uint32_t count);
/// Replaces `count` items from `first` on and leaves the others.
GLINT_API GlintResult glint_surface_table_update_instances(GlintSurfaceTable* table, uint32_t first,
                                                           const GlintSurfaceInstance* instances, uint32_t count);
GLINT_API GlintResult glint_surface_table_update_materials(GlintSurfaceTable* table, uint32_t first,
                                                           const GlintSurfaceMaterial* materials, uint32_t count);
GLINT_API GlintResult glint_surface_table_set_lights(GlintSurfaceTable* table, const GlintSurfaceLight* lights,
                                                     uint32_t count);
GLINT_API GlintResult glint_surface_table_set_materials(GlintSurfaceTable* table, const GlintSurfaceMaterial* materials,
                                                        uint32_t count);
GLINT_API GlintResult glint_surface_table_set_meshes(GlintSurfaceTable* table, const GlintSurfaceMesh* meshes,
                                                     uint32_t count);
GLINT_API void glint_surface_table_record(GlintSurfaceTable* table, VkCommandBuffer commands);

/// The hit of one ray as the GPU stores it (glint::RayHit).
typedef struct GlintRayHit {
    uint32_t pixel;
    float distance;
    uint32_t instance;
    uint32_t primitive;
    float barycentrics[2];
    uint32_t frontFace;
    float coneWidth;
    float originWS[3];
    float directionWS[3];
} GlintRayHit;

/// Inputs and output of the host's hit shading (glint::RayHits).
typedef struct GlintRayHits {
    uint32_t size;
    uint32_t reserved;
    VkBuffer arguments;
    VkBuffer hits;
    VkDeviceSize hitsSize;
    const GlintImage* answer;
} GlintRayHits;

/// Records the host's hit shading into the frame's command buffer. `user` is the pointer of set_shaded_rays.
typedef void (*GlintShadeHits)(void* user, VkCommandBuffer commands, const GlintRayHits* hits);

// ---------------------------------------------------------------- planar mirrors

/// glint::PlanarMirror
typedef struct GlintPlanarMirror {
    uint32_t size;
    float centerWS[3];
    float normalWS[3];
    float tangentWS[3];
    float halfExtents[2];
    float tolerance;
} GlintPlanarMirror;

GLINT_API void glint_planar_mirror_init(GlintPlanarMirror* mirror, uint32_t size);

/// The image that the host drew for a mirror (glint::PlanarPicture).
typedef struct GlintPlanarPicture {
    uint32_t size;
    uint32_t reserved;
    const GlintImage* radiance;
    const GlintImage* depth;
    const GlintView* view; ///< as glint_mirrored_view returned it
} GlintPlanarPicture;

GLINT_API void glint_planar_picture_init(GlintPlanarPicture* picture, uint32_t size);

/// glint::PlanarMirrorsDesc
typedef struct GlintPlanarMirrorsDesc {
    uint32_t size;
    uint32_t mirrorCount;
    const GlintPlanarMirror* mirrors;
    uint32_t width;
    uint32_t height;
    const GlintConventions* conventions; ///< null: Glint's own
} GlintPlanarMirrorsDesc;

GLINT_API void glint_planar_mirrors_desc_init(GlintPlanarMirrorsDesc* desc, uint32_t size);

/// Computes the mirrored camera. `mirrored->size` must be set.
GLINT_API GlintResult glint_mirrored_view(const GlintView* view, const GlintPlanarMirror* mirror, GlintView* mirrored);
/// Computes the clip plane (n, d) of a mirror.
GLINT_API GlintResult glint_clip_plane(const GlintPlanarMirror* mirror, float plane[4]);
/// Writes VK_TRUE if the camera is on the reflecting side.
GLINT_API GlintResult glint_faces_view(const GlintPlanarMirror* mirror, const GlintView* view, VkBool32* faces);

GLINT_API GlintResult glint_planar_mirrors_create(GlintContext* context, const GlintPlanarMirrorsDesc* desc,
                                                  GlintPlanarMirrors** mirrors);
GLINT_API void glint_planar_mirrors_destroy(GlintPlanarMirrors* mirrors);
GLINT_API uint32_t glint_planar_mirrors_count(const GlintPlanarMirrors* mirrors);
GLINT_API GlintResult glint_planar_mirrors_set(GlintPlanarMirrors* mirrors, const GlintPlanarMirror* places,
                                               uint32_t count);
GLINT_API GlintResult glint_planar_mirrors_record(GlintPlanarMirrors* mirrors, VkCommandBuffer commands,
                                                  uint32_t mirror, const GlintPlanarPicture* picture);
GLINT_API GlintResult glint_planar_mirrors_skip(GlintPlanarMirrors* mirrors, uint32_t mirror);

// ---------------------------------------------------------------- probes

/// glint::ProbeVolume
typedef struct GlintProbeVolume {
    float centerWS[3];
    float rotation[4];
    float halfExtents[3];
} GlintProbeVolume;

/// glint::Probe
typedef struct GlintProbe {
    uint32_t size;
    uint32_t mips;
    const GlintImage* cube;
    VkBool32 prefiltered;
    VkBool32 alphaIsInverseDistance;
    float capturePositionWS[3];
    float strength;
    float weight;
    GlintProbeShape shape;
    GlintProbeVolume influence;
    float blendDistance[6];
    float blendNormalDistance[6];
    float faceFade[6];
    GlintProbeProxy proxy;
    GlintProbeVolume proxyVolume;
    uint32_t reserved;
} GlintProbe;

GLINT_API void glint_probe_init(GlintProbe* probe, uint32_t size);

/// glint::ProbesDesc
typedef struct GlintProbesDesc {
    uint32_t size;
    uint32_t probeCount;
    const GlintProbe* probes;
    uint32_t faceSize;
    uint32_t reserved;
} GlintProbesDesc;

GLINT_API void glint_probes_desc_init(GlintProbesDesc* desc, uint32_t size);

GLINT_API GlintResult glint_probes_create(GlintContext* context, const GlintProbesDesc* desc, GlintProbes** probes);
GLINT_API void glint_probes_destroy(GlintProbes* probes);
GLINT_API uint32_t glint_probes_count(const GlintProbes* probes);
GLINT_API GlintResult glint_probes_set_volumes(GlintProbes* probes, const GlintProbe* volumes, uint32_t count);
GLINT_API GlintResult glint_probes_refilter(GlintProbes* probes, uint32_t probe);
GLINT_API void glint_probes_record(GlintProbes* probes, VkCommandBuffer commands);
/// Returns the filtered cube and the number of its mips. `cube->size` must be set.
GLINT_API GlintResult glint_probes_cube(const GlintProbes* probes, uint32_t probe, GlintImage* cube, uint32_t* mips);

// ---------------------------------------------------------------- reflections

/// glint::ReflectionsDesc
typedef struct GlintReflectionsDesc {
    uint32_t size;
    uint32_t width; ///< pixels
    uint32_t height;
    uint32_t framesInFlight;
    const GlintSettings* settings; ///< copied; null: defaults
    VkBool32 statistics;
    VkBool32 views;
    VkBool32 transparentLayers;
    VkBool32 timers;
    VkBool32 inspection;
    VkBool32 inputCheck;
} GlintReflectionsDesc;

GLINT_API void glint_reflections_desc_init(GlintReflectionsDesc* desc, uint32_t size);

/// How many pixels had this outcome (glint::Statistics::Outcome).
typedef struct GlintOutcome {
    const char* name; ///< "hit", "offScreen", ...
    uint64_t count;
} GlintOutcome;

/// glint::Statistics
typedef struct GlintStatistics {
    uint32_t size;
    uint32_t outcomeCount;
    const GlintOutcome* outcomes; ///< valid until the next call of glint_reflections_statistics with this object
    uint64_t rays;
    double lookupsMean;
    uint32_t lookups95;
    uint32_t reserved;
    uint64_t scenePixels;
    uint64_t sceneRays;
    uint64_t sceneFromScreen;
    uint64_t sceneReplaced;
    uint64_t sceneReusedLight;
} GlintStatistics;

GLINT_API void glint_statistics_init(GlintStatistics* statistics, uint32_t size);

/// glint::InputCheck. The texts of the findings: glint_reflections_input_finding.
typedef struct GlintInputCheck {
    uint32_t size;
    uint32_t findingCount;
    uint64_t tested;
    double normalsAgree;
    VkBool32 motionCompared;
    uint32_t reserved;
} GlintInputCheck;

GLINT_API void glint_input_check_init(GlintInputCheck* check, uint32_t size);

/// glint::KnownPlane
typedef struct GlintKnownPlane {
    uint32_t size;
    float pointWS[3];
    float normalWS[3];
    uint32_t reserved;
} GlintKnownPlane;

GLINT_API void glint_known_plane_init(GlintKnownPlane* plane, uint32_t size);

/// glint::RaySample. Texts are valid until the program ends.
typedef struct GlintRaySample {
    float positionPX[2];
    uint32_t level;
    float rayDepth;
    float sceneDepth;
    float slabEndDepth; ///< NaN: not fetched
    float distance;
    uint32_t reserved;
    const char* decision;
} GlintRaySample;

/// glint::RayInspection::Point
typedef struct GlintRayPoint {
    float px[2];
    float positionVS[3];
    float positionWS[3];
    float depth;
} GlintRayPoint;

/// glint::RayInspection::Fade
typedef struct GlintRayFade {
    const char* name;
    float factor;
    uint32_t reserved;
} GlintRayFade;

/// glint::RayInspection::Source
typedef struct GlintRaySource {
    const char* name;
    float weight;
    float radiance[3];
} GlintRaySource;

/// glint::RayInspection. Lists are valid until the next call of glint_reflections_inspection with this object.
typedef struct GlintRayInspection {
    uint32_t size;
    uint32_t sampleCount;
    const GlintRaySample* samples;
    const GlintRayFade* fades;
    const GlintRaySource* sources;
    uint32_t fadeCount;
    uint32_t sourceCount;
    const char* whyNoRay; ///< null: a ray was traced
    const char* outcome;
    uint32_t pixel[2];
    uint32_t rayPixel[2];
    VkBool32 background;
    float depth;
    float positionWS[3];
    float normalWS[3];
    float f0[3];
    float perceptualRoughness;
    VkBool32 traced;
    GlintRayPoint start;
    GlintRayPoint end;
    float directionVS[3];
    float directionWS[3];
    float maxLength;
    float length;
    VkBool32 hit;
    VkBool32 answered;
    VkBool32 hasHitPixel;
    uint32_t hitPixel[2];
    float hitDepth;
    float radiance[3];
    float weight;
    uint32_t lookups;
    uint32_t iterations;
    VkBool32 truncated;
    VkBool32 sameAsFrame;
    float totalWeight;
    float reflected[3];
    float composite[4];
    uint32_t projectedProbe; ///< march proxy; UINT32_MAX: no probe holds the pixel
    const char* proxy;       ///< march proxy: "none", "box" or "sphere"; null: another march
    float projectionDistance;
    uint32_t reserved;
} GlintRayInspection;

GLINT_API void glint_ray_inspection_init(GlintRayInspection* inspection, uint32_t size);

GLINT_API GlintResult glint_reflections_create(GlintContext* context, const GlintReflectionsDesc* desc,
                                               GlintReflections** reflections);
GLINT_API void glint_reflections_destroy(GlintReflections* reflections);
GLINT_API GlintResult glint_reflections_resize(GlintReflections* reflections, uint32_t width, uint32_t height);
GLINT_API GlintResult glint_reflections_set_settings(GlintReflections* reflections, const GlintSettings* settings);
/// `environment` may be null.
GLINT_API GlintResult glint_reflections_set_inputs(GlintReflections* reflections, const GlintGBuffer* gbuffer,
                                                   const GlintEnvironmentMap* environment);
GLINT_API GlintResult glint_reflections_set_outputs(GlintReflections* reflections, const GlintOutputs* outputs);
GLINT_API GlintResult glint_reflections_set_rays(GlintReflections* reflections, GlintRayScene* scene,
                                                 GlintSurfaceTable* surfaces);
/// For a host that shades hits itself: each record calls `shade` with `user`.
GLINT_API GlintResult glint_reflections_set_shaded_rays(GlintReflections* reflections, GlintRayScene* scene,
                                                        GlintShadeHits shade, void* user);
GLINT_API GlintResult glint_reflections_set_planar(GlintReflections* reflections, GlintPlanarMirrors* mirrors);
GLINT_API GlintResult glint_reflections_set_probes(GlintReflections* reflections, GlintProbes* probes);
GLINT_API void glint_reflections_restart_accumulation(GlintReflections* reflections);

/// Records the frame's passes and returns the image with reflections (glint::Reflections::record). `result->size` must
/// be set. Fails only for invalid structs or a null object. Other invalid calls record nothing, succeed, return
/// litRadiance and leave a note, as in C++.
GLINT_API GlintResult glint_reflections_record(GlintReflections* reflections, VkCommandBuffer commands,
                                               const GlintView* view, GlintImage* result);
/// Records a transparent layer over `picture`. `result` may be `picture`.
GLINT_API GlintResult glint_reflections_record_layer(GlintReflections* reflections, VkCommandBuffer commands,
                                                     const GlintTransparentLayer* layer, const GlintImage* picture,
                                                     GlintImage* result);
/// Records a debug view of the last recorded frame. `result->size` must be set.
GLINT_API GlintResult glint_reflections_record_view(GlintReflections* reflections, VkCommandBuffer commands,
                                                    const char* name, GlintImage* result);
GLINT_API uint32_t glint_view_name_count(void);
/// Returns the name of a debug view; null for an index out of range.
GLINT_API const char* glint_view_name(uint32_t index);

/// Records an inspection of pixel (x, y) of the last recorded frame.
GLINT_API GlintResult glint_reflections_record_inspection(GlintReflections* reflections, VkCommandBuffer commands,
                                                          uint32_t x, uint32_t y);
/// Reads the last inspected pixel, once the GPU has finished. `inspection->size` must be set.
GLINT_API GlintResult glint_reflections_inspection(GlintReflections* reflections, GlintRayInspection* inspection);
/// Records a check of the host's declarations with the last recorded frame. `plane` may be null.
GLINT_API GlintResult glint_reflections_record_input_check(GlintReflections* reflections, VkCommandBuffer commands,
                                                           const GlintKnownPlane* plane);
/// Evaluates and reads the newest check that the GPU has finished. `check->size` must be set.
GLINT_API GlintResult glint_reflections_input_check(GlintReflections* reflections, GlintInputCheck* check);
/// Text of a finding; valid until the next call of glint_reflections_input_check with this object. Null for an index
/// out of range.
GLINT_API const char* glint_reflections_input_finding(const GlintReflections* reflections, uint32_t index);

// Lists. A read_... function reads the list and returns its length. The texts of its items are valid until it is called
// again for the same object; an index out of range gives null or 0.

/// The images that passes of the last recorded frame wrote, as names for record_view.
GLINT_API uint32_t glint_reflections_read_pass_images(GlintReflections* reflections);
GLINT_API const char* glint_reflections_pass_image(const GlintReflections* reflections, uint32_t index);
/// GPU times of the passes of the newest frame that the GPU has finished. Never waits.
GLINT_API uint32_t glint_reflections_read_pass_times(GlintReflections* reflections);
GLINT_API const char* glint_reflections_pass_name(const GlintReflections* reflections, uint32_t index);
GLINT_API double glint_reflections_pass_milliseconds(const GlintReflections* reflections, uint32_t index);
/// Notes for the host, each given once.
GLINT_API uint32_t glint_reflections_read_notes(GlintReflections* reflections);
GLINT_API const char* glint_reflections_note(const GlintReflections* reflections, uint32_t index);
/// Statistics of the last recorded frame. `statistics->size` must be set.
GLINT_API GlintResult glint_reflections_statistics(GlintReflections* reflections, GlintStatistics* statistics);

#ifdef __cplusplus
}
#endif
