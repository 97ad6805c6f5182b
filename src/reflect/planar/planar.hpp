// Implements glint::PlanarMirrors: checks the host's mirrors and keeps Glint's copies of their mirrored views.
#pragma once

#include "glint/planar.hpp"
#include "gpu/pass.hpp"
#include "gpu/texture_table.hpp"
#include "shared/frame_constants.h"
#include "shared/planar.h"

#include <vector>

namespace glint::reflect {

class PlanarState : gpu::KeepsContext {
public:
    static Result<std::unique_ptr<PlanarState>> create(gpu::Context& context, const PlanarMirrorsDesc& desc);

    Result<void> setMirrors(std::span<const PlanarMirror> mirrors);
    Result<void> record(VkCommandBuffer commands, uint32_t mirror, const PlanarPicture& picture);
    void skip(uint32_t mirror);

    uint32_t count() const { return static_cast<uint32_t>(slots_.size()); }
    VkDescriptorSetLayout picturesLayout() const { return table_.layout(); }
    /// Returns the mirrors with a mirrored view, in the view space of `constants`; at most kMaxPlanarRecords.
    std::span<const shared::PlanarRecord> records(const shared::FrameConstants& constants,
                                                  std::span<shared::PlanarRecord> room) const;
    VkDescriptorSet pictures() const { return table_.set(); }

private:
    struct Slot {
        PlanarMirror mirror;
        gpu::Image radiance; ///< RGBA16F with mips: radiance and its weight (shaders/planar/take_main.glsl)
        gpu::Image viewZ;    ///< R32F
        bool shown = false;  ///< the slot holds a mirrored view
    };

    explicit PlanarState(gpu::Context& context) : KeepsContext(context), context_(context) {}
    Result<void> makeSlot(const PlanarMirrorsDesc& desc, const PlanarMirror& mirror);
    void take(gpu::Frame& frame, Slot& slot, gpu::Image& radiance, gpu::Image& depth,
              const shared::FrameConstants& constants);

    gpu::Context& context_;
    Conventions conventions_;
    gpu::Pipeline take_;
    gpu::Pipeline takeSamples_;
    gpu::Pipeline shrink_;
    gpu::Buffer frameConstants_; ///< of the mirrored view that is being copied
    std::vector<Slot> slots_;
    gpu::TextureTable table_; ///< radiance and viewZ of each slot
};

} // namespace glint::reflect
