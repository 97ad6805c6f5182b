#include "reflect/prepare/depth_pyramid.hpp"

#include "reflect/trace/technique.hpp"

#include <algorithm>
#include <bit>

namespace glint::reflect {

Result<std::unique_ptr<DepthPyramid>> DepthPyramid::create(StageContext& stages) {
    std::unique_ptr<DepthPyramid> pyramid(new DepthPyramid(stages));
    GLINT_TRY(pass, gpu::Pipeline::compute(stages.gpu, program(), gpu::Compile::Later));
    pyramid->pass_ = std::move(pass);
    return pyramid;
}

gpu::ComputeDesc DepthPyramid::program() {
    return {"prepare/pyramid", sizeof(shared::PyramidConstants), {}};
}

bool DepthPyramid::wanted(const PlanInputs& inputs) {
    const Settings& settings = inputs.settings;
    const bool marches = settings.screen.enabled || inputs.inspection; // inspections record the marcher's pass
    return (marches && techniqueFor(settings.screen.march).usesPyramid) ||
           (inputs.transparentLayers && settings.refraction.enabled);
}

Result<void> DepthPyramid::make() {
    GLINT_CHECK(pass_.compile());
    if (cells_)
        return {};
    const uint32_t width = stages_.width();
    const uint32_t height = stages_.height();
    const auto half = [](uint32_t size, uint32_t times) { return (size + (1u << times) - 1) >> times; };
    const size_t tiles = size_t{half(width, shared::kPyramidTileLevel)} * half(height, shared::kPyramidTileLevel);
    const size_t above = tiles; // at least the cells of the next level
    GLINT_TRY(tileCells,
              gpu::Buffer::create(stages_.gpu, {"glint/pyramidTiles", 16 + 16 * (tiles + above),
                                                VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                                gpu::BufferHome::Device}));
    tiles_ = std::move(tileCells);
    // Level 1, beside it a column of all others: lib/pyramid.glsl.
    return makeImage(stages_.gpu, cells_,
                     {"glint/pyramid", VK_FORMAT_R32G32B32A32_UINT, half(width, 1) + half(width, 2),
                      half(height, 1) + levelsOf({width, height}), kCleared});
}

/// Index of the coarsest level.
uint32_t DepthPyramid::levelsOf(glm::uvec2 size) {
    return std::clamp(static_cast<uint32_t>(std::bit_width(std::max(size.x, size.y) - 1)), 1u,
                      shared::kMaxPyramidLevels - 1);
}

void DepthPyramid::clear(gpu::Frame& frame) {
    if (frame.rehearsing() || !cells_ || !blank_.isNeeded(stages_.progress))
        return;
    frame.clear(cells_, {});
    frame.fill(tiles_, 0);
    blank_.recorded(stages_.progress);
}

void DepthPyramid::record(gpu::Frame& frame, const FrameInputs& inputs, const Prepared& prepared, Rays* rays) {
    const Settings& settings = stages_.settings();
    shared::TraceConstants trace = traceConstants(settings, prepared.backFacesKnown && settings.screen.enabled);
    trace.flags |= prepared.backFacesInPlace ? shared::kTraceBackInPlace : 0;
    shared::PyramidConstants constants = {trace.thickness, trace.thicknessRelative, trace.flags, pyramid().levels};
    if (!rays)
        constants.thicknessRelative = std::max(constants.thicknessRelative, settings.refraction.hizDepthBias);
    gpu::Pass pass = frame.pass(pass_);
    pass.read("frame", inputs.constants)
        .read("viewZ", prepared.viewZ)
        .read("backViewZ", prepared.backViewZ, kTexels)
        .read("surface", prepared.otherLobe) // of a coat rather than of bumpy paint: its corners are none
        .write("pyramid", cells_)
        .readWrite("tiles", tiles_)
        .push(constants);
    constexpr uint32_t kPixelsAThread = 4;
    if (rays)
        pass.dispatchIndirect(rays->list, offsetof(shared::RayListHeader, pyramidGroups));
    else
        pass.dispatch((stages_.extent.x + kPixelsAThread - 1) / kPixelsAThread,
                      (stages_.extent.y + kPixelsAThread - 1) / kPixelsAThread);
}

} // namespace glint::reflect
