#include "lab/measure/truth/ray_oracle.hpp"

#include "lab/measure/truth/alpha_cutout.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#define GLINT_EMBREE_MAJOR 4
#else
#include <embree3/rtcore.h>
#define GLINT_EMBREE_MAJOR 3
#endif

#include <cstring>
#include <vector>

namespace glint::measure {
namespace {

/// One item of the pose, as the raster pass would draw it.
struct Part {
    const scene::Scene* scene = nullptr;
    const scene::DrawItem* item = nullptr;
    const scene::Material* material = nullptr;
    glm::dmat3 normalToWorld = glm::dmat3(1);
    bool mirrored = false; ///< the transform reverses the triangles' winding
    size_t index = 0;      ///< of the item in the pose

    glm::dvec3 vertexWS(uint32_t vertex) const {
        return glm::dvec3(glm::dmat4(item->localToWorld) * glm::dvec4(item->geometry->positions[vertex], 1));
    }
    /// Not unit; towards the triangle's front.
    glm::dvec3 geometricNormalWS(const uint32_t* triangle) const {
        const glm::dvec3 a = vertexWS(triangle[0]);
        return glm::cross(vertexWS(triangle[1]) - a, vertexWS(triangle[2]) - a) * (mirrored ? -1.0 : 1.0);
    }
};

/// Embree's filter callback, called for each hit along the ray: rejects hits that the raster pass does not draw.
void passWhatIsNotDrawn(const RTCFilterFunctionNArguments* arguments) {
    const Part& part = *static_cast<const Part*>(arguments->geometryUserPtr);
    const scene::Geometry& geometry = *part.item->geometry;
    const size_t firstIndex = size_t{3} * RTCHitN_primID(arguments->hit, 1, 0);
    if (!part.material->doubleSided) {
        const glm::dvec3 direction(RTCRayN_dir_x(arguments->ray, 1, 0), RTCRayN_dir_y(arguments->ray, 1, 0),
                                   RTCRayN_dir_z(arguments->ray, 1, 0));
        if (glm::dot(part.geometricNormalWS(geometry.indices.data() + firstIndex), direction) > 0) {
            arguments->valid[0] = 0;
            return;
        }
    }
    const TrianglePoint point = {firstIndex, static_cast<double>(RTCHitN_u(arguments->hit, 1, 0)),
                                 static_cast<double>(RTCHitN_v(arguments->hit, 1, 0))};
    if (isHole(*part.scene, *part.material, geometry, point))
        arguments->valid[0] = 0;
}

} // namespace

struct RayOracle::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    scene::Material defaultMaterial;
    std::vector<Part> parts; ///< by Embree's geometry id; never moved, as Embree refers to its elements

    ~State() {
        if (scene)
            rtcReleaseScene(scene);
        if (device)
            rtcReleaseDevice(device);
    }
};

RayOracle::RayOracle(std::unique_ptr<State> state) : state_(std::move(state)) {}
RayOracle::~RayOracle() = default;
RayOracle::RayOracle(RayOracle&&) noexcept = default;
RayOracle& RayOracle::operator=(RayOracle&&) noexcept = default;

Result<RayOracle> RayOracle::create(const scene::Scene& scene, const scene::Pose& pose) {
    auto state = std::make_unique<State>();
    state->device = rtcNewDevice("threads=2");
    if (!state->device)
        return makeError(ErrorCode::Unsupported, "Embree cannot start (error {})",
                         static_cast<int>(rtcGetDeviceError(nullptr)));
    state->scene = rtcNewScene(state->device);
    rtcSetSceneFlags(state->scene, RTC_SCENE_FLAG_ROBUST);
    state->parts.reserve(pose.items.size());
    for (const scene::DrawItem& item : pose.items) {
        const scene::Geometry& geometry = *item.geometry;
        const scene::Material& material =
            item.material < 0 ? state->defaultMaterial : scene.materials[static_cast<size_t>(item.material)];
        const bool transmits = material.transmissionFactor > 0 && !material.unlit && !material.specularGlossiness;
        if (geometry.topology != scene::Topology::Triangles || material.alphaMode == scene::AlphaMode::Blend ||
            transmits)
            continue;
        RTCGeometry triangles = rtcNewGeometry(state->device, RTC_GEOMETRY_TYPE_TRIANGLE);
        auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
            triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), geometry.positions.size()));
        for (size_t i = 0; i < geometry.positions.size(); ++i) {
            const glm::vec3 p = glm::vec3(item.localToWorld * glm::vec4(geometry.positions[i], 1));
            std::memcpy(vertices + 3 * i, &p, sizeof(p));
        }
        void* indices = rtcSetNewGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                3 * sizeof(uint32_t), geometry.indices.size() / 3);
        std::memcpy(indices, geometry.indices.data(), geometry.indices.size() / 3 * 3 * sizeof(uint32_t));
        const glm::dmat3 linear = glm::dmat3(item.localToWorld);
        const bool mirrored = glm::determinant(linear) < 0;
        state->parts.push_back({&scene, &item, &material, glm::transpose(glm::inverse(linear)), mirrored,
                                static_cast<size_t>(&item - pose.items.data())});
        if (!material.doubleSided || material.alphaMode == scene::AlphaMode::Mask) {
            rtcSetGeometryUserData(triangles, &state->parts.back());
            rtcSetGeometryIntersectFilterFunction(triangles, passWhatIsNotDrawn);
        }
        rtcCommitGeometry(triangles);
        rtcAttachGeometryByID(state->scene, triangles, static_cast<unsigned>(state->parts.size() - 1));
        rtcReleaseGeometry(triangles);
    }
    rtcCommitScene(state->scene);
    return RayOracle(std::move(state));
}

std::optional<OracleHit> RayOracle::trace(const glm::dvec3& originWS, const glm::dvec3& directionWS,
                                          double minDistance) const {
    RTCRayHit query = {};
    query.ray.org_x = static_cast<float>(originWS.x);
    query.ray.org_y = static_cast<float>(originWS.y);
    query.ray.org_z = static_cast<float>(originWS.z);
    query.ray.dir_x = static_cast<float>(directionWS.x);
    query.ray.dir_y = static_cast<float>(directionWS.y);
    query.ray.dir_z = static_cast<float>(directionWS.z);
    query.ray.tnear = static_cast<float>(minDistance);
    query.ray.tfar = std::numeric_limits<float>::infinity();
    query.ray.mask = ~0u;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if GLINT_EMBREE_MAJOR == 4
    rtcIntersect1(state_->scene, &query);
#else
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(state_->scene, &context, &query);
#endif
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return std::nullopt;

    const Part& part = state_->parts[query.hit.geomID];
    const scene::Geometry& geometry = *part.item->geometry;
    const uint32_t* triangle = geometry.indices.data() + size_t{3} * query.hit.primID;
    const glm::dvec3 geometric = part.geometricNormalWS(triangle);
    const double facing = glm::dot(geometric, directionWS);
    OracleHit hit;
    // Embree's single-precision distance, refined on the triangle's plane.
    hit.distance = facing != 0 ? glm::dot(geometric, part.vertexWS(triangle[0]) - originWS) / facing
                               : static_cast<double>(query.ray.tfar);
    hit.material = part.item->material;
    hit.positionWS = originWS + directionWS * hit.distance;
    hit.frontFace = facing < 0;
    hit.geometricNormalWS = glm::normalize(hit.frontFace ? geometric : -geometric);
    const double u = static_cast<double>(query.hit.u);
    const double v = static_cast<double>(query.hit.v);
    hit.item = part.index;
    hit.firstIndex = size_t{3} * query.hit.primID;
    hit.barycentric = {u, v};
    glm::dvec3 normal = geometric;
    if (!geometry.normals.empty())
        normal = part.normalToWorld *
                 (glm::dvec3(geometry.normals[triangle[0]]) * (1 - u - v) +
                  glm::dvec3(geometry.normals[triangle[1]]) * u + glm::dvec3(geometry.normals[triangle[2]]) * v);
    hit.normalWS = glm::normalize(hit.frontFace ? normal : -normal);
    return hit;
}

} // namespace glint::measure
