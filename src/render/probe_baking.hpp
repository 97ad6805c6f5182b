// Bakes reflection probes for a scene: places them, draws their faces with our renderer, has the library filter them.
#pragma once

#include "glint/context.hpp"
#include "render/job_inputs.hpp"
#include "render/probe_file.hpp"
#include "render/probe_places.hpp"
#include "render/renderer.hpp"

#include <functional>

namespace glint::render {

struct BakeOptions {
    std::vector<ProbePlace> places; ///< placed by a person; empty: found automatically
    uint32_t most = 8;              ///< probes that are found, [1, 256]
    uint32_t faceSize = 256;        ///< texels, a power of two, [16, 1024]
    uint32_t bounces = 2;           ///< mirrors that a path of light meets at most, itself among them, [1, 4]
    std::function<void(const char* what, size_t done, size_t of)> progress; ///< may be empty
};

/// `renderer` shows the scene of `inputs`; its G-buffer's size is another one afterwards. A scene in which no camera
/// sees anything reflective gets no probes.
/// Errors: InvalidArgument for places that Probes::create does not take; OutOfMemory, DeviceLost.
Result<ProbeSet> bakeProbes(gpu::Context& context, Context& library, Renderer& renderer, const JobInputs& inputs,
                            const RenderSettings& settings, const std::string& sceneName, const BakeOptions& options);

} // namespace glint::render
