// Pipelines. Their layouts are derived from the reflection of the embedded shader, never written by hand.
#pragma once

#include "gpu/context.hpp"

#include <atomic>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace glint::gpu {

/// Maximum bindings per pass; descriptors are pushed from a fixed array of this size.
constexpr uint32_t kMaxBindings = 32;
/// Maximum images in all arrays of a pass together.
constexpr uint32_t kMaxArrayImages = 16;

struct SpecConstant {
    uint32_t id = 0;
    uint32_t value = 0; ///< the bits of an int, uint, bool or float
};

struct ComputeDesc {
    std::string_view shader; ///< path under shaders/: "trace/linear"
    size_t pushSize = 0;     ///< sizeof the pushed struct; checked against the shader's block
    std::vector<SpecConstant> constants;
    VkDescriptorSetLayout tableLayout = VK_NULL_HANDLE; ///< set 1, if the shader uses a TextureTable
};

/// When the driver compiles a compute pipeline. Its layout is known in both cases, so its passes can be rehearsed.
enum class Compile : uint8_t {
    Now,
    Later, ///< with Pipeline::compile, by the settings or inputs that first need it
};

enum class Blend : uint8_t { None, Premultiplied };

struct RasterDesc {
    std::string_view vertexShader;   ///< "render/surface.vert"
    std::string_view fragmentShader; ///< empty: depth only
    size_t pushSize = 0;
    std::vector<SpecConstant> constants; ///< for both stages
    std::vector<VkFormat> colorFormats;
    VkFormat depthFormat = VK_FORMAT_UNDEFINED;
    uint32_t samples = 1; ///< samples per pixel, of every attachment
    VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkCompareOp depthCompare = VK_COMPARE_OP_GREATER_OR_EQUAL; ///< reversed depth
    bool depthWrite = true;
    float depthBiasConstant = 0;
    float depthBiasSlope = 0;
    Blend blend = Blend::None;                          ///< for every colour attachment
    VkDescriptorSetLayout tableLayout = VK_NULL_HANDLE; ///< set 1, if the shaders use a TextureTable
};

/// Cull mode and front face are dynamic (Draws::cull). Copies are the same pipeline. Pipelines of the same description
/// are made once per context and kept as long as it: nothing is compiled a second time for another size, another scene
/// or another Reflections.
class Pipeline {
public:
    Pipeline() = default;
    static Result<Pipeline> compute(Context& context, const ComputeDesc& desc, Compile when = Compile::Now);
    static Result<Pipeline> raster(Context& context, const RasterDesc& desc);

    /// Compiles a pipeline that was to be compiled later; a second call has no effect. Takes up to 2 s on the software
    /// driver. While a CompileBatch lives, its finish() compiles. Errors: Unsupported.
    Result<void> compile() const;

    explicit operator bool() const { return made_ != nullptr; }
    const std::string& name() const { return it().name; } ///< the shader's path; also the pass's label and timer
    VkPipeline handle() const { return it().pipeline; }
    VkPipelineLayout layout() const { return it().layout; }
    VkPipelineBindPoint bindPoint() const { return it().bindPoint; }
    VkShaderStageFlags stages() const { return it().stages; }
    size_t pushSize() const { return it().pushSize; }
    const uint32_t* localSize() const { return it().localSize; }
    std::span<const ShaderBinding> bindings() const { return it().bindings; } ///< set 0 only, both stages merged

private:
    friend class CompileBatch;
    /// The Vulkan objects and the description of a pipeline.
    struct Made {
        Context* context = nullptr;
        std::string name;
        std::vector<ShaderBinding> bindings;
        VkDescriptorSetLayout setLayout = VK_NULL_HANDLE;
        VkPipelineLayout layout = VK_NULL_HANDLE;
        VkPipeline pipeline = VK_NULL_HANDLE;
        VkPipelineBindPoint bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
        VkShaderStageFlags stages = 0;
        size_t pushSize = 0;
        uint32_t localSize[3] = {1, 1, 1};
        const EmbeddedShader* computeShader = nullptr;
        std::vector<SpecConstant> constants;

        Made() = default;
        ~Made();
        Made(const Made&) = delete;
        Made& operator=(const Made&) = delete;
        Result<void> makeLayout(std::span<const EmbeddedShader* const> shaders, size_t wantedPushSize,
                                VkDescriptorSetLayout tableLayout);
        Result<void> compile();
    };
    explicit Pipeline(std::shared_ptr<Made> made) : made_(std::move(made)) {}
    const Made& it() const;

    std::shared_ptr<Made> made_; ///< null: not created
};

/// Compiles on all cores what its context's calls ask to compile while it lives. Among nested batches the outermost
/// compiles. Pipelines must not be used before finish().
///
///     CompileBatch batch(context);
///     ...          // ask for the pipelines that take longest
///     batch.start();
///     ...          // ask for the others, make images
///     batch.finish();
class CompileBatch {
public:
    explicit CompileBatch(Context& context);
    ~CompileBatch();
    CompileBatch(const CompileBatch&) = delete;
    CompileBatch& operator=(const CompileBatch&) = delete;

    /// Begins to compile what has been asked for, in threads of its own, while the caller goes on. Call it at most
    /// once.
    void start();
    /// Call it once. Errors: those of Pipeline::compile, the first in the order of the calls.
    Result<void> finish();

private:
    struct Job {
        std::shared_ptr<Pipeline::Made> pipeline;
        Result<void> result;
    };
    /// What several threads compile, the longest first, so that none is left alone at the end.
    struct Jobs {
        std::vector<Job> all; ///< in the order of the calls
        std::vector<Job*> order;
        std::atomic<size_t> next = 0;
        std::vector<std::jthread> threads; ///< join before the others go

        void take(std::vector<std::shared_ptr<void>>& waiting);
        void work();
        void addThreads(size_t count);
        size_t threadsOfUse() const; ///< no more than cores
        Result<void> result();
    };
    bool isOutermost() const;

    Context& context_;
    Jobs started_;
};

} // namespace glint::gpu
