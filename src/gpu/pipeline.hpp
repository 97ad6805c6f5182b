// Pipelines, made from an embedded shader's own reflection: layouts are derived, never written by hand.
#pragma once

#include "gpu/context.hpp"

#include <string>
#include <vector>

namespace glint::gpu {

/// Most bindings that one pass may have; descriptors are pushed from a fixed array of this size.
constexpr uint32_t kMaxBindings = 24;

struct SpecConstant {
    uint32_t id = 0;
    uint32_t value = 0; ///< bits of an int, uint, bool or float
};

struct ComputeDesc {
    std::string_view shader; ///< its path under shaders/: "trace/linear"
    size_t pushSize = 0;     ///< sizeof the struct that will be pushed; checked against the shader's block
    std::vector<SpecConstant> constants;
    VkDescriptorSetLayout tableLayout = VK_NULL_HANDLE; ///< set 1, if the shader uses a TextureTable
};

enum class Blend : uint8_t { None, Premultiplied };

struct RasterDesc {
    std::string_view vertexShader;   ///< "render/surface.vert"
    std::string_view fragmentShader; ///< empty: depth only
    size_t pushSize = 0;
    std::vector<SpecConstant> constants; ///< for both stages
    std::vector<VkFormat> colorFormats;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    uint32_t samples = 1; ///< a pixel, of every attachment
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL; ///< reversed depth
    bool depthWrite = true;
    float depthBiasConstant = 0;
    float depthBiasSlope = 0;
    Blend blend = Blend::None;                          ///< of every colour attachment
    VkDescriptorSetLayout tableLayout = VK_NULL_HANDLE; ///< set 1, if the shaders use a TextureTable
};

/// Cull mode and front face are dynamic (Draws::cull). Movable; destroys its Vulkan objects.
class Pipeline {
public:
    Pipeline() = default;
    static Result<Pipeline> compute(Context& context, const ComputeDesc& desc);
    static Result<Pipeline> raster(Context& context, const RasterDesc& desc);
    ~Pipeline() { destroy(); }
    Pipeline(Pipeline&& other) noexcept { swap(other); }
    Pipeline& operator=(Pipeline&& other) noexcept { return swap(other), *this; }

    explicit operator bool() const { return pipeline_ != VK_NULL_HANDLE; }
    const std::string& name() const { return name_; } ///< the shader's path; also the pass's label and timer
    VkPipeline handle() const { return pipeline_; }
    VkPipelineLayout layout() const { return layout_; }
    VkPipelineBindPoint bindPoint() const { return bindPoint_; }
    VkShaderStageFlags stages() const { return stages_; }
    size_t pushSize() const { return pushSize_; }
    const uint32_t* localSize() const { return localSize_; }
    std::span<const ShaderBinding> bindings() const { return bindings_; } ///< set 0 only, both stages merged

private:
    Result<void> makeLayout(std::span<const EmbeddedShader* const> shaders, size_t pushSize,
                            VkDescriptorSetLayout tableLayout);
    void destroy();
    void swap(Pipeline& other);

    Context* context_ = nullptr;
    std::string name_;
    std::vector<ShaderBinding> bindings_;
    VkDescriptorSetLayout setLayout_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
    VkPipelineBindPoint bindPoint_ = VK_PIPELINE_BIND_POINT_COMPUTE;
    VkShaderStageFlags stages_ = 0;
    size_t pushSize_ = 0;
    uint32_t localSize_[3] = {1, 1, 1};
};

} // namespace glint::gpu
