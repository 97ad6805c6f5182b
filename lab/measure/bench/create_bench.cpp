#include "lab/measure/bench/create_bench.hpp"

#include "base/elapsed.hpp"
#include "glint/reflections.hpp"

#include <optional>

namespace glint::measure {
namespace {

constexpr VkDeviceAddress kUnreadAddress = 4; ///< creation takes addresses of vertex data, and reads none

/// The host's pipeline cache.
class PipelineCache {
public:
    static Result<std::unique_ptr<PipelineCache>> create(const gpu::Context& context) {
        const gpu::Api& api = context.api();
        std::unique_ptr<PipelineCache> made(new PipelineCache(context.device()));
        const auto load = [&]<class Function>(Function& function, const char* name) {
            function = reinterpret_cast<Function>(api.GetInstanceProcAddr(context.instance(), name));
        };
        PFN_vkCreatePipelineCache create = nullptr;
        load(create, "vkCreatePipelineCache");
        load(made->destroy_, "vkDestroyPipelineCache");
        load(made->getData_, "vkGetPipelineCacheData");
        const VkPipelineCacheCreateInfo info = {VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
        if (!create || !made->destroy_ || !made->getData_ ||
            create(context.device(), &info, nullptr, &made->cache_) != VK_SUCCESS)
            return makeError(ErrorCode::Unsupported, "the device makes no pipeline cache");
        return made;
    }
    ~PipelineCache() {
        if (cache_)
            destroy_(device_, cache_, nullptr);
    }
    PipelineCache(const PipelineCache&) = delete;
    PipelineCache& operator=(const PipelineCache&) = delete;

    VkPipelineCache handle() const { return cache_; }
    size_t bytes() const {
        size_t size = 0;
        return getData_(device_, cache_, &size, nullptr) == VK_SUCCESS ? size : 0;
    }

private:
    explicit PipelineCache(VkDevice device) : device_(device) {}
    VkDevice device_;
    VkPipelineCache cache_ = VK_NULL_HANDLE;
    PFN_vkDestroyPipelineCache destroy_ = nullptr;
    PFN_vkGetPipelineCacheData getData_ = nullptr;
};

/// One triangle: which pipelines setRays makes does not depend on the scene.
struct OneTriangle {
    RayScene scene;
    SurfaceTable surfaces;

    static Result<OneTriangle> create(Context& library, RayBackend backend) {
        const float positions[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        const uint32_t indices[] = {0, 1, 2};
        const RayMesh mesh = {positions, 3, 12, indices};
        const RayInstance instance;
        GLINT_TRY(scene, RayScene::create(library, {{&mesh, 1}, {&instance, 1}, 0, backend}));
        SurfaceMesh surfaceMesh;
        surfaceMesh.positions = {kUnreadAddress, 12};
        surfaceMesh.indices = kUnreadAddress;
        const SurfaceMaterial material;
        const SurfaceInstance surface;
        SurfaceTableDesc desc;
        desc.materials = {&material, 1};
        desc.meshes = {&surfaceMesh, 1};
        desc.instances = {&surface, 1};
        GLINT_TRY(surfaces, SurfaceTable::create(library, desc));
        return OneTriangle{std::move(scene), std::move(surfaces)};
    }
};

/// A device's Context of the library, with what a host keeps on it.
class Host {
public:
    static Result<std::unique_ptr<Host>> create(const gpu::Context& context, const PipelineCache& cache,
                                                const Settings& settings) {
        const gpu::AdoptedDevice handles = context.handles();
        GLINT_TRY(library, Context::adopt({handles.instance, handles.physicalDevice, handles.device,
                                           handles.queueFamily, handles.getInstanceProcAddr, handles.rayQuery,
                                           DeviceDemands::Sources, cache.handle()}));
        std::unique_ptr<Host> host(new Host(std::move(library)));
        if (settings.rays.enabled) {
            GLINT_TRY(triangle, OneTriangle::create(host->library_, settings.rays.backend));
            host->triangle_.emplace(std::move(triangle));
        }
        return host;
    }

    /// Times the creation of an object, which the host then keeps beside those before it.
    struct Times {
        double create = 0, setRays = 0;
    };
    Result<Times> add(const ReflectionsDesc& desc) {
        Times times;
        auto start = std::chrono::steady_clock::now();
        GLINT_TRY(made, Reflections::create(library_, desc));
        times.create = millisecondsSince(start);
        objects_.push_back(std::move(made));
        if (triangle_) {
            start = std::chrono::steady_clock::now();
            GLINT_CHECK(objects_.back().setRays(triangle_->scene, triangle_->surfaces));
            times.setRays = millisecondsSince(start);
        }
        return times;
    }
    Reflections& newest() { return objects_.back(); }

private:
    explicit Host(Context library) : library_(std::move(library)) {}
    Context library_;
    std::optional<OneTriangle> triangle_;
    std::vector<Reflections> objects_;
};

/// Repeated times of both calls.
struct Samples {
    std::vector<double> create, setRays;
    void add(const Host::Times& times) {
        create.push_back(times.create);
        setRays.push_back(times.setRays);
    }
};

Result<CreateFigures> measureConfig(const gpu::Context& context, const CreatePlan& plan,
                                    const CreatePlan::Config& config) {
    ReflectionsDesc desc;
    desc.width = plan.width;
    desc.height = plan.height;
    desc.settings = config.settings;
    CreateFigures figures;
    figures.config = config.name;
    figures.rays = config.settings.rays.enabled;
    GLINT_TRY(cache, PipelineCache::create(context));
    {
        GLINT_TRY(host, Host::create(context, *cache, config.settings));
        GLINT_TRY(first, host->add(desc));
        figures.reflections.firstMs = first.create;
        figures.setRays.firstMs = first.setRays;
    }
    Samples cached, again;
    std::vector<double> resizes;
    for (uint32_t i = 0; i < plan.repeats; ++i) {
        GLINT_TRY(host, Host::create(context, *cache, config.settings));
        GLINT_TRY(warm, host->add(desc));
        cached.add(warm);
        GLINT_TRY(second, host->add(desc));
        again.add(second);
        const auto start = std::chrono::steady_clock::now();
        GLINT_CHECK(host->newest().resize(plan.width > 1 ? plan.width - 1 : 2, plan.height));
        resizes.push_back(millisecondsSince(start));
    }
    figures.reflections.cachedMs = Spread::of(cached.create).median;
    figures.setRays.cachedMs = Spread::of(cached.setRays).median;
    figures.reflections.againMs = Spread::of(again.create).median;
    figures.setRays.againMs = Spread::of(again.setRays).median;
    figures.resizeMs = Spread::of(resizes).median;
    figures.pipelineBytes = cache->bytes();
    return figures;
}

} // namespace

Result<CreateResult> measureCreation(gpu::Context& context, const CreatePlan& plan,
                                     const std::function<void(const std::string&)>& progress) {
    CreateResult result = {context.info().name, context.info().driver, plan, {}};
    for (const CreatePlan::Config& config : plan.configs) {
        if (progress)
            progress(config.name);
        GLINT_TRY(figures, measureConfig(context, plan, config));
        result.figures.push_back(std::move(figures));
    }
    return result;
}

} // namespace glint::measure
