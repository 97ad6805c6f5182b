// One headless rendering, from options to images: the seam between the command line and the frame.
#pragma once

#include "glint/inspection.hpp"
#include "glint/reflections.hpp"
#include "lab/job/program_settings.hpp"
#include "lab/scene/find_mirrors.hpp"

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace glint::render {

struct RenderJob {
    std::string scene; ///< a .gltf or .glb path, or "builtin:NAME"
    /// A camera's name or index in the scene, or a camera file; empty: the first camera, or a view of the whole scene.
    std::string camera;
    std::string environment; ///< an .hdr or .exr path, "sky" or "none"; empty: the scene's default
    /// A file of material overrides, or "none"; empty: the file beside the scene, if there is one.
    std::string materials;
    uint32_t width = 0; ///< pixels, [1, 16384]; 0 with height 0: the camera's own size, or 1280 x 720
    uint32_t height = 0;
    double time = 0;          ///< seconds into the scene's animations
    uint32_t frames = 1;      ///< >= 1; the images are those of the last frame
    uint32_t stillFrames = 0; ///< frames that the viewer draws of a still view; 0: as many as the settings take
    /// A picture to look at: display.antialias auto means accumulate.
    bool smoothStill = false;
    /// Stops before `frames` once the picture has settled within this error (Settling); 0: never.
    double settle = 0;
    uint32_t seed = 0;              ///< seed of the rays' noise: the same seed gives the same bits
    std::vector<std::string> views; ///< names of `viewList` (views.hpp), without repeats
    /// The session can show views that the library makes. Without them it does what a host's frame does, in less time;
    /// the last bits of pictures may differ.
    bool libraryViews = true;
    bool display = false;                           ///< also fill RenderedView::rgb8
    bool statistics = false;                        ///< also count outcomes and depth fetches, and
    bool passTimes = true;                          ///< draw as many frames as RenderStats::passes takes
    std::optional<std::array<uint32_t, 2>> inspect; ///< also trace this pixel's ray again, in the last frame
    /// A file written by glint bake, or "auto": the file beside the scene, or baked now if there is none; empty: none.
    std::string probes;
    MirrorSearch planar = MirrorSearch::None; ///< which flat surfaces get a mirrored view
    std::string device;    ///< part of a device name, or an index of `glint devices`; empty: the best usable device
    bool validate = false; ///< run under the validation layer; any validation message is an error
    ProgramSettings settings;
    std::function<void(uint32_t done, uint32_t frames)> progress; ///< may be empty
};

struct RenderedView {
    std::string name;
    std::vector<float> rgba;   ///< width * height * 4, rows from the top: linear radiance, metres, ... (ViewKind)
    std::vector<uint8_t> rgb8; ///< with RenderJob::display and ViewKind::Radiance: output of the display pass, sRGB
};

struct RenderStats {
    std::string device;
    std::string driver;
    bool software = false; ///< the device runs on the CPU
    /// GPU milliseconds, median over the frames; in recording order.
    std::vector<std::pair<std::string, double>> passes;
    uint64_t rays = 0;                                      ///< rays traced in the last frame
    double lookupsPerRay = 0;                               ///< mean
    uint32_t lookups95 = 0;                                 ///< 95th percentile
    Statistics::SceneRays scene;                            ///< of the last frame
    std::vector<std::pair<std::string, uint64_t>> outcomes; ///< pixels; every name, including those with 0
    MemoryReport memory;                                    ///< of the library, without the renderer
    std::vector<FrameDecision> plan;                        ///< which passes the library's frames have
};

/// How a picture settled.
struct Settled {
    uint32_t frames = 0; ///< rendered
    double error = 0;    ///< Settling::error; infinite after one frame
};

struct RenderResult {
    uint32_t width = 0;
    uint32_t height = 0;
    std::optional<Settled> settled;  ///< with RenderJob::settle
    std::vector<RenderedView> views; ///< in the job's order
    RenderStats stats;
    std::optional<RayInspection> inspection; ///< with RenderJob::inspect
    std::vector<std::string> notes;          ///< notes for the user: a missing capability and its fallback
};

/// Executes a job. The command line takes it as a parameter, so that tests can provide one that needs no GPU.
using RenderFunction = std::function<Result<RenderResult>(const RenderJob&)>;

} // namespace glint::render
