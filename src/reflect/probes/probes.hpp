// Implements glint::Probes: checks and packs the host's volumes, filters its cubes, and builds the grid over them.
#pragma once

#include "glint/probes.hpp"
#include "gpu/cube_prefilter.hpp"
#include "gpu/texture_table.hpp"
#include "reflect/rays/surface_table.hpp"
#include "shared/probes.h"

#include <vector>

namespace glint::reflect {

class ProbesState : gpu::KeepsContext {
public:
    static Result<std::unique_ptr<ProbesState>> create(gpu::Context& context, const ProbesDesc& desc);

    Result<void> setVolumes(std::span<const Probe> probes);
    void refilter(uint32_t probe);
    void record(VkCommandBuffer commands);

    uint32_t count() const { return static_cast<uint32_t>(cubes_.size()); }
    HostImage cube(uint32_t probe) const;
    uint32_t cubeMips(uint32_t probe) const { return cubes_[probe].mips; }
    VkDescriptorSetLayout cubesLayout() const { return table_.layout(); }
    /// Binds the volumes, as shaders/probes/probe_lists.glsl declares them.
    gpu::Pass& bindLists(gpu::Pass& pass);
    /// Binds the volumes and the cubes, as shaders/probes/probe_cubes.glsl declares them.
    gpu::Pass& bind(gpu::Pass& pass) { return bindLists(pass).table(table_.set()); }

private:
    explicit ProbesState(gpu::Context& context) : KeepsContext(context), context_(context) {}
    Result<void> addCube(const Probe& probe, uint32_t faceSize);
    void filter(gpu::Frame& frame, uint32_t probe);

    struct Cube {
        HostImage host;
        uint32_t hostMips = 1;
        gpu::Image filtered; ///< absent if the host's own cube is sampled
        uint32_t mips = 1;   ///< of the cube that is sampled
        gpu::Standing filtering = gpu::Standing(false);
    };

    gpu::Context& context_;
    gpu::Progress progress_;
    gpu::CubePrefilter prefilter_;
    std::vector<gpu::Image> sources_; ///< cubes with all mips, which the others are filtered from; one per size
    std::vector<Cube> cubes_;
    gpu::TextureTable table_;
    TableBuffer records_;
    TableBuffer cells_; ///< shared::ProbeGridHeader, then the cells
    TableBuffer lists_;
};

} // namespace glint::reflect
