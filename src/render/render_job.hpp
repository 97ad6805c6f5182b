// One headless rendering, from words to pictures: the seam between the command line and the frame.
#pragma once

#include "glint/inspection.hpp"
#include "glint/reflections.hpp"
#include "render/find_mirrors.hpp"
#include "render/program_settings.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint::render {

struct RenderJob {
    std::string scene;  ///< a .gltf or .glb path, or "builtin:NAME"
    std::string camera; ///< a camera's name or index in the scene, or a camera file; empty: the first, or a view of all
    std::string environment; ///< an .hdr or .exr path, "sky" or "none"; empty: what suits the scene
    uint32_t width = 0;      ///< pixels, [1, 16384]; 0 with height 0: the camera's own size, or 1280 x 720
    uint32_t height = 0;
    double time = 0;                                ///< seconds into the scene's animations
    uint32_t frames = 1;                            ///< >= 1; the pictures are those of the last one
    uint32_t seed = 0;                              ///< of the rays' noise: the same seed, the same bits
    std::vector<std::string> views;                 ///< names of `viewList` (views.hpp), without repeats
    bool display = false;                           ///< also make RenderedView::rgb8
    bool statistics = false;                        ///< also count outcomes and lookups
    std::optional<std::array<uint32_t, 2>> inspect; ///< also trace this pixel's ray once more, in the last frame
    std::string probes; ///< a file of glint bake, or "auto": the one beside the scene, else baked now; empty: none
    MirrorSearch planar = MirrorSearch::None; ///< which flat surfaces get pictures of their own
    std::string device;    ///< part of a name, or an index of `glint devices`; empty: the best usable one
    bool validate = false; ///< run under the validation layer; any message of it is an error
    ProgramSettings settings;
    std::function<void(uint32_t done, uint32_t frames)> progress; ///< may be empty
};

struct RenderedView {
    std::string name;
    std::vector<float> rgba;   ///< width * height * 4, rows from the top: linear radiance, metres, ... (ViewKind)
    std::vector<uint8_t> rgb8; ///< with RenderJob::display and ViewKind::Radiance: through the display pass, sRGB
};

struct RenderStats {
    std::string device;
    std::string driver;
    bool software = false;                                  ///< the device runs on the CPU
    std::vector<std::pair<std::string, double>> passes;     ///< GPU milliseconds, median of the frames; in order
    uint64_t rays = 0;                                      ///< traced in the last frame
    double lookupsPerRay = 0;                               ///< mean
    uint32_t lookups95 = 0;                                 ///< 95th percentile
    Statistics::SceneRays scene;                            ///< of the last frame
    std::vector<std::pair<std::string, uint64_t>> outcomes; ///< pixels; every name, also those with 0
};

struct RenderResult {
    uint32_t width = 0;
    uint32_t height = 0;
    std::vector<RenderedView> views; ///< in the job's order
    RenderStats stats;
    std::optional<RayInspection> inspection; ///< with RenderJob::inspect
    std::vector<std::string> notes;          ///< what the user should know: a missing capability and its fallback
};

/// How a job is done. The command line takes it as a value: tests hand in one that needs no GPU.
using RenderFunction = std::function<Result<RenderResult>(const RenderJob&)>;

} // namespace glint::render
