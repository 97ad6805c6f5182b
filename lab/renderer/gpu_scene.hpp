// A posed scene on the GPU: vertices, indices, materials, textures, and the draw list.
#pragma once

#include "gpu/pass.hpp"
#include "gpu/resources.hpp"
#include "lab/renderer/body_shape.hpp"
#include "lab/renderer/gpu_materials.hpp"
#include "lab/scene/pose.hpp"
#include "shared/gpu_scene.h"

#include <unordered_map>

namespace glint::render {

/// One draw call. Its index in GpuScene::items() is its instance index.
struct GpuItem {
    uint32_t firstIndex = 0;
    uint32_t indexCount = 0;
    int32_t vertexOffset = 0;
    int32_t prevVertexDelta = 0; ///< offset from a vertex to its place in the previous pose; 0 unless it deforms
    scene::Topology topology = scene::Topology::Triangles;
    SurfaceClass surface = SurfaceClass::Opaque;
    bool doubleSided = false;
    bool isBody = false;   ///< light passes through the object from front to back; its back faces are not drawn
    bool mirrored = false; ///< the transform has a negative determinant
    scene::Bounds boundsWS;
};

class GpuScene {
public:
    /// `scene` and `pose` are only read. Errors: OutOfMemory, DeviceLost; Unsupported for a scene whose vertices or
    /// instances do not fit into one buffer of this device.
    static Result<GpuScene> create(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose);

    /// Poses the same scene at another time. Motion vectors are relative to the previous pose, so call this once per
    /// frame while anything moves, and once more when it stops. Errors: OutOfMemory, DeviceLost.
    Result<void> setPose(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose);

    /// Call after the scene's materials have changed; their number must be the same. Returns false if a new GpuScene
    /// and new passes are needed: for other textures, or for the first or no transmissive surface. Errors: as create.
    Result<bool> setMaterials(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose);

    const std::vector<GpuItem>& items() const { return items_; }
    bool transmitsLight() const { return transmitsLight_; } ///< at least one item is transmissive
    const scene::Bounds& boundsWS() const { return boundsWS_; }
    gpu::Pass& bind(gpu::Pass& pass); ///< what lab/shaders/render/scene_bindings.glsl declares, and the indices
    gpu::Buffer& positions() { return positions_; }   ///< float3
    gpu::Buffer& attributes() { return attributes_; } ///< shared::VertexAttributes
    gpu::Buffer& indices() { return indices_; }       ///< uint32
    gpu::Buffer& materials() { return materials_; }   ///< shared::Material; the last one is glTF's default
    const gpu::TextureTable& textures() const { return textures_.table(); }
    uint32_t textureIndex(const scene::TextureSlot& slot, TextureKind kind) const {
        return textures_.index(slot, kind);
    }

private:
    struct Range {
        uint32_t firstIndex = 0;
        uint32_t firstVertex = 0;
        int prevVertexDelta = 0;
    };

    Result<void> uploadMaterials(gpu::Context& context, const scene::Scene& scene);
    Result<void> uploadGeometry(gpu::Context& context, const scene::Pose& pose);
    Result<void> uploadInstances(gpu::Context& context, const scene::Scene& scene, const scene::Pose& pose);

    GpuTextures textures_;
    gpu::Buffer materials_, instances_, positions_, attributes_, indices_;
    gpu::Buffer geometry_; ///< shared::GeometryAddresses
    std::unordered_map<const scene::Geometry*, Range> ranges_;
    std::vector<GpuItem> items_;
    bool transmitsLight_ = false;
    std::vector<glm::mat4> lastTransforms_;            ///< of the previous pose, by item
    std::vector<BodyShape> lastShapes_;                ///< by item
    std::vector<std::vector<glm::vec3>> lastDeformed_; ///< positions of the previous pose, by index in Pose::deformed
    scene::Bounds boundsWS_;
};

} // namespace glint::render
