#include "rays/scene.hpp"

#include "base/assert.hpp"
#include "base/elapsed.hpp"
#include "rays/instance.hpp"

#include <algorithm>
#include <numeric>

namespace glint::rays {
namespace {

static_assert(uint64_t{kMostInstances} <= uint64_t{1} << 3 * shared::kBvhTopLevels);

Bounds boundsOf(const std::vector<glm::vec3>& points) {
    Bounds bounds;
    for (const glm::vec3& point : points)
        bounds.add(point);
    return bounds;
}

} // namespace

std::vector<gpu::SpecConstant> Scene::constants() const {
    constexpr uint32_t kCustomIndices = 2;
    if (adopted_ && adopted_->numbering() == InstanceNumbering::CustomIndex)
        return {{kCustomIndices, VK_TRUE}};
    return {};
}

uint32_t Scene::trianglesSeen(uint32_t instance, uint32_t mask) const {
    if (adopted_)
        return adopted_->triangleCount(instance);
    const RayInstance& placed = instances_[instance];
    return (placed.mask & mask) != 0 ? meshTriangles_[placed.mesh] : 0;
}

Bounds Scene::instanceBounds(uint32_t instance) const {
    if (adopted_)
        return adopted_->transparentBounds();
    const RayInstance& placed = instances_[instance];
    const Bounds& local = meshBounds_[placed.mesh];
    const std::optional<Placement> placement = placementOf(placed);
    return placement && !local.empty() ? boundsWS(*placement, local) : Bounds();
}

Result<void> Scene::checkMeshes(std::span<const RayInstance> instances, size_t first) const {
    for (size_t i = 0; i < instances.size(); ++i)
        if (instances[i].mesh >= deformable_.size())
            return invalidArgument("ray instance {} is of mesh {}, the scene has {}", first + i, instances[i].mesh,
                                   deformable_.size());
    return {};
}

Result<void> Scene::check(std::span<const RayInstance> instances) const {
    if (instances.size() > maxInstances_)
        return invalidArgument("{} ray instances, the scene was made for at most {}", instances.size(), maxInstances_);
    return checkMeshes(instances, 0);
}

RayBackend Scene::fasterBackend() const {
    if (!context_.rayQuery())
        return RayBackend::Bvh;
    // A driver that runs on the CPU traverses its structures in software, slower than Bvh (lab/notes/rays.md).
    const size_t triangles = std::reduce(meshTriangles_.begin(), meshTriangles_.end(), size_t(0));
    const bool bvh = context_.info().software && BvhScene::fits(context_, triangles, maxInstances_);
    return bvh ? RayBackend::Bvh : RayBackend::Query;
}

Result<std::unique_ptr<Scene>> Scene::create(gpu::Context& context, const RaySceneDesc& desc) {
    const auto start = std::chrono::steady_clock::now();
    if (desc.backend == RayBackend::Query && !context.rayQuery())
        return makeError(ErrorCode::Unsupported, "ray queries are not enabled on {}; RayBackend::Bvh runs anywhere",
                         context.info().name);
    std::unique_ptr<Scene> scene(new Scene(context));
    scene->maxInstances_ = std::max(desc.maxInstances, static_cast<uint32_t>(desc.instances.size()));
    if (scene->maxInstances_ > kMostInstances)
        return invalidArgument("room for {} ray instances, at most {} can be had", scene->maxInstances_,
                               kMostInstances);
    std::vector<Mesh> meshes;
    for (uint32_t i = 0; i < desc.meshes.size(); ++i) {
        GLINT_TRY(mesh, readMesh(desc.meshes[i], i));
        scene->deformable_.push_back(mesh.deforms ? static_cast<uint32_t>(mesh.positions.size()) : 0);
        scene->meshTriangles_.push_back(static_cast<uint32_t>(mesh.triangles.size()));
        scene->meshBounds_.push_back(boundsOf(mesh.positions));
        meshes.push_back(std::move(mesh));
    }
    GLINT_CHECK(scene->check(desc.instances));
    scene->backend_ = desc.backend == RayBackend::Auto ? scene->fasterBackend() : desc.backend;
    if (scene->backend_ == RayBackend::Query) {
        GLINT_TRY(backend, QueryScene::create(context, std::move(meshes), scene->maxInstances_));
        scene->scene_ = std::move(backend);
    } else {
        GLINT_TRY(backend, BvhScene::create(context, std::move(meshes), scene->maxInstances_));
        scene->scene_ = std::make_unique<BvhScene>(std::move(backend));
    }
    GLINT_TRY(timers, gpu::Timers::create(context));
    scene->timers_ = std::move(timers);
    GLINT_TRY(progress, gpu::Progress::create(context, "rays/progress"));
    scene->progress_ = std::move(progress);
    GLINT_CHECK(scene->setInstances(desc.instances));
    scene->times_.cpuBuildMs = millisecondsSince(start);
    scene->times_.cpuUpdateMs = 0;
    return scene;
}

Result<std::unique_ptr<Scene>> Scene::adopt(gpu::Context& context, const HostAccelerationStructure& host) {
    if (!context.rayQuery())
        return makeError(ErrorCode::Unsupported,
                         "ray queries are not enabled on {}: the host's acceleration structure cannot be traced",
                         context.info().name);
    std::unique_ptr<Scene> scene(new Scene(context));
    GLINT_TRY(adopted, AdoptedScene::create(host));
    scene->adopted_ = std::move(adopted);
    scene->backend_ = RayBackend::Query;
    return scene;
}

Result<void> Scene::setAccelerationStructure(const HostAccelerationStructure& host) {
    if (!adopted_)
        return invalidArgument("the ray scene was made of triangles; RayScene::adopt takes an acceleration structure");
    return adopted_->replace(host);
}

/// Glint has no lists of a scene that is the host's acceleration structure.
Result<void> Scene::checkOwn(const char* call) const {
    if (adopted_)
        return invalidArgument("{}: the ray scene is the host's acceleration structure, which the host changes itself",
                               call);
    return {};
}

Result<void> Scene::setInstances(std::span<const RayInstance> instances) {
    GLINT_CHECK(checkOwn("setInstances"));
    const auto start = std::chrono::steady_clock::now();
    GLINT_CHECK(check(instances));
    instances_.assign(instances.begin(), instances.end());
    std::visit([&](auto& backend) { backend->setInstances(instances); }, scene_);
    times_.cpuUpdateMs = millisecondsSince(start);
    return {};
}

Result<void> Scene::updateInstances(uint32_t first, std::span<const RayInstance> instances) {
    GLINT_CHECK(checkOwn("updateInstances"));
    const auto start = std::chrono::steady_clock::now();
    if (uint64_t{first} + instances.size() > instances_.size())
        return invalidArgument("ray instances {} to {} are updated, the scene has {}", first,
                               uint64_t{first} + instances.size(), instances_.size());
    GLINT_CHECK(checkMeshes(instances, first));
    std::ranges::copy(instances, instances_.begin() + first);
    std::visit([&](auto& backend) { backend->updateInstances(first, instances); }, scene_);
    times_.cpuUpdateMs = millisecondsSince(start);
    return {};
}

Result<void> Scene::deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride) {
    GLINT_CHECK(checkOwn("deform"));
    const auto start = std::chrono::steady_clock::now();
    if (mesh >= deformable_.size() || deformable_[mesh] == 0)
        return invalidArgument("ray mesh {} was not made with `deforms`, or has no vertices", mesh);
    if (vertexCount != deformable_[mesh] || !positions || vertexStride < 3 * sizeof(float))
        return invalidArgument("ray mesh {}: {} positions {} bytes apart, it has {} vertices", mesh, vertexCount,
                               vertexStride, deformable_[mesh]);
    std::visit(
        [&](auto& backend) {
            moveVertices(backend->mesh(mesh), positions, vertexStride);
            meshBounds_[mesh] = boundsOf(backend->mesh(mesh).positions);
            backend->fitMesh(mesh);
        },
        scene_);
    times_.cpuUpdateMs = millisecondsSince(start);
    return {};
}

void Scene::record(VkCommandBuffer commands) {
    if (adopted_)
        return;
    std::visit(
        [&](auto& backend) {
            if (!backend->pending(progress_))
                return;
            progress_.begin();
            gpu::Frame frame(context_, commands, timers_.get());
            backend->record(frame, progress_);
            progress_.end(frame);
            recorded_ = true;
        },
        scene_);
}

void Scene::releaseStaging() {
    if (adopted_)
        return;
    std::visit([&](auto& backend) { backend->releaseStaging(progress_); }, scene_);
}

RaySceneTimes Scene::times() {
    if (backend_ == RayBackend::Query && !adopted_)
        for (const gpu::PassTime& time : timers_->latest())
            (time.name == "rays/build" ? times_.gpuBuildMs : times_.gpuUpdateMs) = time.milliseconds;
    return times_;
}

gpu::Pass& Scene::bind(gpu::Pass& pass) {
    if (adopted_) {
        adopted_->bind(pass);
        return pass;
    }
    GLINT_ASSERT(recorded_ || pass.rehearsing(), "a ray scene is traced before it was recorded");
    std::visit([&](auto& backend) { backend->bind(pass); }, scene_);
    return pass;
}

} // namespace glint::rays

// ---------------------------------------------------------------- the public class

namespace glint {

RayScene::RayScene(std::unique_ptr<rays::Scene> scene) : scene_(std::move(scene)) {}
RayScene::~RayScene() = default;
RayScene::RayScene(RayScene&&) noexcept = default;
RayScene& RayScene::operator=(RayScene&&) noexcept = default;

Result<RayScene> RayScene::create(Context& context, const RaySceneDesc& desc) {
    GLINT_TRY(scene, rays::Scene::create(context.gpu(), desc));
    return RayScene(std::move(scene));
}

Result<RayScene> RayScene::adopt(Context& context, const HostAccelerationStructure& host) {
    GLINT_TRY(scene, rays::Scene::adopt(context.gpu(), host));
    return RayScene(std::move(scene));
}

Result<void> RayScene::setAccelerationStructure(const HostAccelerationStructure& host) {
    return scene_->setAccelerationStructure(host);
}

RayBackend RayScene::backend() const {
    return scene_->backend();
}

Result<void> RayScene::setInstances(std::span<const RayInstance> instances) {
    return scene_->setInstances(instances);
}

Result<void> RayScene::updateInstances(uint32_t first, std::span<const RayInstance> instances) {
    return scene_->updateInstances(first, instances);
}

Result<void> RayScene::deform(uint32_t mesh, const float* positions, uint32_t vertexCount, uint32_t vertexStride) {
    return scene_->deform(mesh, positions, vertexCount, vertexStride);
}

void RayScene::record(VkCommandBuffer commands) {
    scene_->record(commands);
}

void RayScene::releaseStaging() {
    scene_->releaseStaging();
}

void RayScene::bind(gpu::Pass& pass) {
    scene_->bind(pass);
}

RaySceneTimes RayScene::times() {
    return scene_->times();
}

} // namespace glint
