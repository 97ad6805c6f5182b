#include "gpu/pipeline.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <optional>

namespace glint::gpu {
namespace {

VkDescriptorType descriptorType(BindingKind kind) {
    switch (kind) {
    case BindingKind::SampledImage: return VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    case BindingKind::StorageImage: return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case BindingKind::UniformBuffer: return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingKind::StorageBuffer: return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingKind::AccelerationStructure: return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
    }
    return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

/// A shader module that exists only while the pipeline is created.
class Module {
public:
    Module(Context& context, const EmbeddedShader& shader) : context_(context) {
        VkShaderModuleCreateInfo info = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        info.codeSize = shader.words.size_bytes();
        info.pCode = shader.words.data();
        result_ = context.api().CreateShaderModule(context.device(), &info, context.callbacks(), &module_);
    }
    ~Module() { context_.api().DestroyShaderModule(context_.device(), module_, context_.callbacks()); }
    Module(const Module&) = delete;
    Module& operator=(const Module&) = delete;
    bool ok() const { return result_ == VK_SUCCESS; }
    VkShaderModule handle() const { return module_; }

private:
    Context& context_;
    VkShaderModule module_ = VK_NULL_HANDLE;
    VkResult result_ = VK_SUCCESS;
};

/// The arrays that a VkSpecializationInfo points to.
struct Specialization {
    std::vector<VkSpecializationMapEntry> entries;
    std::vector<uint32_t> values;
    VkSpecializationInfo info = {};

    explicit Specialization(const std::vector<SpecConstant>& constants) {
        for (const SpecConstant& constant : constants) {
            entries.push_back({constant.id, static_cast<uint32_t>(values.size() * sizeof(uint32_t)), sizeof(uint32_t)});
            values.push_back(constant.value);
        }
        info = {static_cast<uint32_t>(entries.size()), entries.data(), values.size() * sizeof(uint32_t), values.data()};
    }
    Specialization(const Specialization&) = delete;
    Specialization& operator=(const Specialization&) = delete;
};

std::string constantsKey(const std::vector<SpecConstant>& constants) {
    std::string key;
    for (const SpecConstant& constant : constants)
        key += formatText(" {}={}", constant.id, constant.value);
    return key;
}

/// Keys that distinguish the pipelines of one context. Handles of table layouts are never used twice: the context keeps
/// the layouts.
std::string keyOf(const EmbeddedShader& shader, const ComputeDesc& desc) {
    return formatText("{} {} {} {}{}", desc.shader, static_cast<const void*>(&shader), desc.pushSize,
                      reinterpret_cast<uint64_t>(desc.tableLayout), constantsKey(desc.constants));
}

std::string keyOf(std::span<const EmbeddedShader* const> shaders, const RasterDesc& desc) {
    std::string key;
    for (const EmbeddedShader* shader : shaders)
        key += formatText("{} ", static_cast<const void*>(shader));
    for (VkFormat format : desc.colorFormats)
        key += formatText("color {} ", static_cast<int>(format));
    return formatText("{}{} {} {} {} {} {} {} {} {} {}{}", key, desc.pushSize, static_cast<int>(desc.depthFormat),
                      desc.samples, static_cast<int>(desc.topology), static_cast<int>(desc.depthCompare),
                      desc.depthWrite, desc.depthBiasConstant, desc.depthBiasSlope, static_cast<int>(desc.blend),
                      reinterpret_cast<uint64_t>(desc.tableLayout), constantsKey(desc.constants));
}

/// The states of a graphics pipeline that follow from its description, and the array that one of them points to. Cull
/// mode, front face and viewport are dynamic.
struct RasterStates {
    VkPipelineVertexInputStateCreateInfo vertexInput = {VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    VkPipelineInputAssemblyStateCreateInfo assembly = {VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    VkPipelineViewportStateCreateInfo viewport = {VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    VkPipelineRasterizationStateCreateInfo raster = {VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    VkPipelineMultisampleStateCreateInfo multisample = {VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    VkPipelineDepthStencilStateCreateInfo depth = {VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
    std::vector<VkPipelineColorBlendAttachmentState> attachments;
    VkPipelineColorBlendStateCreateInfo blend = {VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    VkPipelineDynamicStateCreateInfo dynamic = {VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    VkPipelineRenderingCreateInfo rendering = {VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};

    explicit RasterStates(const RasterDesc& desc) {
        assembly.topology = desc.topology;
        viewport.viewportCount = viewport.scissorCount = 1;
        raster.polygonMode = VK_POLYGON_MODE_FILL;
        raster.lineWidth = 1;
        raster.depthBiasEnable = desc.depthBiasConstant != 0 || desc.depthBiasSlope != 0;
        raster.depthBiasConstantFactor = desc.depthBiasConstant;
        raster.depthBiasSlopeFactor = desc.depthBiasSlope;
        multisample.rasterizationSamples = static_cast<VkSampleCountFlagBits>(desc.samples);
        depth.depthTestEnable = desc.depthFormat != VK_FORMAT_UNDEFINED;
        depth.depthWriteEnable = depth.depthTestEnable && desc.depthWrite;
        depth.depthCompareOp = desc.depthCompare;
        VkPipelineColorBlendAttachmentState attachment = {};
        attachment.colorWriteMask = 0xf;
        if (desc.blend == Blend::Premultiplied) {
            attachment.blendEnable = VK_TRUE;
            attachment.srcColorBlendFactor = attachment.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
            attachment.dstColorBlendFactor = attachment.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
        }
        attachments.assign(desc.colorFormats.size(), attachment);
        blend.attachmentCount = static_cast<uint32_t>(attachments.size());
        blend.pAttachments = attachments.data();
        static constexpr VkDynamicState kDynamic[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR,
                                                      VK_DYNAMIC_STATE_CULL_MODE, VK_DYNAMIC_STATE_FRONT_FACE};
        dynamic.dynamicStateCount = static_cast<uint32_t>(std::size(kDynamic));
        dynamic.pDynamicStates = kDynamic;
        rendering.colorAttachmentCount = static_cast<uint32_t>(desc.colorFormats.size());
        rendering.pColorAttachmentFormats = desc.colorFormats.data();
        rendering.depthAttachmentFormat = desc.depthFormat;
    }
    RasterStates(const RasterStates&) = delete;
    RasterStates& operator=(const RasterStates&) = delete;

    /// Without shaders and layout. Valid as long as this object and the description.
    VkGraphicsPipelineCreateInfo pipelineInfo() const {
        VkGraphicsPipelineCreateInfo info = {VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO, &rendering};
        info.pVertexInputState = &vertexInput;
        info.pInputAssemblyState = &assembly;
        info.pViewportState = &viewport;
        info.pRasterizationState = &raster;
        info.pMultisampleState = &multisample;
        info.pDepthStencilState = &depth;
        info.pColorBlendState = &blend;
        info.pDynamicState = &dynamic;
        return info;
    }
};

} // namespace

Result<void> Pipeline::Made::makeLayout(std::span<const EmbeddedShader* const> shaders, size_t wantedPushSize,
                                        VkDescriptorSetLayout tableLayout) {
    uint32_t shaderPushSize = 0;
    for (const EmbeddedShader* shader : shaders) {
        if (shader->usesRayQuery() && !context->rayQuery())
            return makeError(ErrorCode::Unsupported, "{} traces by ray queries, which are not enabled on {}", name,
                             context->info().name);
        shaderPushSize = std::max(shaderPushSize, shader->pushConstantSize);
        for (const ShaderBinding& binding : shader->bindings) {
            if (binding.set != 0)
                continue; // belongs to the texture table
            const auto same = std::find_if(bindings.begin(), bindings.end(), [&](const ShaderBinding& known) {
                return known.binding == binding.binding || known.name == binding.name;
            });
            if (same == bindings.end())
                bindings.push_back(binding);
            else if (same->binding != binding.binding || same->name != binding.name || same->kind != binding.kind)
                return invalidArgument("{}: '{}' and '{}' meet at binding {}: both stages must agree", name, same->name,
                                       binding.name, binding.binding);
        }
    }
    if (shaderPushSize != wantedPushSize)
        return invalidArgument("{}: the shader's push constants have {} bytes, the program's struct has {}", name,
                               shaderPushSize, wantedPushSize);
    if (bindings.size() > kMaxBindings)
        return invalidArgument("{}: {} bindings, at most {} are allowed", name, bindings.size(), kMaxBindings);

    std::vector<VkDescriptorSetLayoutBinding> layoutBindings;
    for (const ShaderBinding& binding : bindings)
        layoutBindings.push_back({binding.binding, descriptorType(binding.kind), binding.count, stages, nullptr});
    VkDescriptorSetLayoutCreateInfo setInfo = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
    setInfo.bindingCount = static_cast<uint32_t>(layoutBindings.size());
    setInfo.pBindings = layoutBindings.data();
    const Api& api = context->api();
    VkResult result = api.CreateDescriptorSetLayout(context->device(), &setInfo, context->callbacks(), &setLayout);

    const VkPushConstantRange range = {stages, 0, static_cast<uint32_t>(wantedPushSize)};
    const std::array<VkDescriptorSetLayout, 2> sets = {setLayout, tableLayout};
    VkPipelineLayoutCreateInfo info = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    info.setLayoutCount = tableLayout ? 2 : 1;
    info.pSetLayouts = sets.data();
    info.pushConstantRangeCount = wantedPushSize > 0 ? 1 : 0;
    info.pPushConstantRanges = &range;
    if (result == VK_SUCCESS)
        result = api.CreatePipelineLayout(context->device(), &info, context->callbacks(), &layout);
    if (result != VK_SUCCESS)
        return makeError(ErrorCode::OutOfMemory, "{}: its layout cannot be created (VkResult {})", name,
                         static_cast<int>(result));
    pushSize = wantedPushSize;
    context->nameObject(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, reinterpret_cast<uint64_t>(setLayout), name.c_str());
    context->nameObject(VK_OBJECT_TYPE_PIPELINE_LAYOUT, reinterpret_cast<uint64_t>(layout), name.c_str());
    return {};
}

Result<Pipeline> Pipeline::compute(Context& context, const ComputeDesc& desc, Compile when) {
    GLINT_TRY(shader, context.findShader(desc.shader));
    const std::string key = keyOf(*shader, desc);
    const auto known = context.pipelines().find(key);
    Pipeline whole;
    if (known != context.pipelines().end()) {
        whole.made_ = std::static_pointer_cast<Made>(known->second);
    } else {
        whole.made_ = std::make_shared<Made>();
        Made& pipeline = *whole.made_;
        pipeline.context = &context;
        pipeline.name = desc.shader;
        pipeline.bindPoint = VK_PIPELINE_BIND_POINT_COMPUTE;
        pipeline.stages = VK_SHADER_STAGE_COMPUTE_BIT;
        pipeline.computeShader = shader;
        pipeline.constants = desc.constants;
        std::copy(std::begin(shader->localSize), std::end(shader->localSize), pipeline.localSize);
        GLINT_CHECK(pipeline.makeLayout(std::array{shader}, desc.pushSize, desc.tableLayout));
        context.pipelines()[key] = whole.made_;
    }
    if (when == Compile::Now)
        GLINT_CHECK(whole.compile());
    return whole;
}

Result<void> Pipeline::compile() const {
    Context::Compilation& compilation = made_->context->compilation();
    if (compilation.batches == 0)
        return made_->compile();
    const auto isAmong = [this](const std::vector<std::shared_ptr<void>>& asked) {
        return std::ranges::find(asked, made_) != asked.end();
    };
    if (!isAmong(compilation.started) && !made_->pipeline && !isAmong(compilation.waiting)) // read by one thread alone
        compilation.waiting.push_back(made_);
    return {};
}

Result<void> Pipeline::Made::compile() {
    if (pipeline)
        return {};
    const Module module(*context, *computeShader);
    const Specialization specialization(constants);
    VkComputePipelineCreateInfo info = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    info.stage = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                  nullptr,
                  0,
                  VK_SHADER_STAGE_COMPUTE_BIT,
                  module.handle(),
                  "main",
                  &specialization.info};
    info.layout = layout;
    const VkResult result = module.ok()
                                ? context->api().CreateComputePipelines(context->device(), context->pipelineCache(), 1,
                                                                        &info, context->callbacks(), &pipeline)
                                : VK_ERROR_OUT_OF_HOST_MEMORY;
    if (result != VK_SUCCESS)
        return makeError(ErrorCode::Unsupported, "{}: the driver cannot make this pipeline (VkResult {})", name,
                         static_cast<int>(result));
    context->nameObject(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline), name.c_str());
    return {};
}

CompileBatch::CompileBatch(Context& context) : context_(context) {
    ++context_.compilation().batches;
}

CompileBatch::~CompileBatch() {
    started_.threads.clear();
    Context::Compilation& compilation = context_.compilation();
    if (--compilation.batches > 0)
        return;
    compilation.waiting.clear(); // of calls that failed; asked again, they compile then
    compilation.started.clear();
}

bool CompileBatch::isOutermost() const {
    return context_.compilation().batches == 1;
}

void CompileBatch::start() {
    if (!isOutermost())
        return;
    Context::Compilation& compilation = context_.compilation();
    compilation.started = compilation.waiting;
    started_.take(compilation.waiting);
    started_.addThreads(started_.threadsOfUse());
}

Result<void> CompileBatch::finish() {
    if (!isOutermost())
        return {};
    Context::Compilation& compilation = context_.compilation();
    Jobs others;
    others.take(compilation.waiting);
    others.addThreads(std::max<size_t>(others.threadsOfUse(), 1) - 1); // and this one
    others.work();
    others.threads.clear();
    started_.work(); // what no thread has begun
    started_.threads.clear();
    compilation.started.clear();
    GLINT_CHECK(started_.result());
    return others.result();
}

void CompileBatch::Jobs::take(std::vector<std::shared_ptr<void>>& waiting) {
    for (const std::shared_ptr<void>& pipeline : waiting)
        all.push_back({std::static_pointer_cast<Pipeline::Made>(pipeline), {}});
    waiting.clear();
    for (Job& job : all)
        order.push_back(&job);
    std::ranges::stable_sort(order, std::greater(),
                             [](const Job* job) { return job->pipeline->computeShader->words.size(); });
}

void CompileBatch::Jobs::work() {
    for (size_t i = next++; i < order.size(); i = next++)
        order[i]->result = order[i]->pipeline->compile();
}

size_t CompileBatch::Jobs::threadsOfUse() const {
    return std::min<size_t>(all.size(), std::max(std::thread::hardware_concurrency(), 1u));
}

void CompileBatch::Jobs::addThreads(size_t count) {
    for (size_t i = 0; i < count; ++i)
        threads.emplace_back([this] { work(); });
}

Result<void> CompileBatch::Jobs::result() {
    for (Job& job : all)
        GLINT_CHECK(std::move(job.result));
    return {};
}

Result<Pipeline> Pipeline::raster(Context& context, const RasterDesc& desc) {
    std::vector<const EmbeddedShader*> shaders;
    for (std::string_view name : {desc.vertexShader, desc.fragmentShader})
        if (!name.empty()) {
            GLINT_TRY(shader, context.findShader(name));
            shaders.push_back(shader);
        }
    const std::string key = keyOf(shaders, desc);
    if (const auto known = context.pipelines().find(key); known != context.pipelines().end())
        return Pipeline(std::static_pointer_cast<Made>(known->second));
    Pipeline whole;
    whole.made_ = std::make_shared<Made>();
    Made& pipeline = *whole.made_;
    pipeline.context = &context;
    pipeline.name = desc.fragmentShader.empty() ? desc.vertexShader : desc.fragmentShader;
    pipeline.name.resize(pipeline.name.rfind('.')); // the pass is "render/surface", whichever stages it has
    pipeline.bindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    pipeline.stages = VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;
    GLINT_CHECK(pipeline.makeLayout(shaders, desc.pushSize, desc.tableLayout));

    const Specialization specialization(desc.constants);
    std::vector<std::unique_ptr<Module>> modules;
    std::vector<VkPipelineShaderStageCreateInfo> stages;
    for (const EmbeddedShader* shader : shaders) {
        modules.push_back(std::make_unique<Module>(context, *shader));
        stages.push_back({VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO, nullptr, 0,
                          stages.empty() ? VK_SHADER_STAGE_VERTEX_BIT : VK_SHADER_STAGE_FRAGMENT_BIT,
                          modules.back()->handle(), "main", &specialization.info});
    }

    const RasterStates states(desc);
    VkGraphicsPipelineCreateInfo info = states.pipelineInfo();
    info.stageCount = static_cast<uint32_t>(stages.size());
    info.pStages = stages.data();
    info.layout = pipeline.layout;
    if (const VkResult result = context.api().CreateGraphicsPipelines(context.device(), context.pipelineCache(), 1,
                                                                      &info, context.callbacks(), &pipeline.pipeline);
        result != VK_SUCCESS)
        return makeError(ErrorCode::Unsupported, "{}: the driver cannot make this pipeline (VkResult {})",
                         pipeline.name, static_cast<int>(result));
    context.nameObject(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline.pipeline), pipeline.name.c_str());
    context.pipelines()[key] = whole.made_;
    return whole;
}

Pipeline::Made::~Made() {
    if (!context)
        return;
    const Api& api = context->api();
    api.DestroyPipeline(context->device(), pipeline, context->callbacks());
    api.DestroyPipelineLayout(context->device(), layout, context->callbacks());
    api.DestroyDescriptorSetLayout(context->device(), setLayout, context->callbacks());
}

const Pipeline::Made& Pipeline::it() const {
    static const Made none;
    return made_ ? *made_ : none;
}

} // namespace glint::gpu
