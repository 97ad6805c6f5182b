// A host's own shading of hits (glint/ray_hits.hpp).
#pragma once

#include "glint/ray_hits.hpp"
#include "gpu/context.hpp"
#include "support/must.hpp"

#include <array>

namespace glint::test {

/// The host's own shading, as in an engine: a pipeline made without Glint's help, from
/// tests/gpu/shaders/shade_hits.comp.
class HostShading {
public:
    explicit HostShading(gpu::Context& context) : context_(context) {
        const gpu::Api& api = context.api();
        const gpu::EmbeddedShader& shader = *must(context.findShader("shade_hits"));
        VkShaderModuleCreateInfo moduleInfo = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
        moduleInfo.codeSize = shader.words.size_bytes();
        moduleInfo.pCode = shader.words.data();
        api.CreateShaderModule(context.device(), &moduleInfo, nullptr, &module_);
        const std::array<VkDescriptorSetLayoutBinding, 3> bindings = {
            {{0, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
             {1, VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr},
             {2, VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr}}};
        VkDescriptorSetLayoutCreateInfo setInfo = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
        setInfo.flags = VK_DESCRIPTOR_SET_LAYOUT_CREATE_PUSH_DESCRIPTOR_BIT_KHR;
        setInfo.bindingCount = 3;
        setInfo.pBindings = bindings.data();
        api.CreateDescriptorSetLayout(context.device(), &setInfo, nullptr, &set_);
        VkPipelineLayoutCreateInfo layoutInfo = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
        layoutInfo.setLayoutCount = 1;
        layoutInfo.pSetLayouts = &set_;
        api.CreatePipelineLayout(context.device(), &layoutInfo, nullptr, &layout_);
        VkComputePipelineCreateInfo info = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
        info.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
        info.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
        info.stage.module = module_;
        info.stage.pName = "main";
        info.layout = layout_;
        api.CreateComputePipelines(context.device(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_);
    }
    ~HostShading() {
        const gpu::Api& api = context_.api();
        api.DestroyPipeline(context_.device(), pipeline_, nullptr);
        api.DestroyPipelineLayout(context_.device(), layout_, nullptr);
        api.DestroyDescriptorSetLayout(context_.device(), set_, nullptr);
        api.DestroyShaderModule(context_.device(), module_, nullptr);
    }
    HostShading(const HostShading&) = delete;
    HostShading& operator=(const HostShading&) = delete;

    void record(VkCommandBuffer commands, const RayHits& hits) const {
        const gpu::Api& api = context_.api();
        const VkDescriptorBufferInfo list = {hits.arguments, 0, 16};
        const VkDescriptorBufferInfo items = {hits.hits, 0, hits.hitsSize};
        const VkDescriptorImageInfo answer = {VK_NULL_HANDLE, hits.answer.view, hits.answer.layout};
        std::array<VkWriteDescriptorSet, 3> writes;
        for (uint32_t i = 0; i < 3; ++i) {
            writes[i] = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
            writes[i].dstBinding = i;
            writes[i].descriptorCount = 1;
            writes[i].descriptorType = i < 2 ? VK_DESCRIPTOR_TYPE_STORAGE_BUFFER : VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
        }
        writes[0].pBufferInfo = &list;
        writes[1].pBufferInfo = &items;
        writes[2].pImageInfo = &answer;
        api.CmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
        api.CmdPushDescriptorSetKHR(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 3, writes.data());
        api.CmdDispatchIndirect(commands, hits.arguments, 0);
    }

private:
    gpu::Context& context_;
    VkShaderModule module_ = VK_NULL_HANDLE;
    VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
    VkPipelineLayout layout_ = VK_NULL_HANDLE;
    VkPipeline pipeline_ = VK_NULL_HANDLE;
};

} // namespace glint::test
