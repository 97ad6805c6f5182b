#include "reflect/trace/ray_list.hpp"

namespace glint::reflect {
namespace {

glm::uvec2 tilesOf(uint32_t width, uint32_t height) {
    return (glm::uvec2(width, height) + shared::kRayTileWidth - 1u) / shared::kRayTileWidth;
}

uint32_t blocksOf(const glm::uvec2& tiles) {
    return (tiles.x * tiles.y + shared::kTilesPerBlock - 1) / shared::kTilesPerBlock;
}

} // namespace

Result<RayLister> RayLister::create(gpu::Context& context, uint32_t width, uint32_t height) {
    const glm::uvec2 tiles = tilesOf(width, height);
    RayLister lister;
    GLINT_TRY(list, gpu::Pipeline::compute(context, {"trace/list", sizeof(shared::RayListConstants), {}}));
    GLINT_TRY(masks,
              gpu::Buffer::create(context, {"glint/rayTiles", size_t{tiles.x} * tiles.y * sizeof(glm::uvec2),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    GLINT_TRY(counts,
              gpu::Buffer::create(context, {"glint/rayBlocks", blocksOf(tiles) * sizeof(uint32_t),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    lister.list_ = std::move(list);
    lister.tiles_ = std::move(masks);
    lister.blocks_ = std::move(counts);
    return lister;
}

Result<Rays> RayLister::makeList(gpu::Context& context, const char* name, uint32_t width, uint32_t height) {
    GLINT_TRY(list,
              gpu::Buffer::create(context, {name, sizeof(shared::RayListHeader) + size_t{4} * width * height,
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT,
                                            gpu::BufferHome::Device}));
    return Rays{std::move(list)};
}

void RayLister::begin(gpu::Frame& frame) {
    frame.fill(tiles_, 0);
    frame.fill(blocks_, 0);
}

void RayLister::list(gpu::Frame& frame, Rays& rays, uint32_t width, uint32_t height, const IfAny& ifAny) {
    const glm::uvec2 tiles = tilesOf(width, height);
    const shared::RayListConstants constants = {tiles, ifAny.pyramidGroups, ifAny.backFaceGroups,
                                                ifAny.always ? 1u : 0u};
    frame.pass(list_)
        .read("rayTiles", tiles_)
        .read("rayBlocks", blocks_)
        .write("rays", rays.list)
        .push(constants)
        .dispatch(blocksOf(tiles) * list_.localSize()[0]);
}

} // namespace glint::reflect
