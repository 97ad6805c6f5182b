#include "reflect/rays/light_table.hpp"

#include <algorithm>
#include <array>

namespace glint::reflect {
namespace {

constexpr size_t kHeaderWords = sizeof(shared::EmittersHeader) / sizeof(uint32_t);
constexpr VkBufferUsageFlags kWrittenStorage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;

/// Depth of the groups of so many leaves.
uint32_t depthOf(uint32_t leaves) {
    uint32_t depth = 0;
    while (4u << 2 * depth < leaves)
        ++depth;
    return depth;
}

} // namespace

Result<std::unique_ptr<LightTable>> LightTable::create(StageContext& stages) {
    std::unique_ptr<LightTable> table(new LightTable(stages));
    GLINT_TRY(environmentLeaves, gpu::Pipeline::compute(stages.gpu, {"rays/environment_leaves", 0, {}}));
    GLINT_TRY(sums,
              gpu::Pipeline::compute(stages.gpu, {"rays/light_tree_sums", sizeof(shared::LightTreeConstants), {}}));
    GLINT_TRY(tree, gpu::Buffer::create(stages.gpu, {"glint/lightTree", shared::kLightTreeGroups * sizeof(glm::vec4),
                                                     kWrittenStorage, gpu::BufferHome::Device}));
    table->environmentLeaves_ = std::move(environmentLeaves);
    table->sums_ = std::move(sums);
    table->tree_ = std::move(tree);
    return table;
}

Result<void> LightTable::setScene(SurfaceTableState& surfaces) {
    const size_t words = kHeaderWords + size_t{3} * surfaces.maxInstances();
    GLINT_TRY(leaves, gpu::Pipeline::compute(stages_.gpu, {"rays/emitter_leaves", 0, {}, surfaces.textureLayout()}));
    if (!emitters_ || emitters_.size() < words * sizeof(uint32_t)) {
        GLINT_TRY(emitters, gpu::Buffer::create(stages_.gpu, {"glint/emitters", words * sizeof(uint32_t),
                                                              kWrittenStorage, gpu::BufferHome::Device}));
        stages_.retired.keep(std::move(emitters_));
        emitters_ = std::move(emitters);
    }
    stages_.retired.keep(std::move(emitterLeaves_));
    emitterLeaves_ = std::move(leaves);
    list_.reserve(words);
    surfaces_ = &surfaces;
    return {};
}

shared::EmittersHeader LightTable::listEmitters(const rays::Scene& scene) {
    const auto mask = static_cast<uint32_t>(stages_.settings().rays.cullMask);
    const uint32_t instances = std::min(scene.instanceCount(), surfaces_->instanceCount()); // a rehearsal's may differ
    shared::EmittersHeader header = {0, 0, 0, instances};
    list_.assign(kHeaderWords + instances, shared::kNoEmitter);
    for (uint32_t i = 0; i < instances; ++i) {
        const uint32_t triangles = scene.trianglesSeen(i, mask);
        if (!surfaces_->emits(i) || triangles == 0 || triangles > shared::kEmitterLeaves - header.leaves)
            continue;
        list_[kHeaderWords + i] = header.leaves;
        list_.push_back(header.leaves);
        list_.push_back(i);
        header.leaves += triangles;
        ++header.emitters;
    }
    header.depth = depthOf(header.leaves);
    const std::array<uint32_t, kHeaderWords> words = {header.leaves, header.depth, header.emitters, header.instances};
    std::ranges::copy(words, list_.begin());
    return header;
}

void LightTable::addUp(gpu::Frame& frame, const shared::LightTreeConstants& tree) {
    frame.pass(sums_).readWrite("lightTree", tree_).push(tree).dispatch(shared::kLightTreeThreads);
}

void LightTable::record(gpu::Frame& frame, const FrameInputs& inputs, const rays::Scene& scene) {
    gpu::Image& environment = inputs.host.environment ? inputs.host.environment : inputs.standIns.blackCube;
    if (frame.rehearsing() || environment_.isNeeded(stages_.progress)) {
        frame.pass(environmentLeaves_)
            .read("environment", environment)
            .write("lightTree", tree_)
            .dispatch(shared::kEnvironmentLeaves);
        addUp(frame, {0, shared::kEnvironmentDepth, shared::kEnvironmentLeaves, 1});
        if (!frame.rehearsing())
            environment_.recorded(stages_.progress);
    }
    const shared::EmittersHeader header = listEmitters(scene);
    frame.update(emitters_, list_.data(), list_.size() * sizeof(uint32_t));
    if (header.leaves > 0 || frame.rehearsing()) {
        gpu::Pass leaves = frame.pass(emitterLeaves_);
        leaves.write("lightTree", tree_).read("emitters", emitters_);
        surfaces_->bindAppearance(leaves).dispatch((header.leaves + 3) / 4 * 4);
        addUp(frame, {shared::kEnvironmentGroups, header.depth, header.leaves, 0});
    }
}

} // namespace glint::reflect
