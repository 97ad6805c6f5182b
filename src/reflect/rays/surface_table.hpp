// What stands behind glint::SurfaceTable: the host's lists checked and packed, in buffers that shaders/rays reads.
#pragma once

#include "glint/surface_table.hpp"
#include "gpu/pass.hpp"
#include "gpu/texture_table.hpp"

#include <vector>

namespace glint::reflect {

/// A list that changes as a whole, kept until a command buffer has taken it.
class TableBuffer {
public:
    /// `most`: bytes it may ever have.
    Result<void> create(gpu::Context& context, const char* name, size_t most);
    template <class T>
    void set(const std::vector<T>& items) {
        const auto bytes = std::as_bytes(std::span(items));
        content_.assign(bytes.begin(), bytes.end());
        changed_ = !content_.empty();
    }
    void record(gpu::Frame& frame);
    bool changed() const { return changed_; }
    gpu::Buffer& buffer() { return buffer_; }

private:
    gpu::Buffer buffer_;
    std::vector<std::byte> content_;
    bool changed_ = false;
};

class SurfaceTableState {
public:
    static Result<std::unique_ptr<SurfaceTableState>> create(gpu::Context& context, const SurfaceTableDesc& desc);

    Result<void> setInstances(std::span<const SurfaceInstance> instances);
    Result<void> setLights(std::span<const SurfaceLight> lights);
    Result<void> setMaterials(std::span<const SurfaceMaterial> materials);
    Result<void> setMeshes(std::span<const SurfaceMesh> meshes);
    void record(VkCommandBuffer commands);

    uint32_t instanceCount() const { return instanceCount_; }
    uint32_t lightCount() const { return lightCount_; }
    VkDescriptorSetLayout textureLayout() const { return textures_.layout(); }

    /// Gives the pass all of it, as shaders/rays/surface_table.glsl declares it.
    gpu::Pass& bind(gpu::Pass& pass);

private:
    explicit SurfaceTableState(gpu::Context& context) : context_(context) {}

    gpu::Context& context_;
    gpu::TextureTable textures_;
    uint32_t textureCount_ = 0;
    uint32_t maxInstances_ = 0;
    uint32_t maxLights_ = 0;
    uint32_t maxMaterials_ = 0;
    uint32_t maxMeshes_ = 0;
    uint32_t instanceCount_ = 0;
    uint32_t lightCount_ = 0;
    TableBuffer instances_;
    TableBuffer meshes_;
    TableBuffer materials_;
    TableBuffer lights_;
};

} // namespace glint::reflect
