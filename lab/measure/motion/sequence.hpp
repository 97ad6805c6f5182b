// Moving pictures: renders a scene along a camera path, frame by frame, with one or more configurations, and measures
// them against a reference (docs/motion.md). The frames of a configuration may also come from files.
#pragma once

#include "gpu/context.hpp"
#include "lab/measure/motion/motion_figures.hpp"
#include "lab/measure/motion/sequence_reference.hpp"
#include "lab/measure/motion/stored_frames.hpp"
#include "lab/measure/truth/comparison.hpp"
#include "lab/scene/camera_path.hpp"

#include <functional>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace glint::measure {

/// The movement of the camera: a built-in one or the keys of a path file.
struct SequencePath {
    scene::CameraMove move = scene::CameraMove::Still;
    double pixelsPerFrame = 2;                            ///< of a point at the focus, for a built-in movement
    std::vector<scene::PathKey> keys;                     ///< not empty: these instead of `move`
    uint32_t stop = std::numeric_limits<uint32_t>::max(); ///< the camera stands still from this frame on
};

struct SequencePlan {
    std::vector<ComparedConfig> configs; ///< at least one; all with the same scene, camera and size
    SequencePath path;
    uint32_t frames = 1;  ///< >= 1
    double fps = 60;      ///< frames per second of the scene's and the camera's clock, > 0
    bool measure = false; ///< also compute figures: each config is rendered with two seeds
    uint32_t warmUp = 0;  ///< frames that count for no mean
    /// By index of a config: frames to measure instead of rendering them, at least `frames`. Requires `measure`.
    std::map<size_t, StoredFrames> stored;
    std::vector<std::string> views; ///< further views, read of every rendered frame for SequenceCallbacks::views
    /// Measured against; its job's number of frames is averaged. Absent: few figures are known.
    std::optional<ComparedConfig> reference;
};

/// A frame that has been rendered.
struct SequenceFrame {
    size_t config = 0; ///< index in SequencePlan::configs
    uint32_t index = 0;
    uint32_t width = 0;
    uint32_t height = 0;
    const render::RenderedView& composite;
    const render::RenderedView& reflection;
};

/// When a frame shows the scene, and from where.
struct SequenceMoment {
    double seconds = 0; ///< of the scene's clock
    render::View view;
};

/// Views of a rendered frame.
struct SequenceViews {
    size_t config = 0; ///< index in SequencePlan::configs
    uint32_t seed = 0;
    uint32_t index = 0;
    const SequenceMoment& now;
    const SequenceMoment& previous;              ///< of the frame before; the first frame's own
    std::span<const render::RenderedView> views; ///< in the order of SequencePlan::views
};

struct SequenceCallbacks {
    /// Receives the frames of the first seed in order; may be empty. With RenderJob::display of the first config, also
    /// as displayed. Stored frames are not given.
    std::function<Result<void>(const SequenceFrame&)> frame;
    /// Receives the views of each frame, seed by seed; may be empty.
    std::function<Result<void>(const SequenceViews&)> views;
    std::function<void(const std::string& what, uint32_t done, uint32_t frames)> progress; ///< may be empty
};

struct SequenceConfig {
    std::string name;
    render::ProgramSettings settings;
    std::vector<std::string> notes;
    EffectTimes times;
    double raysPerPixel = 0;            ///< screen rays and rays through triangles, mean over the frames
    size_t storedSeeds = 0;             ///< not 0: the frames come from files; then no settings, times and rays
    std::vector<MotionFigures> figures; ///< by Signal; empty unless measured
};

struct Sequence {
    std::string scene;
    uint32_t width = 0;
    uint32_t height = 0;
    uint32_t frames = 0;
    double fps = 0;
    std::string device;
    std::string driver;
    bool software = false;
    std::string reference;        ///< name; empty: none
    uint32_t referenceFrames = 0; ///< averaged for each frame of the sequence and each seed
    uint32_t warmUp = 0;
    std::vector<uint32_t> steps; ///< first frames after a sudden change of the scene
    std::vector<SequenceConfig> configs;
};

/// The first frame shows the scene at the first config's time; frame i shows it i / fps seconds later. The same plan
/// gives the same bits on one device and driver. Sudden changes are the keys of the scene's stepped animations. Errors:
/// those of the scene's readers, the device, the callbacks and StoredFrames; InvalidArgument if so many frames do not
/// fit into memory; InvalidInput for stored frames of another size.
Result<Sequence> renderSequence(gpu::Context& context, const SequencePlan& plan, const SequenceCallbacks& callbacks);

} // namespace glint::measure
