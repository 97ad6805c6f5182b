#include "rays/bvh_scene.hpp"

#include "gpu/device_address.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace glint::rays {
namespace {

/// A refitted top level is rebuilt once its cost has grown by this factor.
constexpr double kWornOut = 1.3;

/// An empty buffer cannot be created; the spare element is never read.
template <class T>
size_t bytesFor(size_t count) {
    return std::max<size_t>(count, 1) * sizeof(T);
}

shared::BvhTriangle packTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, uint32_t number) {
    const glm::dvec3 normal = glm::cross(glm::dvec3(b) - glm::dvec3(a), glm::dvec3(c) - glm::dvec3(a));
    const glm::dvec3 size = glm::abs(normal);
    const int axis = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
    const glm::vec3 scaled(normal / normal[axis]); // 0 / 0 if the triangle has no area
    return {{glm::vec4(a, std::bit_cast<float>(number | static_cast<uint32_t>(axis) << shared::kBvhNormalAxisShift)),
             glm::vec4(b, scaled[axis == 0 ? 1 : 0]), glm::vec4(c, scaled[axis == 2 ? 1 : 2])}};
}

} // namespace

std::vector<Bounds> BvhScene::boxesOf(const Part& part) {
    std::vector<Bounds> boxes;
    boxes.reserve(part.kept.size());
    for (const uint32_t triangle : part.kept)
        boxes.push_back(boundsOf(part.mesh, part.mesh.triangles[triangle]));
    return boxes;
}

void BvhScene::writeNodes(const Part& part, shared::BvhNode* out) const {
    for (shared::BvhNode node : part.tree.nodes) {
        node.words[1].x += part.firstNode;
        node.words[1].y += part.firstTriangle;
        *out++ = node;
    }
}

void BvhScene::writeTriangles(const Part& part, shared::BvhTriangle* out) const {
    for (const uint32_t primitive : part.tree.order) {
        const uint32_t number = part.kept[primitive];
        const glm::uvec3& triangle = part.mesh.triangles[number];
        *out++ = packTriangle(part.mesh.positions[triangle.x], part.mesh.positions[triangle.y],
                              part.mesh.positions[triangle.z], number);
    }
}

bool BvhScene::fits(const gpu::Context& context, size_t triangles, size_t instances) {
    return bytesFor<shared::BvhTriangle>(triangles) <= context.maxBufferSize() &&
           bytesFor<shared::BvhInstance>(instances) <= context.maxBufferSize();
}

Result<BvhScene> BvhScene::create(gpu::Context& context, std::vector<Mesh> meshes, uint32_t maxInstances) {
    BvhScene scene;
    scene.maxInstances_ = maxInstances;
    size_t triangleCount = 0;
    for (Mesh& mesh : meshes) {
        Part part;
        part.mesh = std::move(mesh);
        for (uint32_t i = 0; i < part.mesh.triangles.size(); ++i)
            if (!isLeftOut(part.mesh.triangles[i]))
                part.kept.push_back(i);
        part.firstTriangle = static_cast<uint32_t>(triangleCount);
        triangleCount += part.kept.size();
        scene.parts_.push_back(std::move(part));
    }
    const auto checkSize = [&](size_t bytes) -> Result<void> {
        if (bytes > context.maxBufferSize())
            return makeError(ErrorCode::Unsupported,
                             "{} triangles for rays take a buffer of {} bytes; one of {} holds at most {}",
                             triangleCount, bytes, context.info().name, context.maxBufferSize());
        return {};
    };
    const size_t triangleBytes = bytesFor<shared::BvhTriangle>(triangleCount);
    const size_t instanceBytes = bytesFor<shared::BvhInstance>(maxInstances);
    GLINT_CHECK(checkSize(triangleBytes)); // checked before the trees are built, which takes the time
    GLINT_CHECK(checkSize(instanceBytes));

    // The top level comes first. A node has at least two children, so there are no more nodes than instances.
    size_t nodeCount = std::max(maxInstances, 1u);
    for (Part& part : scene.parts_) {
        part.tree = buildWideBvh(boxesOf(part), shared::kBvhPrimitivesPerSlot, shared::kBvhMeshLevels);
        part.bounds = part.tree.bounds.front();
        part.firstNode = static_cast<uint32_t>(nodeCount);
        nodeCount += part.tree.nodes.size();
    }
    const size_t nodeBytes = bytesFor<shared::BvhNode>(nodeCount);
    GLINT_CHECK(checkSize(nodeBytes));

    const auto make = [&](gpu::Buffer& out, const char* name, size_t size, VkBufferUsageFlags usage,
                          gpu::BufferHome home) -> Result<void> {
        GLINT_TRY(buffer, gpu::Buffer::create(context, {name, size, usage, home}));
        out = std::move(buffer);
        return {};
    };
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                          VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT;
    constexpr VkBufferUsageFlags kStaging = VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    GLINT_CHECK(make(scene.nodes_, "rays/nodes", nodeBytes, kUsage, gpu::BufferHome::Device));
    GLINT_CHECK(make(scene.triangles_, "rays/triangles", triangleBytes, kUsage, gpu::BufferHome::Device));
    GLINT_CHECK(make(scene.instanceRecords_, "rays/instances", instanceBytes, kUsage, gpu::BufferHome::Device));
    GLINT_CHECK(make(scene.nodeStaging_, "rays/nodes/staging", nodeBytes, kStaging, gpu::BufferHome::Upload));
    GLINT_CHECK(
        make(scene.triangleStaging_, "rays/triangles/staging", triangleBytes, kStaging, gpu::BufferHome::Upload));
    GLINT_CHECK(make(scene.addresses_, "rays/addresses", sizeof(shared::BvhAddresses),
                     VK_BUFFER_USAGE_STORAGE_BUFFER_BIT, gpu::BufferHome::Upload));
    *static_cast<shared::BvhAddresses*>(scene.addresses_.mapped()) = {
        gpu::addressWords(scene.nodes_.address()), gpu::addressWords(scene.triangles_.address()),
        gpu::addressWords(scene.instanceRecords_.address())};
    auto* nodes = static_cast<shared::BvhNode*>(scene.nodeStaging_.mapped());
    auto* triangles = static_cast<shared::BvhTriangle*>(scene.triangleStaging_.mapped());
    for (Part& part : scene.parts_) {
        scene.writeNodes(part, nodes + part.firstNode);
        scene.writeTriangles(part, triangles + part.firstTriangle);
        if (!part.mesh.deforms) {
            part.mesh = {};
            part.tree = {};
            part.kept = {};
        }
    }
    return scene;
}

void BvhScene::setInstances(std::span<const RayInstance> instances) {
    instances_.assign(instances.begin(), instances.end());
    fitTop();
}

void BvhScene::updateInstances(uint32_t first, std::span<const RayInstance> instances) {
    if (instances.empty())
        return;
    std::ranges::copy(instances, instances_.begin() + first);
    // The cost of the tree takes as long as a whole refit, so it is not computed for each small change.
    constexpr size_t kPart = 4;
    moved_ += instances.size();
    if (moved_ * kPart > topInstances_.size() || !replace(first, static_cast<uint32_t>(instances.size())))
        fitTop();
}

std::optional<BvhScene::Placed> BvhScene::place(uint32_t index) const {
    const RayInstance& instance = instances_[index];
    const Part& part = parts_[instance.mesh];
    const std::optional<Placement> placement = placementOf(instance);
    if (part.bounds.empty() || !placement)
        return std::nullopt;
    shared::BvhInstance record = {};
    const glm::mat3 rows(glm::transpose(placement->worldToLocal));
    const glm::vec3 originWS(placement->localToWorld[3]);
    for (int row = 0; row < 3; ++row)
        record.worldToLocal[row] = glm::vec4(rows[row], originWS[row]);
    record.rootNode = part.firstNode;
    record.number = index;
    record.maskAndFlags = instance.mask | (instance.opaque ? shared::kBvhInstanceOpaque : 0) |
                          (instance.doubleSided ? shared::kBvhInstanceDoubleSided : 0);
    return Placed{boundsWS(*placement, part.bounds), record};
}

bool BvhScene::replace(uint32_t first, uint32_t count) {
    const auto begin = std::ranges::lower_bound(topInstances_, first);
    const auto end = std::ranges::lower_bound(topInstances_, first + count);
    auto present = begin;
    std::vector<Placed> placed;
    for (uint32_t i = first; i < first + count; ++i) {
        const bool before = present != end && *present == i;
        const std::optional<Placed> now = place(i);
        if (before != now.has_value())
            return false;
        present += before ? 1 : 0;
        if (now)
            placed.push_back(*now);
    }
    if (!topLinks_)
        topLinks_ = linksOf(top_);
    if (topUpload_.isDone()) {
        dirtyNodes_.clear();
        dirtyRecords_.clear();
    }
    std::vector<uint32_t> primitives(placed.size());
    std::iota(primitives.begin(), primitives.end(), static_cast<uint32_t>(begin - topInstances_.begin()));
    for (size_t i = 0; i < placed.size(); ++i) {
        const uint32_t where = topLinks_->places[primitives[i]];
        topBoxes_[primitives[i]] = placed[i].boundsWS;
        topRecords_[where] = placed[i].record;
        dirtyRecords_.add(where * sizeof(shared::BvhInstance), sizeof(shared::BvhInstance));
    }
    for (const uint32_t node : refit(top_, *topLinks_, topBoxes_, primitives))
        dirtyNodes_.add(node * sizeof(shared::BvhNode), sizeof(shared::BvhNode));
    topUpload_.ask();
    return true;
}

void BvhScene::fitMesh(uint32_t index) {
    Part& part = parts_[index];
    refit(part.tree, boxesOf(part));
    part.bounds = part.tree.bounds.front();
    if (deformedUpload_.isDone())
        for (Part& other : parts_)
            other.deformed = false;
    part.deformed = true;
    deformedUpload_.ask();
    fitTop();
}

void BvhScene::fitTop() {
    std::vector<uint32_t> present;
    std::vector<shared::BvhInstance> records;
    topBoxes_.clear();
    for (uint32_t i = 0; i < instances_.size(); ++i)
        if (const std::optional<Placed> placed = place(i)) {
            present.push_back(i);
            topBoxes_.push_back(placed->boundsWS);
            records.push_back(placed->record);
        }
    const bool sameInstances = present == topInstances_ && !top_.nodes.empty();
    if (sameInstances)
        refit(top_, topBoxes_);
    if (!sameInstances || sahCost(top_, topBoxes_) > kWornOut * topCost_) {
        top_ = buildWideBvh(topBoxes_, 1, shared::kBvhTopLevels);
        topCost_ = sahCost(top_, topBoxes_);
        topInstances_ = std::move(present);
        topLinks_.reset();
    }
    moved_ = 0;
    topRecords_.clear();
    for (const uint32_t primitive : top_.order)
        topRecords_.push_back(records[primitive]);
    dirtyNodes_.clear();
    dirtyRecords_.clear();
    dirtyNodes_.add(0, top_.nodes.size() * sizeof(shared::BvhNode));
    dirtyRecords_.add(0, topRecords_.size() * sizeof(shared::BvhInstance));
    topUpload_.ask();
}

bool BvhScene::pending(const gpu::Progress& progress) {
    const bool upload = upload_.isNeeded(progress);
    const bool deformed = deformedUpload_.isNeeded(progress);
    return topUpload_.isNeeded(progress) || upload || deformed;
}

void BvhScene::record(gpu::Frame& frame, const gpu::Progress& progress) {
    // In this order: the GPU may finish recordings meanwhile, and an upload that is repeated must be followed by the
    // changes made after it.
    const bool deformed = deformedUpload_.isNeeded(progress);
    const bool top = topUpload_.isNeeded(progress);
    if (upload_.isNeeded(progress)) {
        frame.scope("rays/build", [&] {
            frame.upload(nodeStaging_, nodes_);
            frame.upload(triangleStaging_, triangles_);
        });
        upload_.recorded(progress);
    }
    frame.scope("rays/update", [&] {
        if (deformed) {
            std::vector<shared::BvhNode> nodes;
            std::vector<shared::BvhTriangle> triangles;
            for (Part& part : parts_) {
                if (!part.deformed || part.kept.empty())
                    continue;
                nodes.resize(part.tree.nodes.size());
                triangles.resize(part.tree.order.size());
                writeNodes(part, nodes.data());
                writeTriangles(part, triangles.data());
                frame.update(nodes_, nodes.data(), nodes.size() * sizeof(shared::BvhNode),
                             part.firstNode * sizeof(shared::BvhNode));
                frame.update(triangles_, triangles.data(), triangles.size() * sizeof(shared::BvhTriangle),
                             part.firstTriangle * sizeof(shared::BvhTriangle));
            }
            deformedUpload_.recorded(progress);
        }
        if (top) {
            frame.update(nodes_, std::as_bytes(std::span(top_.nodes)), dirtyNodes_.merged());
            frame.update(instanceRecords_, std::as_bytes(std::span(topRecords_)), dirtyRecords_.merged());
            topUpload_.recorded(progress);
        }
    });
}

void BvhScene::releaseStaging(const gpu::Progress& progress) {
    if (upload_.isNeeded(progress))
        return;
    nodeStaging_ = {};
    triangleStaging_ = {};
}

void BvhScene::bind(gpu::Pass& pass) {
    pass.read("bvh", addresses_).readByAddress(nodes_).readByAddress(triangles_).readByAddress(instanceRecords_);
}

} // namespace glint::rays
