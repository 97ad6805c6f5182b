#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

void glint_surface_material_init(GlintSurfaceMaterial* material, uint32_t size) {
    initStruct<SurfaceMaterial>(material, size);
}

void glint_surface_mesh_init(GlintSurfaceMesh* mesh, uint32_t size) {
    initStruct<SurfaceMesh>(mesh, size);
}

void glint_surface_instance_init(GlintSurfaceInstance* instance, uint32_t size) {
    initStruct<SurfaceInstance>(instance, size);
}

void glint_surface_light_init(GlintSurfaceLight* light, uint32_t size) {
    initStruct<SurfaceLight>(light, size);
}

void glint_surface_table_desc_init(GlintSurfaceTableDesc* desc, uint32_t size) {
    initStruct<SurfaceTableDesc>(desc, size);
}

GlintResult glint_surface_table_create(GlintContext* context, const GlintSurfaceTableDesc* desc,
                                       GlintSurfaceTable** table) {
    GLINT_C_REQUIRE(table);
    *table = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(whole, wholeStruct<SurfaceTableDesc>(desc));
    GLINT_C_TRY(cpp, readStruct<SurfaceTableDesc>(desc));
    if (whole.textureCount > 0 && !whole.textures)
        return fail(invalidArgument("{} GlintSurfaceTexture, but the array is null", whole.textureCount));
    std::vector<SurfaceTexture> textures;
    for (uint32_t i = 0; i < whole.textureCount; ++i)
        textures.push_back({whole.textures[i].view, whole.textures[i].sampler});
    GLINT_C_TRY(materials, readArray<SurfaceMaterial>(whole.materials, whole.materialCount));
    GLINT_C_TRY(meshes, readArray<SurfaceMesh>(whole.meshes, whole.meshCount));
    GLINT_C_TRY(instances, readArray<SurfaceInstance>(whole.instances, whole.instanceCount));
    GLINT_C_TRY(lights, readArray<SurfaceLight>(whole.lights, whole.lightCount));
    cpp.textures = textures;
    cpp.materials = materials;
    cpp.meshes = meshes;
    cpp.instances = instances;
    cpp.lights = lights;
    GLINT_C_TRY(made, SurfaceTable::create(context->context, cpp));
    *table = new GlintSurfaceTable{std::move(made)};
    return GLINT_SUCCESS;
}

void glint_surface_table_destroy(GlintSurfaceTable* table) {
    delete table;
}

GlintResult glint_surface_table_set_instances(GlintSurfaceTable* table, const GlintSurfaceInstance* instances,
                                              uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceInstance>(instances, count));
    return outcome(table->table.setInstances(list));
}

GlintResult glint_surface_table_update_instances(GlintSurfaceTable* table, uint32_t first,
                                                 const GlintSurfaceInstance* instances, uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceInstance>(instances, count));
    return outcome(table->table.updateInstances(first, list));
}

GlintResult glint_surface_table_update_materials(GlintSurfaceTable* table, uint32_t first,
                                                 const GlintSurfaceMaterial* materials, uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceMaterial>(materials, count));
    return outcome(table->table.updateMaterials(first, list));
}

GlintResult glint_surface_table_set_lights(GlintSurfaceTable* table, const GlintSurfaceLight* lights, uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceLight>(lights, count));
    return outcome(table->table.setLights(list));
}

GlintResult glint_surface_table_set_materials(GlintSurfaceTable* table, const GlintSurfaceMaterial* materials,
                                              uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceMaterial>(materials, count));
    return outcome(table->table.setMaterials(list));
}

GlintResult glint_surface_table_set_meshes(GlintSurfaceTable* table, const GlintSurfaceMesh* meshes, uint32_t count) {
    GLINT_C_REQUIRE(table);
    GLINT_C_TRY(list, readArray<SurfaceMesh>(meshes, count));
    return outcome(table->table.setMeshes(list));
}

void glint_surface_table_record(GlintSurfaceTable* table, VkCommandBuffer commands) {
    if (table && commands)
        table->table.record(commands);
}
