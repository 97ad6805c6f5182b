#include "gpu/support/ray_test.hpp"

#include "gpu/transfer.hpp"

#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cstring>

namespace glint::test {

void TestMesh::addTriangle(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
    for (const glm::vec3& p : {a, b, c}) {
        indices.push_back(static_cast<uint32_t>(positions.size()));
        positions.push_back(p);
    }
}

std::unique_ptr<rays::Scene> TestScene::build(gpu::Context& context, RayBackend backend, uint32_t maxInstances) const {
    std::vector<RayMesh> views;
    for (const TestMesh& mesh : meshes)
        views.push_back(mesh.view());
    return must(rays::Scene::create(context, {views, instances, maxInstances, backend}));
}

TestScene oneTriangle() {
    TestScene scene;
    scene.meshes.emplace_back().addTriangle({-1, -1, -2}, {3, -1, -2}, {-1, 3, -2});
    scene.instances.emplace_back();
    return scene;
}

std::vector<TestHit> traceRays(gpu::Context& context, rays::Scene& scene, const std::vector<TestRay>& rays,
                               double* milliseconds) {
    const std::unique_ptr<gpu::Timers> timers = must(gpu::Timers::create(context));
    constexpr VkBufferUsageFlags kUsage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_SRC_BIT;
    gpu::Buffer in = must(gpu::uploadBuffer(context, "test/rays", rays, kUsage));
    gpu::Buffer out = must(
        gpu::Buffer::create(context, {"test/hits", rays.size() * sizeof(TestHit), kUsage, gpu::BufferHome::Device}));
    const bool query = scene.backend() == RayBackend::Query;
    const gpu::Pipeline pipeline =
        must(gpu::Pipeline::compute(context, {query ? "ray_query" : "ray_bvh", 0, scene.constants()}));
    must(context.submitAndWait([&](VkCommandBuffer commands) {
        scene.record(commands);
        gpu::Frame frame(context, commands, timers.get());
        scene.bind(frame.pass(pipeline))
            .read("rays", in)
            .write("hits", out)
            .dispatch(static_cast<uint32_t>(rays.size()));
    }));
    scene.releaseStaging();
    if (milliseconds)
        *milliseconds = timers->latest().empty() ? 0 : timers->latest().front().milliseconds;
    const std::vector<std::byte> bytes = must(gpu::downloadBuffer(context, out));
    std::vector<TestHit> hits(rays.size());
    std::memcpy(hits.data(), bytes.data(), bytes.size());
    return hits;
}

std::vector<ExactHit> exactHits(const TestScene& scene, const TestRay& ray) {
    std::vector<ExactHit> hits;
    const glm::dvec3 direction(ray.directionWS);
    for (uint32_t i = 0; i < scene.instances.size(); ++i) {
        const RayInstance& instance = scene.instances[i];
        if ((instance.mask & ray.mask & 0xff) == 0)
            continue;
        const glm::dmat4 localToWorld(glm::make_mat4(instance.localToWorld.data()));
        const bool mirrored = glm::determinant(glm::dmat3(localToWorld)) < 0;
        const TestMesh& mesh = scene.meshes[instance.mesh];
        for (uint32_t t = 0; t < mesh.indices.size() / 3; ++t) {
            glm::dvec3 v[3];
            for (int corner = 0; corner < 3; ++corner)
                v[corner] = glm::dvec3(localToWorld * glm::dvec4(mesh.positions[mesh.indices[3 * t + corner]], 1));
            // Cramer's rule for origin + t d = v0 + x e1 + y e2.
            const glm::dvec3 e1 = v[1] - v[0];
            const glm::dvec3 e2 = v[2] - v[0];
            const glm::dvec3 s = glm::dvec3(ray.originWS) - v[0];
            const glm::dvec3 normal = glm::cross(e1, e2);
            const double facing = -glm::dot(normal, direction);
            const glm::dvec3 moment = glm::cross(s, direction);
            ExactHit hit;
            hit.distance = glm::dot(normal, s) / facing;
            hit.barycentrics = {glm::dot(e2, moment) / facing, -glm::dot(e1, moment) / facing};
            hit.edge = std::min({hit.barycentrics.x, hit.barycentrics.y, 1 - hit.barycentrics.x - hit.barycentrics.y});
            if (!(hit.edge >= 0) || !(hit.distance > static_cast<double>(ray.tMin)) ||
                !(hit.distance < static_cast<double>(ray.tMax)))
                continue;
            hit.instance = i;
            hit.primitive = t;
            hit.frontFace = (facing > 0) != mirrored;
            if ((ray.flags & shared::kRayCullBackFaces) && !hit.frontFace && !instance.doubleSided)
                continue;
            const double first = 1 - hit.barycentrics.x - hit.barycentrics.y;
            if (!instance.opaque && !(ray.flags & shared::kRayAllOpaque) && first >= 0.5 && (i + t) % 4 != 3)
                continue;
            hits.push_back(hit);
        }
    }
    std::sort(hits.begin(), hits.end(), [](const ExactHit& a, const ExactHit& b) { return a.distance < b.distance; });
    return hits;
}

} // namespace glint::test
