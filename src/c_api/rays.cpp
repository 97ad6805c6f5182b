#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

namespace {

Result<std::vector<RayMesh>> readMeshes(const GlintRayMesh* first, uint32_t count) {
    GLINT_TRY(meshes, readArray<RayMesh>(first, count));
    const HostArray array(first, count);
    for (uint32_t i = 0; i < count; ++i) {
        GLINT_TRY(whole, wholeStruct<RayMesh>(array[i]));
        if ((whole.indexCount > 0 && !whole.indices) || (whole.vertexCount > 0 && !whole.positions))
            return invalidArgument("GlintRayMesh {}: {} is null, but its count is not 0", i,
                                   whole.indices || whole.indexCount == 0 ? "positions" : "indices");
        meshes[i].indices = {whole.indices, whole.indexCount};
    }
    return meshes;
}

/// The list is the host's: it lives as long as the call.
Result<HostAccelerationStructure> readHost(const GlintHostAccelerationStructure* host) {
    GLINT_TRY(whole, wholeStruct<HostAccelerationStructure>(host));
    GLINT_TRY(cpp, readStruct<HostAccelerationStructure>(host));
    if (whole.triangleCounts)
        cpp.triangleCounts = {whole.triangleCounts, whole.instanceCount};
    return cpp;
}

} // namespace

void glint_ray_mesh_init(GlintRayMesh* mesh, uint32_t size) {
    initStruct<RayMesh>(mesh, size);
}

void glint_ray_instance_init(GlintRayInstance* instance, uint32_t size) {
    initStruct<RayInstance>(instance, size);
}

void glint_ray_scene_desc_init(GlintRaySceneDesc* desc, uint32_t size) {
    initStruct<RaySceneDesc>(desc, size);
}

void glint_host_acceleration_structure_init(GlintHostAccelerationStructure* host, uint32_t size) {
    initStruct<HostAccelerationStructure>(host, size);
}

void glint_ray_scene_times_init(GlintRaySceneTimes* times, uint32_t size) {
    initStruct<RaySceneTimes>(times, size);
}

GlintResult glint_ray_scene_create(GlintContext* context, const GlintRaySceneDesc* desc, GlintRayScene** scene) {
    GLINT_C_REQUIRE(scene);
    *scene = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(whole, wholeStruct<RaySceneDesc>(desc));
    GLINT_C_TRY(cpp, readStruct<RaySceneDesc>(desc));
    GLINT_C_TRY(meshes, readMeshes(whole.meshes, whole.meshCount));
    GLINT_C_TRY(instances, readArray<RayInstance>(whole.instances, whole.instanceCount));
    cpp.meshes = meshes;
    cpp.instances = instances;
    GLINT_C_TRY(made, RayScene::create(context->context, cpp));
    *scene = new GlintRayScene{std::move(made)};
    return GLINT_SUCCESS;
}

GlintResult glint_ray_scene_adopt(GlintContext* context, const GlintHostAccelerationStructure* host,
                                  GlintRayScene** scene) {
    GLINT_C_REQUIRE(scene);
    *scene = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(cpp, readHost(host));
    GLINT_C_TRY(made, RayScene::adopt(context->context, cpp));
    *scene = new GlintRayScene{std::move(made)};
    return GLINT_SUCCESS;
}

void glint_ray_scene_destroy(GlintRayScene* scene) {
    delete scene;
}

GlintRayBackend glint_ray_scene_backend(const GlintRayScene* scene) {
    return scene ? static_cast<GlintRayBackend>(scene->scene.backend()) : GLINT_RAY_BACKEND_AUTO;
}

GlintResult glint_ray_scene_set_acceleration_structure(GlintRayScene* scene,
                                                       const GlintHostAccelerationStructure* host) {
    GLINT_C_REQUIRE(scene);
    GLINT_C_TRY(cpp, readHost(host));
    return outcome(scene->scene.setAccelerationStructure(cpp));
}

GlintResult glint_ray_scene_set_instances(GlintRayScene* scene, const GlintRayInstance* instances, uint32_t count) {
    GLINT_C_REQUIRE(scene);
    GLINT_C_TRY(list, readArray<RayInstance>(instances, count));
    return outcome(scene->scene.setInstances(list));
}

GlintResult glint_ray_scene_update_instances(GlintRayScene* scene, uint32_t first, const GlintRayInstance* instances,
                                             uint32_t count) {
    GLINT_C_REQUIRE(scene);
    GLINT_C_TRY(list, readArray<RayInstance>(instances, count));
    return outcome(scene->scene.updateInstances(first, list));
}

GlintResult glint_ray_scene_deform(GlintRayScene* scene, uint32_t mesh, const float* positions, uint32_t vertexCount,
                                   uint32_t vertexStride) {
    GLINT_C_REQUIRE(scene);
    GLINT_C_REQUIRE(positions);
    return outcome(scene->scene.deform(mesh, positions, vertexCount, vertexStride));
}

void glint_ray_scene_record(GlintRayScene* scene, VkCommandBuffer commands) {
    if (scene && commands)
        scene->scene.record(commands);
}

void glint_ray_scene_release_staging(GlintRayScene* scene) {
    if (scene)
        scene->scene.releaseStaging();
}

GlintResult glint_ray_scene_times(GlintRayScene* scene, GlintRaySceneTimes* times) {
    GLINT_C_REQUIRE(scene);
    GLINT_C_CHECK(checkResultStruct<RaySceneTimes>(times));
    writeStruct(toC(scene->scene.times()), times, times->size);
    return GLINT_SUCCESS;
}
