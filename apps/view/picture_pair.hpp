// What the window shows of the scene: the picture, what stands beside it, and how the two differ.
#pragma once

#include "frame_pace.hpp"
#include "gui_renderer.hpp"
#include "scene_picture.hpp"
#include "viewer_state.hpp"

namespace glint::view {

class PicturePair {
public:
    /// Numbers for GuiRenderer::smooth and squares.
    static constexpr uint32_t kPicture = 0;
    static constexpr uint32_t kBesideView = 1;
    static constexpr uint32_t kBesideSettings = 2;
    static constexpr uint32_t kHeat = 3;
    static constexpr uint32_t kSecondCamera = 4;

    explicit PicturePair(gpu::Context& context) : context_(context) {}

    /// Opens a scene; what was open before stays if that fails. Errors: as ScenePicture::create.
    Result<void> open(const render::RenderJob& job);

    /// Renders what `state` asks for, one frame at most of each picture, in `window` divided by what the pace allows;
    /// writes figures and the asked ray into `state`. Does nothing for a window without area.
    /// Errors: DeviceLost, OutOfMemory; settings that the device cannot have are taken back with a message instead.
    Result<void> update(ViewerState& state, glm::uvec2 window);
    /// Everything on the device anew, as after gpu::Context::replaceShaders; what is shown stays if that fails.
    /// Errors: as ScenePicture::remake.
    Result<void> remake();
    /// Renders anew although nothing has changed.
    void restart();
    /// More updates would change nothing.
    bool complete() const { return complete_; }
    /// The images changed since the last call: the panels' renderer has to be told.
    bool imagesChanged();
    std::vector<const gpu::Image*> images() const;

    ScenePicture& picture() { return *picture_; }

private:
    bool moved(const ViewerState& state, glm::uvec2 window);
    Result<void> prepare(ScenePicture& picture, const ViewerState& state, glm::uvec2 size);
    Result<void> updatePicture(ViewerState& state, glm::uvec2 size, uint32_t divisor);
    Result<void> updateBeside(ViewerState& state, glm::uvec2 size);
    Result<void> placeSecond(ViewerState& state);
    Result<void> updateSecond(ViewerState& state);
    Result<void> updateHeat(ViewerState& state);
    Result<void> answer(ViewerState& state);
    void note(ViewerState& state);

    gpu::Context& context_;
    render::RenderJob job_;
    std::unique_ptr<ScenePicture> picture_;
    std::unique_ptr<ScenePicture> beside_; ///< with other settings; absent until asked for
    std::unique_ptr<ScenePicture> second_; ///< from another camera; absent until asked for
    gpu::Image heat_;
    FramePace pace_;
    RecentTimes recent_;
    std::string recentOf_; ///< what size and which settings they are of
    bool complete_ = false;
    double frameStart_ = 0;

    // What was seen last, to know what has changed.
    glm::mat4 lastCamera_ = glm::mat4(0);
    uint64_t lastSettings_ = 0;
    double lastSeconds_ = 0;
    glm::uvec2 lastWindow_ = glm::uvec2(0);
    std::string shown_;       ///< view and versions in picture_'s image
    std::string shownBeside_; ///< the same of what stands beside
    std::string shownSecond_;
    std::string heatOf_;
    std::string rayOf_;
    std::string imagesOf_;
    std::string besideOf_;
    render::ProgramSettings besideSettings_;
};

} // namespace glint::view
