// Implements glint::SurfaceTable: checks and packs the host's lists into buffers that shaders/rays reads.
#pragma once

#include "glint/surface_table.hpp"
#include "gpu/dirty_ranges.hpp"
#include "gpu/pass.hpp"
#include "gpu/progress.hpp"
#include "gpu/texture_table.hpp"
#include "shared/surface_table.h"

#include <algorithm>
#include <vector>

namespace glint::reflect {

/// A list that is replaced as a whole or in part, and kept until the GPU has a copy.
class TableBuffer {
public:
    /// `most`: maximum size in bytes.
    Result<void> create(gpu::Context& context, const char* name, size_t most);
    template <class T>
    void set(const std::vector<T>& items) {
        const auto bytes = std::as_bytes(std::span(items));
        content_.assign(bytes.begin(), bytes.end());
        dirty_.clear();
        dirty_.add(0, content_.size());
        upload_ = gpu::Standing(!content_.empty());
    }
    /// Replaces the items from `first` on, which must exist.
    template <class T>
    void replace(size_t first, const std::vector<T>& items) {
        if (items.empty())
            return;
        if (upload_.isDone())
            dirty_.clear();
        const auto bytes = std::as_bytes(std::span(items));
        std::ranges::copy(bytes, content_.begin() + static_cast<std::ptrdiff_t>(first * sizeof(T)));
        dirty_.add(first * sizeof(T), bytes.size());
        upload_.ask();
    }
    bool pending(const gpu::Progress& progress) { return upload_.isNeeded(progress); }
    void record(gpu::Frame& frame, const gpu::Progress& progress);
    gpu::Buffer& buffer() { return buffer_; }

private:
    gpu::Buffer buffer_;
    std::vector<std::byte> content_;
    gpu::DirtyRanges dirty_; ///< of content_, since the GPU had all of it
    gpu::Standing upload_ = gpu::Standing(false);
};

class SurfaceTableState : gpu::KeepsContext {
public:
    static Result<std::unique_ptr<SurfaceTableState>> create(gpu::Context& context, const SurfaceTableDesc& desc);

    Result<void> setInstances(std::span<const SurfaceInstance> instances);
    Result<void> setLights(std::span<const SurfaceLight> lights);
    Result<void> setMaterials(std::span<const SurfaceMaterial> materials);
    Result<void> setMeshes(std::span<const SurfaceMesh> meshes);
    Result<void> updateInstances(uint32_t first, std::span<const SurfaceInstance> instances);
    Result<void> updateMaterials(uint32_t first, std::span<const SurfaceMaterial> materials);
    void record(VkCommandBuffer commands);

    uint32_t instanceCount() const { return instanceCount_; }
    uint32_t maxInstances() const { return maxInstances_; }
    uint32_t lightCount() const { return lightCount_; }
    std::vector<uint32_t> transparentInstances() const; ///< indices of the instances that transmit light
    /// True if the instance's surface emits light. False for surfaces that transmit light, which rays pass through.
    bool emits(uint32_t instance) const {
        const uint32_t material = instanceMaterials_[instance];
        return material < emits_.size() && emits_[material];
    }
    VkDescriptorSetLayout textureLayout() const { return textures_.layout(); }

    gpu::Buffer& instances() { return instances_.buffer(); } ///< shared::SurfaceInstanceRecord

    /// Binds the table without lights, as shaders/rays/surface_table.glsl declares it.
    gpu::Pass& bindAppearance(gpu::Pass& pass);
    /// Binds the whole table, for rays/hit_lighting.glsl too.
    gpu::Pass& bind(gpu::Pass& pass);

private:
    Result<std::vector<shared::SurfaceInstanceRecord>> pack(std::span<const SurfaceInstance> instances,
                                                            uint32_t first) const;
    explicit SurfaceTableState(gpu::Context& context) : KeepsContext(context), context_(context) {}

    gpu::Context& context_;
    gpu::Progress progress_;
    gpu::TextureTable textures_;
    uint32_t textureCount_ = 0;
    uint32_t maxInstances_ = 0;
    uint32_t maxLights_ = 0;
    uint32_t maxMaterials_ = 0;
    uint32_t maxMeshes_ = 0;
    uint32_t instanceCount_ = 0;
    uint32_t lightCount_ = 0;
    std::vector<bool> isTransparent_; ///< by material
    std::vector<bool> emits_;         ///< by material
    std::vector<uint32_t> instanceMaterials_;
    TableBuffer instances_;
    TableBuffer meshes_;
    TableBuffer materials_;
    TableBuffer lights_;
};

} // namespace glint::reflect
