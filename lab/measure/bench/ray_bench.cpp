#include "lab/measure/bench/ray_bench.hpp"

#include "base/elapsed.hpp"
#include "gpu/memory.hpp"
#include "lab/measure/truth/ray_list_pass.hpp"

namespace glint::measure {
namespace {

/// The hits of one back end's scene, which the next back end's hits are compared with.
struct Hits {
    std::vector<ListedHit> camera, bounce, changed;
};

/// Medians of several updates.
class UpdateSamples {
public:
    void add(const SubmitTimes& submitted, const RaySceneTimes& scene) {
        cpu_.push_back(scene.cpuUpdateMs + submitted.recordMs);
        wall_.push_back(submitted.wallMs);
        gpu_.push_back(scene.gpuUpdateMs);
    }
    RayUpdateTimes medians() const {
        return {Spread::of(cpu_).median, Spread::of(wall_).median, Spread::of(gpu_).median};
    }

private:
    std::vector<double> cpu_, wall_, gpu_;
};

class BackendRun {
public:
    BackendRun(gpu::Context& context, Context& library, const RayBenchScene& scene, const RayBenchPlan& plan)
        : context_(context), library_(library), scene_(scene), plan_(plan), cameraRays_(cameraRays(plan.rays)) {}

    Result<RayBackendFigures> run(RayBackend backend) {
        RayBackendFigures figures;
        figures.backend = backend;
        const size_t before = allocated();
        const auto start = std::chrono::steady_clock::now();
        auto created = create(backend);
        figures.createMs = millisecondsSince(start);
        if (!created) {
            const ErrorCode code = created.error().code;
            if (code != ErrorCode::Unsupported && code != ErrorCode::OutOfMemory)
                return std::move(created).error();
            figures.refused = created.error().message;
            return figures;
        }
        RayScene rays = std::move(created).value();
        GLINT_TRY(built, submit(rays));
        const RaySceneTimes times = rays.times();
        figures.build = {built.recordMs, built.wallMs, times.gpuBuildMs + times.gpuUpdateMs};
        figures.mostBytes = allocated() - before;
        rays.releaseStaging();
        figures.bytes = allocated() - before;

        GLINT_TRY(pass, RayListPass::create(context_, backend));
        Hits hits;
        GLINT_CHECK(trace(pass, rays, cameraRays_, plan_.repeats, figures.camera, hits.camera));
        if (!known_) // the first back end's hits are the origins of the bounce rays of both: the rays are the same
            bounceRays_ = bounceRays(scene_, cameraRays_, hits.camera);
        GLINT_CHECK(trace(pass, rays, bounceRays_, plan_.repeats, figures.bounce, hits.bounce));
        GLINT_CHECK(change(rays, figures));
        GLINT_CHECK(trace(pass, rays, cameraRays_, 1, figures.changed, hits.changed));
        if (known_) {
            figures.camera.differ = differingHits(cameraRays_, known_->camera, hits.camera);
            figures.bounce.differ = differingHits(bounceRays_, known_->bounce, hits.bounce);
            figures.changed.differ = differingHits(cameraRays_, known_->changed, hits.changed);
        }
        known_ = std::move(hits);
        return figures;
    }

private:
    size_t allocated() { return gpu::allocatedBytes(library_.gpu().allocator()); }

    Result<RayScene> create(RayBackend backend) {
        const std::vector<RayMesh> meshes = scene_.meshes();
        const std::vector<RayInstance> instances = scene_.instances(0);
        RaySceneDesc desc;
        desc.meshes = meshes;
        desc.instances = instances;
        desc.backend = backend;
        return RayScene::create(library_, desc);
    }

    Result<SubmitTimes> submit(RayScene& rays) {
        return timedSubmit(context_, [&](VkCommandBuffer commands) { rays.record(commands); });
    }

    Result<void> trace(RayListPass& pass, RayScene& rays, const std::vector<ListedRay>& list, uint32_t repeats,
                       RayTraceTimes& times, std::vector<ListedHit>& hits) {
        if (list.empty())
            return {};
        GLINT_CHECK(pass.setRays(list));
        GLINT_CHECK(pass.trace(rays)); // a driver may compile when a shader first runs
        std::vector<double> gpu, wall;
        for (uint32_t i = 0; i < repeats; ++i) {
            GLINT_TRY(traced, pass.trace(rays));
            gpu.push_back(traced.gpuMs);
            wall.push_back(traced.wallMs);
        }
        GLINT_TRY(found, pass.hits());
        times.rays = list.size();
        for (const ListedHit& hit : found)
            times.met += hit.met() ? 1 : 0;
        times.gpuMs = Spread::of(std::move(gpu));
        times.wallMs = Spread::of(std::move(wall));
        hits = std::move(found);
        return {};
    }

    /// Each kind of change is measured alone, so that neither is hidden in the other's time.
    Result<void> change(RayScene& rays, RayBackendFigures& figures) {
        UpdateSamples moves, deforms;
        for (uint32_t i = 1; i <= plan_.repeats; ++i) {
            const float phase = 0.2f * static_cast<float>(i);
            GLINT_CHECK(rays.setInstances(scene_.instances(phase)));
            GLINT_TRY(moved, submit(rays));
            moves.add(moved, rays.times());
            const std::vector<glm::vec3> positions = scene_.deformed(phase);
            GLINT_CHECK(rays.deform(RayBenchScene::kDeformedMesh, &positions.front().x,
                                    static_cast<uint32_t>(positions.size())));
            GLINT_TRY(deformed, submit(rays));
            deforms.add(deformed, rays.times());
        }
        figures.move = moves.medians();
        figures.deform = deforms.medians();
        return {};
    }

    gpu::Context& context_;
    Context& library_;
    const RayBenchScene& scene_;
    const RayBenchPlan& plan_;
    std::vector<ListedRay> cameraRays_, bounceRays_;
    std::optional<Hits> known_;
};

template <class Add>
void forEachTrace(const RayBenchFigures& figures, const Add& add) {
    for (const RayBackendFigures& backend : figures.backends)
        for (const RayTraceTimes* trace : {&backend.camera, &backend.bounce, &backend.changed})
            if (trace->differ)
                add(*trace);
}

} // namespace

uint64_t RayBenchFigures::differing() const {
    uint64_t sum = 0;
    forEachTrace(*this, [&](const RayTraceTimes& trace) { sum += *trace.differ; });
    return sum;
}

uint64_t RayBenchFigures::compared() const {
    uint64_t sum = 0;
    forEachTrace(*this, [&](const RayTraceTimes& trace) { sum += trace.rays; });
    return sum;
}

Result<RayBenchFigures> measureRays(gpu::Context& context, Context& library, const RayBenchPlan& plan) {
    const RayBenchScene scene(plan.triangles);
    RayBenchFigures figures;
    figures.triangles = scene.triangles();
    figures.placed = scene.placed();
    figures.deformed = scene.deformedTriangles();
    figures.meshes = 1 + RayBenchScene::kBallMeshes;
    figures.instances = 1 + RayBenchScene::kBalls;
    BackendRun run(context, library, scene, plan);
    for (const RayBackend backend : {RayBackend::Query, RayBackend::Bvh}) {
        if (backend == RayBackend::Query && !context.rayQuery())
            continue;
        GLINT_TRY(measured, run.run(backend));
        figures.backends.push_back(std::move(measured));
    }
    return figures;
}

} // namespace glint::measure
