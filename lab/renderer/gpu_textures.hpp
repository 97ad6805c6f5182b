// The textures of a scene on the GPU, and the bindless table index of each material slot.
#pragma once

#include "gpu/texture_table.hpp"
#include "lab/scene/scene.hpp"

#include <map>
#include <tuple>

namespace glint::render {

/// How a slot's values are encoded. An image used for both kinds is uploaded twice.
enum class TextureKind : uint8_t {
    Color, ///< sRGB, decoded by the sampler before filtering
    Data,  ///< as stored
};

class GpuTextures {
public:
    /// Uploads the images used by materials, with mips, and builds the table. Errors: OutOfMemory, DeviceLost;
    /// InvalidInput for an image larger than the device supports.
    static Result<GpuTextures> create(gpu::Context& context, const scene::Scene& scene);

    /// True if every texture of the scene's materials that can be read is in the table.
    bool holds(const scene::Scene& scene) const;
    /// Returns the index into the table; shared::kNoTexture if the slot is empty or its image could not be read.
    uint32_t index(const scene::TextureSlot& slot, TextureKind kind) const;
    const gpu::TextureTable& table() const { return table_; }

private:
    Result<void> addSlot(gpu::Context& context, const scene::Scene& scene, const scene::TextureSlot& slot,
                         TextureKind kind);

    std::map<std::pair<int, TextureKind>, gpu::Image> images_; ///< by scene image
    std::map<std::pair<int, TextureKind>, uint32_t> indices_;  ///< by scene texture
    std::vector<gpu::TextureTable::Entry> entries_;
    gpu::TextureTable table_;
};

/// Calls `visit(slot, kind)` for every texture slot of a material.
template <class Visit>
void visitTextureSlots(const scene::Material& m, Visit visit) {
    visit(m.baseColorTexture, TextureKind::Color);
    visit(m.metallicRoughnessTexture, TextureKind::Data);
    visit(m.normalTexture, TextureKind::Data);
    visit(m.occlusionTexture, TextureKind::Data);
    visit(m.emissiveTexture, TextureKind::Color);
    visit(m.specularTexture, TextureKind::Data);
    visit(m.specularColorTexture, TextureKind::Color);
    visit(m.transmissionTexture, TextureKind::Data);
    visit(m.thicknessTexture, TextureKind::Data);
    visit(m.clearcoatTexture, TextureKind::Data);
    visit(m.clearcoatRoughnessTexture, TextureKind::Data);
    visit(m.clearcoatNormalTexture, TextureKind::Data);
    visit(m.specularGlossinessTexture, TextureKind::Color);
}

} // namespace glint::render
