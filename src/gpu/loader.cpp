#include "gpu/loader.hpp"

#ifdef _WIN32
#include <windows.h>
#else
#include <dlfcn.h>
#endif

namespace glint::gpu {

#ifdef _WIN32

Result<void*> openLoader() {
    if (HMODULE loader = LoadLibraryA("vulkan-1.dll"))
        return static_cast<void*>(loader);
    return makeError(ErrorCode::NotFound, "no Vulkan loader (vulkan-1.dll): install a graphics driver with Vulkan");
}

PFN_vkGetInstanceProcAddr instanceProcAddr(void* loader) {
    // By way of void*: a FARPROC has other parameters.
    return reinterpret_cast<PFN_vkGetInstanceProcAddr>(
        reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(loader), "vkGetInstanceProcAddr")));
}

void closeLoader(void* loader) {
    FreeLibrary(static_cast<HMODULE>(loader));
}

#else

Result<void*> openLoader() {
    for (const char* name : {"libvulkan.so.1", "libvulkan.so"})
        if (void* loader = dlopen(name, RTLD_NOW | RTLD_LOCAL))
            return loader;
    return makeError(ErrorCode::NotFound,
                     "no Vulkan loader (libvulkan.so.1): install libvulkan1, or start the program with scripts/glint");
}

PFN_vkGetInstanceProcAddr instanceProcAddr(void* loader) {
    return reinterpret_cast<PFN_vkGetInstanceProcAddr>(dlsym(loader, "vkGetInstanceProcAddr"));
}

void closeLoader(void* loader) {
    dlclose(loader);
}

#endif

} // namespace glint::gpu
