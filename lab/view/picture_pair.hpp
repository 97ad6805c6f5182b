// The window's content for the scene: the picture, the picture beside it, and their difference.
#pragma once

#include "lab/view/frame_pace.hpp"
#include "lab/view/gui_renderer.hpp"
#include "lab/view/scene_picture.hpp"
#include "lab/view/viewer_state.hpp"

namespace glint::view {

class PicturePair {
public:
    /// Texture numbers for GuiRenderer::smooth and squares.
    static constexpr uint32_t kPicture = 0;
    static constexpr uint32_t kBesideView = 1;
    static constexpr uint32_t kBesideSettings = 2;
    static constexpr uint32_t kHeat = 3;
    static constexpr uint32_t kSecondCamera = 4;

    explicit PicturePair(gpu::Context& context) : context_(context) {}

    /// Opens a scene; on error the open scene is kept. Errors: as ScenePicture::create.
    Result<void> open(const render::RenderJob& job);

    /// Renders what `state` requests, at most one frame of each picture, at the size of `window` reduced by the frame
    /// pace. Writes figures and the inspected ray into `state`. Does nothing for a window without area. Errors:
    /// DeviceLost, OutOfMemory; settings that the device does not support are reverted with a message instead.
    Result<void> update(ViewerState& state, glm::uvec2 window);
    /// Recreates all device objects, as needed after gpu::Context::replaceShaders; on error the shown pictures are
    /// kept. Errors: as ScenePicture::remake.
    Result<void> remake();
    /// Restarts rendering although nothing has changed.
    void restart();
    /// True if more updates would change nothing.
    bool complete() const { return complete_; }
    /// True if the images changed since the last call: the panels' renderer must then be updated.
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
    std::unique_ptr<ScenePicture> beside_; ///< with other settings; absent until requested
    std::unique_ptr<ScenePicture> second_; ///< from another camera; absent until requested
    gpu::Image heat_;
    FramePace pace_;
    RecentTimes recent_;
    std::string recentOf_; ///< size and settings that the recent times belong to
    bool complete_ = false;
    double frameStart_ = 0;

    // State of the last update, to detect changes.
    glm::mat4 lastCamera_ = glm::mat4(0);
    uint64_t lastSettings_ = 0;
    double lastSeconds_ = 0;
    uint64_t lastMaterials_ = 0;
    glm::uvec2 lastWindow_ = glm::uvec2(0);
    std::string shown_;       ///< view and versions shown in picture_'s image
    std::string shownBeside_; ///< view and versions shown beside it
    std::string shownSecond_;
    std::string heatOf_;
    std::string rayOf_;
    std::string imagesOf_;
    std::string besideOf_;
    render::ProgramSettings besideSettings_;
};

} // namespace glint::view
