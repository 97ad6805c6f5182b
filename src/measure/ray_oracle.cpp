#include "measure/ray_oracle.hpp"

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

constexpr size_t kMaxCulled = 64; ///< back faces that one ray may pass through before it counts as a miss

struct Part {
    const scene::DrawItem* item = nullptr;
    glm::dmat3 normalToWorld = glm::dmat3(1);
    bool mirrored = false; ///< the transform turns triangles inside out
    bool doubleSided = false;
};

} // namespace

struct RayOracle::State {
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    std::vector<Part> parts; ///< by Embree's geometry id

    ~State() {
        if (scene)
            rtcReleaseScene(scene);
        if (device)
            rtcReleaseDevice(device);
    }

    glm::dvec3 vertexWS(const Part& part, uint32_t vertex) const {
        return glm::dvec3(glm::dmat4(part.item->localToWorld) * glm::dvec4(part.item->geometry->positions[vertex], 1));
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
    const scene::Material defaultMaterial;
    for (const scene::DrawItem& item : pose.items) {
        const scene::Geometry& geometry = *item.geometry;
        const scene::Material& material =
            item.material < 0 ? defaultMaterial : scene.materials[static_cast<size_t>(item.material)];
        if (geometry.topology != scene::Topology::Triangles || material.alphaMode == scene::AlphaMode::Blend)
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
        rtcCommitGeometry(triangles);
        rtcAttachGeometryByID(state->scene, triangles, static_cast<unsigned>(state->parts.size()));
        rtcReleaseGeometry(triangles);

        const glm::dmat3 linear = glm::dmat3(item.localToWorld);
        state->parts.push_back(
            {&item, glm::transpose(glm::inverse(linear)), glm::determinant(linear) < 0, material.doubleSided});
    }
    rtcCommitScene(state->scene);
    return RayOracle(std::move(state));
}

std::optional<OracleHit> RayOracle::trace(const glm::dvec3& originWS, const glm::dvec3& directionWS,
                                          double minDistance) const {
    double start = minDistance;
    for (size_t pass = 0; pass < kMaxCulled; ++pass) {
        RTCRayHit query = {};
        query.ray.org_x = static_cast<float>(originWS.x);
        query.ray.org_y = static_cast<float>(originWS.y);
        query.ray.org_z = static_cast<float>(originWS.z);
        query.ray.dir_x = static_cast<float>(directionWS.x);
        query.ray.dir_y = static_cast<float>(directionWS.y);
        query.ray.dir_z = static_cast<float>(directionWS.z);
        query.ray.tnear = static_cast<float>(start);
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
        const glm::dvec3 a = state_->vertexWS(part, triangle[0]);
        const glm::dvec3 b = state_->vertexWS(part, triangle[1]);
        const glm::dvec3 c = state_->vertexWS(part, triangle[2]);
        const glm::dvec3 geometric = glm::cross(b - a, c - a) * (part.mirrored ? -1.0 : 1.0);
        const double facing = glm::dot(geometric, directionWS);
        if (facing > 0 && !part.doubleSided) {
            start = static_cast<double>(std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity()));
            continue;
        }
        OracleHit hit;
        // Embree's single-precision distance, refined on the triangle's plane.
        hit.distance = facing != 0 ? glm::dot(geometric, a - originWS) / facing : static_cast<double>(query.ray.tfar);
        hit.material = part.item->material;
        hit.positionWS = originWS + directionWS * hit.distance;
        hit.frontFace = facing < 0;
        const double u = static_cast<double>(query.hit.u);
        const double v = static_cast<double>(query.hit.v);
        glm::dvec3 normal = geometric;
        if (!geometry.normals.empty())
            normal = part.normalToWorld *
                     (glm::dvec3(geometry.normals[triangle[0]]) * (1 - u - v) +
                      glm::dvec3(geometry.normals[triangle[1]]) * u + glm::dvec3(geometry.normals[triangle[2]]) * v);
        hit.normalWS = glm::normalize(hit.frontFace ? normal : -normal);
        return hit;
    }
    return std::nullopt;
}

} // namespace glint::measure
