#include "reflect/rays/surface_table.hpp"

#include "gpu/device_address.hpp"
#include "reflect/host_numbers.hpp"
#include "shared/light.h"
#include "shared/material.h"
#include "shared/surface_table.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glint::reflect {
namespace {

// ---------------------------------------------------------------- materials

/// Visits every texture of a material with its field in the shader's struct.
template <class Visit>
void visitTextures(const SurfaceMaterial& m, shared::Material& out, Visit visit) {
    visit(m.baseColorTexture, out.baseColorTexture);
    visit(m.metallicRoughnessTexture, out.metallicRoughnessTexture);
    visit(m.normalTexture, out.normalTexture);
    visit(m.occlusionTexture, out.occlusionTexture);
    visit(m.emissiveTexture, out.emissiveTexture);
    visit(m.specularTexture, out.specularTexture);
    visit(m.specularColorTexture, out.specularColorTexture);
    visit(m.transmissionTexture, out.transmissionTexture);
    visit(m.thicknessTexture, out.thicknessTexture);
    visit(m.clearcoatTexture, out.clearcoatTexture);
    visit(m.clearcoatRoughnessTexture, out.clearcoatRoughnessTexture);
    visit(m.clearcoatNormalTexture, out.clearcoatNormalTexture);
    visit(m.specularGlossinessTexture, out.specularGlossinessTexture);
}

uint32_t materialFlags(const SurfaceMaterial& material) {
    uint32_t flags = 0;
    if (material.unlit)
        flags |= shared::kMaterialUnlit;
    if (material.specularGlossiness)
        flags |= shared::kMaterialSpecularGlossiness;
    if (material.alpha == SurfaceAlpha::Mask)
        flags |= shared::kMaterialAlphaMask;
    if (material.alpha == SurfaceAlpha::Blend)
        flags |= shared::kMaterialAlphaBlend;
    return flags;
}

bool isTransparent(const SurfaceMaterial& m) {
    return m.alpha == SurfaceAlpha::Blend || (m.transmissionFactor > 0 && !m.unlit && !m.specularGlossiness);
}

/// Unlit surfaces emit their base colour.
bool emits(const SurfaceMaterial& m) {
    return !isTransparent(m) &&
           (m.unlit || std::ranges::any_of(m.emissiveFactor, [](float factor) { return factor > 0; }));
}

Result<shared::Material> packMaterial(const SurfaceMaterial& m, size_t number, uint32_t textureCount) {
    shared::Material out = {};
    out.flags = materialFlags(m);
    out.alphaCutoff = m.alphaCutoff;
    out.baseColorFactor = {m.baseColorFactor[0], m.baseColorFactor[1], m.baseColorFactor[2], m.baseColorFactor[3]};
    out.metallicFactor = m.metallicFactor;
    out.roughnessFactor = m.roughnessFactor;
    out.emissiveFactor = toVec(m.emissiveFactor);
    out.normalScale = m.normalScale;
    out.occlusionStrength = m.occlusionStrength;
    out.specularFactor = m.specularFactor;
    out.specularColorFactor = toVec(m.specularColorFactor);
    out.ior = m.ior;
    out.transmissionFactor = m.transmissionFactor;
    out.thicknessFactor = m.thicknessFactor;
    out.attenuationColor = toVec(m.attenuationColor);
    out.attenuationDistance = std::isfinite(m.attenuationDistance) ? m.attenuationDistance : 0;
    out.clearcoatFactor = m.clearcoatFactor;
    out.clearcoatRoughnessFactor = m.clearcoatRoughnessFactor;
    out.clearcoatNormalScale = m.clearcoatNormalScale;
    out.specularGlossinessFactor = toVec(m.specularGlossinessFactor);
    out.glossinessFactor = m.glossinessFactor;
    Result<void> status;
    visitTextures(m, out, [&](const SurfaceTextureRef& ref, shared::TextureRef& packed) {
        const std::array<float, 6>& uv = ref.uvTransform;
        packed = {ref.index, ref.texCoord, {uv[0], uv[1], uv[2]}, {uv[3], uv[4], uv[5]}};
        if (ref.index != kNoSurfaceTexture && (ref.index >= textureCount || ref.texCoord > 1))
            status = invalidArgument("surface material {} has texture {} at texCoord {}: there are {} textures, and "
                                     "texCoord is 0 or 1",
                                     number, ref.index, ref.texCoord, textureCount);
    });
    GLINT_CHECK(status);
    return out;
}

// ---------------------------------------------------------------- meshes

bool isAligned(const VertexStream& stream) {
    return stream.address % 4 == 0 && stream.stride % 4 == 0 && (stream.address == 0 || stream.stride > 0);
}

shared::StreamRecord packStream(const VertexStream& stream) {
    return {gpu::addressWords(stream.address), stream.stride / 4};
}

Result<shared::SurfaceMeshRecord> packMesh(const SurfaceMesh& mesh, size_t number) {
    for (const VertexStream* stream :
         {&mesh.positions, &mesh.normals, &mesh.tangents, &mesh.uv0, &mesh.uv1, &mesh.colors, &mesh.previousPositions})
        if (!isAligned(*stream))
            return invalidArgument("surface mesh {}: addresses and strides must be multiples of 4", number);
    if (mesh.positions.address == 0 || mesh.indices == 0 || mesh.indices % 4 != 0)
        return invalidArgument("surface mesh {}: positions and indices must be there, at multiples of 4", number);
    return shared::SurfaceMeshRecord{packStream(mesh.positions),
                                     packStream(mesh.normals),
                                     packStream(mesh.tangents),
                                     packStream(mesh.uv0),
                                     packStream(mesh.uv1),
                                     packStream(mesh.colors),
                                     gpu::addressWords(mesh.indices),
                                     packStream(mesh.previousPositions)};
}

// ---------------------------------------------------------------- lights

shared::Light packLight(const SurfaceLight& light) {
    shared::Light out = {};
    out.type = light.kind == SurfaceLightKind::Directional ? shared::kLightDirectional
               : light.kind == SurfaceLightKind::Point     ? shared::kLightPoint
                                                           : shared::kLightSpot;
    out.color = toVec(light.color);
    out.positionWS = toVec(light.positionWS);
    out.directionWS = toVec(light.directionWS);
    out.range = std::isfinite(light.range) ? light.range : 0;
    // KHR_lights_punctual, "Inner and Outer Cone Angles": the reference falloff, as scale and offset.
    const float cosOuter = std::cos(light.outerConeAngle);
    out.spotScale = 1 / std::max(std::cos(light.innerConeAngle) - cosOuter, 0.001f);
    out.spotOffset = -cosOuter * out.spotScale;
    out.castsShadow = light.castsShadow ? 1 : 0;
    return out;
}

} // namespace

// ---------------------------------------------------------------- the lists

Result<void> TableBuffer::create(gpu::Context& context, const char* name, size_t most) {
    GLINT_TRY(buffer,
              gpu::Buffer::create(context, {name, std::max<size_t>(most, 16),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT |
                                                VK_BUFFER_USAGE_TRANSFER_SRC_BIT,
                                            gpu::BufferHome::Device}));
    buffer_ = std::move(buffer);
    return {};
}

void TableBuffer::record(gpu::Frame& frame, const gpu::Progress& progress) {
    if (!upload_.isNeeded(progress))
        return;
    frame.update(buffer_, content_, dirty_.merged());
    upload_.recorded(progress);
}

Result<std::unique_ptr<SurfaceTableState>> SurfaceTableState::create(gpu::Context& context,
                                                                     const SurfaceTableDesc& desc) {
    std::unique_ptr<SurfaceTableState> table(new SurfaceTableState(context));
    std::vector<VkDescriptorImageInfo> textures;
    for (const SurfaceTexture& texture : desc.textures) {
        if (!texture.view || !texture.sampler)
            return invalidArgument("surface texture {} needs a view and a sampler", textures.size());
        textures.push_back({texture.sampler, texture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL});
    }
    if (desc.materials.empty())
        return invalidArgument("a surface table needs at least one material");
    GLINT_TRY(progress, gpu::Progress::create(context, "surfaces/progress"));
    table->progress_ = std::move(progress);
    GLINT_TRY(set, gpu::TextureTable::create(context, textures));
    table->textures_ = std::move(set);
    table->textureCount_ = static_cast<uint32_t>(textures.size());
    table->maxInstances_ = std::max(desc.maxInstances, static_cast<uint32_t>(desc.instances.size()));
    table->maxLights_ = std::max(desc.maxLights, static_cast<uint32_t>(desc.lights.size()));
    table->maxMaterials_ = static_cast<uint32_t>(desc.materials.size());
    table->maxMeshes_ = static_cast<uint32_t>(desc.meshes.size());
    GLINT_CHECK(table->instances_.create(context, "surfaces/instances",
                                         table->maxInstances_ * sizeof(shared::SurfaceInstanceRecord)));
    GLINT_CHECK(
        table->meshes_.create(context, "surfaces/meshes", table->maxMeshes_ * sizeof(shared::SurfaceMeshRecord)));
    GLINT_CHECK(
        table->materials_.create(context, "surfaces/materials", table->maxMaterials_ * sizeof(shared::Material)));
    GLINT_CHECK(table->lights_.create(context, "surfaces/lights", table->maxLights_ * sizeof(shared::Light)));
    GLINT_CHECK(table->setMeshes(desc.meshes));
    GLINT_CHECK(table->setMaterials(desc.materials));
    GLINT_CHECK(table->setInstances(desc.instances));
    GLINT_CHECK(table->setLights(desc.lights));
    return table;
}

/// `first`: the number of the first one in the list, for messages.
Result<std::vector<shared::SurfaceInstanceRecord>> SurfaceTableState::pack(std::span<const SurfaceInstance> instances,
                                                                           uint32_t first) const {
    std::vector<shared::SurfaceInstanceRecord> records;
    for (const SurfaceInstance& instance : instances) {
        if (instance.mesh >= maxMeshes_ || instance.material >= maxMaterials_)
            return invalidArgument("surface instance {} has mesh {} of {} and material {} of {}",
                                   first + records.size(), instance.mesh, maxMeshes_, instance.material, maxMaterials_);
        const Matrix4& m = instance.localToWorld;
        shared::SurfaceInstanceRecord record = {};
        for (size_t row = 0; row < 3; ++row)
            record.localToWorld[row] = {m[row], m[4 + row], m[8 + row], m[12 + row]};
        record.mesh = instance.mesh;
        record.material = instance.material;
        records.push_back(record);
    }
    return records;
}

Result<void> SurfaceTableState::setInstances(std::span<const SurfaceInstance> instances) {
    if (instances.size() > maxInstances_)
        return invalidArgument("{} surface instances, the table was made for at most {}", instances.size(),
                               maxInstances_);
    GLINT_TRY(records, pack(instances, 0));
    instances_.set(records);
    instanceCount_ = static_cast<uint32_t>(records.size());
    instanceMaterials_.clear();
    for (const SurfaceInstance& instance : instances)
        instanceMaterials_.push_back(instance.material);
    return {};
}

Result<void> SurfaceTableState::updateInstances(uint32_t first, std::span<const SurfaceInstance> instances) {
    if (uint64_t{first} + instances.size() > instanceCount_)
        return invalidArgument("surface instances {} to {} are updated, the table has {}", first,
                               uint64_t{first} + instances.size(), instanceCount_);
    GLINT_TRY(records, pack(instances, first));
    instances_.replace(first, records);
    for (size_t i = 0; i < instances.size(); ++i)
        instanceMaterials_[first + i] = instances[i].material;
    return {};
}

std::vector<uint32_t> SurfaceTableState::transparentInstances() const {
    std::vector<uint32_t> found;
    for (uint32_t i = 0; i < instanceMaterials_.size(); ++i)
        if (instanceMaterials_[i] < isTransparent_.size() && isTransparent_[instanceMaterials_[i]])
            found.push_back(i);
    return found;
}

Result<void> SurfaceTableState::setLights(std::span<const SurfaceLight> lights) {
    if (lights.size() > maxLights_)
        return invalidArgument("{} surface lights, the table was made for at most {}", lights.size(), maxLights_);
    std::vector<shared::Light> records;
    for (const SurfaceLight& light : lights)
        records.push_back(packLight(light));
    lights_.set(records);
    lightCount_ = static_cast<uint32_t>(records.size());
    return {};
}

Result<void> SurfaceTableState::setMaterials(std::span<const SurfaceMaterial> materials) {
    if (materials.size() > maxMaterials_)
        return invalidArgument("{} surface materials, the table was made for {}", materials.size(), maxMaterials_);
    std::vector<shared::Material> records;
    isTransparent_.clear();
    emits_.clear();
    for (const SurfaceMaterial& material : materials) {
        GLINT_TRY(record, packMaterial(material, records.size(), textureCount_));
        records.push_back(record);
        isTransparent_.push_back(isTransparent(material));
        emits_.push_back(reflect::emits(material));
    }
    materials_.set(records);
    return {};
}

Result<void> SurfaceTableState::updateMaterials(uint32_t first, std::span<const SurfaceMaterial> materials) {
    if (uint64_t{first} + materials.size() > emits_.size())
        return invalidArgument("surface materials {} to {} are updated, the table has {}", first,
                               uint64_t{first} + materials.size(), emits_.size());
    std::vector<shared::Material> records;
    for (const SurfaceMaterial& material : materials) {
        GLINT_TRY(record, packMaterial(material, first + records.size(), textureCount_));
        records.push_back(record);
    }
    materials_.replace(first, records);
    for (size_t i = 0; i < materials.size(); ++i) {
        isTransparent_[first + i] = isTransparent(materials[i]);
        emits_[first + i] = reflect::emits(materials[i]);
    }
    return {};
}

Result<void> SurfaceTableState::setMeshes(std::span<const SurfaceMesh> meshes) {
    if (meshes.size() > maxMeshes_)
        return invalidArgument("{} surface meshes, the table was made for {}", meshes.size(), maxMeshes_);
    std::vector<shared::SurfaceMeshRecord> records;
    for (const SurfaceMesh& mesh : meshes) {
        GLINT_TRY(record, packMesh(mesh, records.size()));
        records.push_back(record);
    }
    meshes_.set(records);
    return {};
}

void SurfaceTableState::record(VkCommandBuffer commands) {
    const std::array lists = {&instances_, &meshes_, &materials_, &lights_};
    if (std::ranges::none_of(lists, [&](TableBuffer* list) { return list->pending(progress_); }))
        return;
    progress_.begin();
    gpu::Frame frame(context_, commands);
    for (TableBuffer* list : lists)
        list->record(frame, progress_);
    progress_.end(frame);
}

gpu::Pass& SurfaceTableState::bindAppearance(gpu::Pass& pass) {
    return pass.read("surfaceInstances", instances_.buffer())
        .read("surfaceMeshes", meshes_.buffer())
        .read("surfaceMaterials", materials_.buffer())
        .table(textures_.set());
}

gpu::Pass& SurfaceTableState::bind(gpu::Pass& pass) {
    return bindAppearance(pass).read("surfaceLights", lights_.buffer());
}

} // namespace glint::reflect

// ---------------------------------------------------------------- the public class

namespace glint {

SurfaceTable::SurfaceTable(std::unique_ptr<reflect::SurfaceTableState> state) : state_(std::move(state)) {}
SurfaceTable::~SurfaceTable() = default;
SurfaceTable::SurfaceTable(SurfaceTable&&) noexcept = default;
SurfaceTable& SurfaceTable::operator=(SurfaceTable&&) noexcept = default;

Result<SurfaceTable> SurfaceTable::create(Context& context, const SurfaceTableDesc& desc) {
    GLINT_TRY(state, reflect::SurfaceTableState::create(context.gpu(), desc));
    return SurfaceTable(std::move(state));
}

Result<void> SurfaceTable::setInstances(std::span<const SurfaceInstance> instances) {
    return state_->setInstances(instances);
}

Result<void> SurfaceTable::setLights(std::span<const SurfaceLight> lights) {
    return state_->setLights(lights);
}

Result<void> SurfaceTable::setMaterials(std::span<const SurfaceMaterial> materials) {
    return state_->setMaterials(materials);
}

Result<void> SurfaceTable::setMeshes(std::span<const SurfaceMesh> meshes) {
    return state_->setMeshes(meshes);
}

Result<void> SurfaceTable::updateInstances(uint32_t first, std::span<const SurfaceInstance> instances) {
    return state_->updateInstances(first, instances);
}

Result<void> SurfaceTable::updateMaterials(uint32_t first, std::span<const SurfaceMaterial> materials) {
    return state_->updateMaterials(first, materials);
}

void SurfaceTable::record(VkCommandBuffer commands) {
    state_->record(commands);
}

} // namespace glint
