// Bakes reflection probes for a scene: places them, draws their faces with our renderer, and filters the faces with the
// library.
#pragma once

#include "glint/context.hpp"
#include "lab/job/job_inputs.hpp"
#include "lab/renderer/renderer.hpp"
#include "lab/sources/probe_file.hpp"
#include "lab/sources/probe_places.hpp"

#include <functional>

namespace glint::render {

struct BakeOptions {
    std::vector<ProbePlace> places; ///< placed by the user; empty: placed automatically
    uint32_t most = 8;              ///< maximum number of automatically placed probes, [1, 256]
    uint32_t faceSize = 256;        ///< texels, a power of two, [16, 1024]
    uint32_t bounces = 2;           ///< maximum mirrors on a light path, the first included, [1, 4]
    std::function<void(const char* what, size_t done, size_t of)> progress; ///< may be empty
};

/// `renderer` must show the scene of `inputs`; its G-buffer has another size afterwards. A scene whose cameras see no
/// reflective surface gets no probes. Errors: InvalidArgument for places that Probes::create rejects; OutOfMemory,
/// DeviceLost.
Result<ProbeSet> bakeProbes(gpu::Context& context, Context& library, Renderer& renderer, const JobInputs& inputs,
                            const RenderSettings& settings, const std::string& sceneName, const BakeOptions& options);

} // namespace glint::render
