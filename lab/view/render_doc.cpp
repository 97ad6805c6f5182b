#include "lab/view/render_doc.hpp"

#include <dlfcn.h>

#include <cstdint>

namespace glint::view {
namespace {

constexpr int kVersion = 10000; ///< 1.0.0: later versions only append functions
constexpr const char* kLibrary = "librenderdoc.so";

} // namespace

/// RENDERDOC_API_1_0_0, "In-application API", renderdoc.org/docs/in_application_api.html: function pointers, of which
/// two are called.
struct RenderDoc::Functions {
    void (*before[19])();
    void (*startFrameCapture)(void* device, void* window); ///< null: any
    uint32_t (*isFrameCapturing)();
    uint32_t (*endFrameCapture)(void* device, void* window); ///< 1: done
};

std::optional<RenderDoc> RenderDoc::find() {
    void* const library = dlopen(kLibrary, RTLD_NOW | RTLD_NOLOAD);
    if (!library)
        return std::nullopt;
    using GetApi = int (*)(int version, void** functions);
    const auto getApi = reinterpret_cast<GetApi>(dlsym(library, "RENDERDOC_GetAPI"));
    void* functions = nullptr;
    if (!getApi || getApi(kVersion, &functions) != 1 || !functions)
        return std::nullopt;
    return RenderDoc(*static_cast<const Functions*>(functions));
}

void RenderDoc::start() const {
    functions_->startFrameCapture(nullptr, nullptr);
}

bool RenderDoc::end() const {
    return functions_->endFrameCapture(nullptr, nullptr) == 1;
}

} // namespace glint::view
