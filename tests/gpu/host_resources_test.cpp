// What a host may lend beside its device: a pipeline cache, the memory of Vulkan's objects, a log.
#include "gpu/support/library_test.hpp"
#include "gpu/support/scenes.hpp"
#include "gpu/support/surface_scene.hpp"

#include <gmock/gmock.h>

#include <atomic>
#include <cstdlib>
#include <mutex>

namespace glint::test {
namespace host_resources_test {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr uint32_t kWidth = 32;
constexpr uint32_t kHeight = 20;

/// The caches that pipelines were created with, seen between Glint and the driver.
struct CacheSpy {
    static inline PFN_vkGetInstanceProcAddr getInstanceProcAddr = nullptr;
    static inline PFN_vkGetDeviceProcAddr getDeviceProcAddr = nullptr;
    static inline PFN_vkCreateComputePipelines createComputePipelines = nullptr;
    static inline std::mutex mutex; ///< pipelines compile on several threads
    static inline std::vector<VkPipelineCache> caches;

    static VkResult VKAPI_CALL create(VkDevice device, VkPipelineCache cache, uint32_t count,
                                      const VkComputePipelineCreateInfo* infos, const VkAllocationCallbacks* callbacks,
                                      VkPipeline* pipelines) {
        {
            const std::lock_guard lock(mutex);
            caches.push_back(cache);
        }
        return createComputePipelines(device, cache, count, infos, callbacks, pipelines);
    }
    static PFN_vkVoidFunction VKAPI_CALL ofDevice(VkDevice device, const char* name) {
        if (std::string_view(name) != "vkCreateComputePipelines")
            return getDeviceProcAddr(device, name);
        createComputePipelines = reinterpret_cast<PFN_vkCreateComputePipelines>(getDeviceProcAddr(device, name));
        return reinterpret_cast<PFN_vkVoidFunction>(&create);
    }
    static PFN_vkVoidFunction VKAPI_CALL ofInstance(VkInstance instance, const char* name) {
        if (std::string_view(name) != "vkGetDeviceProcAddr")
            return getInstanceProcAddr(instance, name);
        getDeviceProcAddr = reinterpret_cast<PFN_vkGetDeviceProcAddr>(getInstanceProcAddr(instance, name));
        return reinterpret_cast<PFN_vkVoidFunction>(&ofDevice);
    }
};

/// The host's memory for Vulkan's objects, counted.
struct CountingMemory {
    std::atomic<int64_t> blocks = 0;
    std::atomic<int64_t> calls = 0;

    static void* VKAPI_CALL allocate(void* user, size_t size, size_t alignment, VkSystemAllocationScope) {
        auto* self = static_cast<CountingMemory*>(user);
        ++self->blocks;
        ++self->calls;
        const size_t step = std::max(alignment, alignof(std::max_align_t));
        return std::aligned_alloc(step, (size + step - 1) / step * step);
    }
    static void* VKAPI_CALL reallocate(void* user, void* old, size_t size, size_t alignment,
                                       VkSystemAllocationScope scope) {
        if (!old)
            return allocate(user, size, alignment, scope);
        ++static_cast<CountingMemory*>(user)->calls;
        return std::realloc(old, size); // drivers ask for no more than malloc's alignment here
    }
    static void VKAPI_CALL release(void* user, void* memory) {
        if (memory)
            --static_cast<CountingMemory*>(user)->blocks;
        std::free(memory);
    }
    VkAllocationCallbacks callbacks() { return {this, &allocate, &reallocate, &release, nullptr, nullptr}; }
};

class HostResourcesTest : public LibraryTest {
protected:
    static HostDevice device() {
        const gpu::AdoptedDevice handles = gpu().handles();
        HostDevice host;
        host.instance = handles.instance;
        host.physicalDevice = handles.physicalDevice;
        host.device = handles.device;
        host.queueFamily = handles.queueFamily;
        host.getInstanceProcAddr = handles.getInstanceProcAddr;
        host.rayQuery = handles.rayQuery;
        return host;
    }
    static SyntheticGBuffer host() {
        return SyntheticGBuffer::render(gpu(), floorAndWall(), SyntheticCamera(), kWidth, kHeight);
    }
    static void record(Reflections& reflections) {
        run([&](VkCommandBuffer commands) { reflections.record(commands, SyntheticCamera().view(kWidth, kHeight)); });
    }
};

TEST_F(HostResourcesTest, WithoutTheScreenSourceItsPassesAreNotCompiled) {
    HostDevice lent = device();
    CacheSpy::getInstanceProcAddr = lent.getInstanceProcAddr;
    lent.getInstanceProcAddr = &CacheSpy::ofInstance;
    const auto create = [&](Context& context, bool screen) {
        CacheSpy::caches.clear();
        ReflectionsDesc desc = {kWidth, kHeight};
        desc.settings.denoise.enabled = false;
        desc.settings.screen.enabled = screen;
        return must(Reflections::create(context, desc));
    };
    Context all = must(Context::adopt(lent));
    create(all, true);
    const size_t withScreen = CacheSpy::caches.size();
    Context few = must(Context::adopt(lent));
    Reflections reflections = create(few, false);
    const size_t without = CacheSpy::caches.size();
    EXPECT_LE(without + 3, withScreen) << "trace/classify, trace/hiz, prepare/pyramid";
    const SyntheticGBuffer given = host();
    must(reflections.setInputs(given.gbuffer));
    record(reflections);
    Settings settings;
    settings.denoise.enabled = false;
    must(reflections.setSettings(settings));
    EXPECT_EQ(CacheSpy::caches.size(), withScreen + 1) << "prepare/surface, which prepare/classified now stands in for";
    record(reflections);
}

TEST_F(HostResourcesTest, EveryPipelineIsCreatedWithTheHostsCache) {
    const auto getProcAddr = gpu().handles().getInstanceProcAddr;
    const auto create =
        reinterpret_cast<PFN_vkCreatePipelineCache>(getProcAddr(gpu().instance(), "vkCreatePipelineCache"));
    const auto destroy =
        reinterpret_cast<PFN_vkDestroyPipelineCache>(getProcAddr(gpu().instance(), "vkDestroyPipelineCache"));
    const VkPipelineCacheCreateInfo info = {VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
    VkPipelineCache cache = VK_NULL_HANDLE;
    ASSERT_EQ(create(gpu().device(), &info, nullptr, &cache), VK_SUCCESS);
    HostDevice lent = device();
    CacheSpy::getInstanceProcAddr = lent.getInstanceProcAddr;
    lent.getInstanceProcAddr = &CacheSpy::ofInstance;
    for (const VkPipelineCache one : {cache, VkPipelineCache(VK_NULL_HANDLE)}) {
        CacheSpy::caches.clear();
        lent.pipelineCache = one;
        Context context = must(Context::adopt(lent));
        must(Reflections::create(context, {kWidth, kHeight}));
        EXPECT_GT(CacheSpy::caches.size(), 5u);
        EXPECT_THAT(CacheSpy::caches, testing::Each(one));
    }
    destroy(gpu().device(), cache, nullptr);
}

TEST_F(HostResourcesTest, EveryVulkanObjectLivesInTheHostsMemory) {
    CountingMemory memory;
    VkAllocationCallbacks callbacks = memory.callbacks();
    const SyntheticGBuffer gbuffer = host();
    SurfaceScene scene;
    scene.addQuad({-4, 0, 4}, {8, 0, 0}, {0, 0, -8}, whiteMetal(0.2f));
    {
        HostDevice lent = device();
        lent.allocationCallbacks = &callbacks;
        Context context = must(Context::adopt(lent));
        callbacks = {}; // it was copied
        Settings settings;
        settings.rays.enabled = true;
        SurfaceScene::World world = scene.build(gpu(), context, RayBackend::Auto);
        Reflections reflections = must(Reflections::create(context, {kWidth, kHeight, settings}));
        must(reflections.setInputs(gbuffer.gbuffer));
        must(reflections.setRays(world.rays, world.surfaces));
        run([&](VkCommandBuffer commands) {
            world.rays.record(commands);
            world.surfaces.record(commands);
            reflections.record(commands, SyntheticCamera().view(kWidth, kHeight));
        });
        EXPECT_GT(memory.blocks, 20); // pipelines, layouts, samplers, images, buffers, queries
    }
    EXPECT_EQ(memory.blocks, 0) << "what was allocated with the callbacks is freed with them";
    EXPECT_GT(memory.calls, 20);
}

TEST_F(HostResourcesTest, NotesReachTheHostsLogOnceAsTheyAreMade) {
    std::vector<std::string> log;
    HostDevice lent = device();
    lent.message = [](void* user, const char* text) {
        static_cast<std::vector<std::string>*>(user)->emplace_back(text);
    };
    lent.messageUser = &log;
    Context context = must(Context::adopt(lent));
    Reflections reflections = must(Reflections::create(context, {kWidth, kHeight}));
    record(reflections);
    record(reflections);
    EXPECT_THAT(log, ElementsAre(HasSubstr("record before setInputs")));
    log.clear();
    const SyntheticGBuffer gbuffer = host();
    must(reflections.setInputs(gbuffer.gbuffer));
    must(reflections.setInputs(gbuffer.gbuffer)); // the same note is not news
    record(reflections);
    EXPECT_THAT(log, Contains(HasSubstr("no fallbackSpecular")));
    EXPECT_EQ(log, reflections.notes()) << "each once";
}

} // namespace host_resources_test
} // namespace glint::test
