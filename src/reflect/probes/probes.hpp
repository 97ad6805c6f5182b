// What stands behind glint::Probes: the host's volumes checked and packed, its cubes filtered, and the grid over them.
#pragma once

#include "glint/probes.hpp"
#include "gpu/cube_prefilter.hpp"
#include "gpu/texture_table.hpp"
#include "reflect/rays/surface_table.hpp"
#include "shared/probes.h"

#include <vector>

namespace glint::reflect {

class ProbesState {
public:
    static Result<std::unique_ptr<ProbesState>> create(gpu::Context& context, const ProbesDesc& desc);

    Result<void> setVolumes(std::span<const Probe> probes);
    void refilter(uint32_t probe);
    void record(VkCommandBuffer commands);

    uint32_t count() const { return static_cast<uint32_t>(cubes_.size()); }
    HostImage cube(uint32_t probe) const;
    uint32_t cubeMips(uint32_t probe) const { return cubes_[probe].mips; }
    VkDescriptorSetLayout cubesLayout() const { return table_.layout(); }
    /// Without the flags.
    const shared::ProbesConstants& constants() const { return constants_; }
    /// Gives the pass all of it, as shaders/probes/reflect.comp declares it.
    gpu::Pass& bind(gpu::Pass& pass);

private:
    explicit ProbesState(gpu::Context& context) : context_(context) {}
    Result<void> addCube(const Probe& probe, uint32_t faceSize);
    void filter(gpu::Frame& frame, uint32_t probe);

    struct Cube {
        HostImage host;
        uint32_t hostMips = 1;
        gpu::Image filtered; ///< absent where the host's own is looked up
        uint32_t mips = 1;   ///< of what is looked up
        bool stale = false;  ///< to be filtered
    };

    gpu::Context& context_;
    gpu::CubePrefilter prefilter_;
    std::vector<gpu::Image> sources_; ///< cubes with all mips that others are filtered from, one a size
    std::vector<Cube> cubes_;
    gpu::TextureTable table_;
    shared::ProbesConstants constants_ = {};     ///< of what the buffers hold
    shared::ProbesConstants nextConstants_ = {}; ///< of what the next record brings there
    TableBuffer records_;
    TableBuffer cells_;
    TableBuffer lists_;
};

} // namespace glint::reflect
