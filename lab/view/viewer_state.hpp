// The state of the viewer and the requests of the user: panels and keys read and write it, the loop (viewer.hpp) acts
// on it.
#pragma once

#include "lab/session/run_job.hpp"
#include "lab/view/frame_figures.hpp"
#include "lab/view/materials_model.hpp"
#include "lab/view/open_list.hpp"
#include "lab/view/orbit_camera.hpp"
#include "lab/view/recent_files.hpp"
#include "lab/view/second_camera.hpp"
#include "lab/view/settings_model.hpp"
#include "lab/view/time_history.hpp"

#include <optional>
#include <string>
#include <vector>

namespace glint::view {

/// The content to the right of the dividing line, which can be dragged.
enum class Beside { Nothing, View, Settings };

/// Shown instead of the picture: its difference from the one beside it.
enum class Heat { None, Difference, Flip };

struct Request {
    enum class Kind {
        Screenshot,      ///< write the window to `text`
        Picture,         ///< write the scene's picture alone to `text`, .png or .exr
        Stats,           ///< write the help panel's figures to `text`
        SaveMaterials,   ///< write the material overrides to `text`
        Save,            ///< write the settings to `text`, and the camera beside them
        Open,            ///< open `text`: a scene, an environment, settings or a camera
        CopyCommandLine, ///< copy it to the clipboard
        CopyRay,         ///< copy the output of `glint inspect`
        Capture,         ///< capture the next frame with RenderDoc
        ReloadShaders,   ///< `text` "all": also shaders that have not changed
        Close,
    };
    Kind kind = Kind::Close;
    std::string text;
};

struct Animation {
    double seconds = 0; ///< time in the scene's animations
    double length = 0;  ///< of the longest animation; 0: there are none
    bool playing = false;
};

/// Zoom into the picture: the picture's pixel at the window's centre, and the magnification.
struct Zoom {
    float factor = 1; ///< 1: shows the whole picture
    glm::vec2 centerUV = glm::vec2(0.5f);
};

struct ViewerState {
    explicit ViewerState(SettingsModel model) : settings(std::move(model)) {}

    std::string scene; ///< as given on the command line
    SettingsModel settings;
    MaterialsModel materials;
    OrbitCamera camera;
    std::vector<scene::Camera> cameras; ///< cameras of the scene
    int cameraIndex = -1;               ///< -1: none of the scene's cameras
    Animation animation;

    std::string view = "composite";
    Beside beside = Beside::Nothing;
    std::string besideView = "scene";
    std::string besidePreset = "reference"; ///< empty: the current settings with `besideMarch`
    std::string besideMarch = "linear";
    Heat heat = Heat::None;
    float line = 0.5f; ///< position of the dividing line, fraction of the window's width
    double heatMean = 0;
    uint32_t besideFrames = 0;
    Zoom zoom;

    std::optional<glm::vec2> asked;         ///< the pixel to inspect, as UV
    bool askFollows = false;                ///< inspect the pixel under the mouse
    bool focusAsked = false;                ///< focus on the inspected point as soon as it is known
    std::optional<glm::vec2> materialAsked; ///< a click that chooses the material of this point, as UV
    std::optional<RayInspection> ray;
    render::View rayView; ///< view that the ray was traced in
    SecondCamera second;

    bool showSettings = true;
    bool showMaterials = false;
    bool showHelp = false;
    bool showTimes = false;
    bool showPalette = false;
    bool paletteOpens = false; ///< the palette opens in this frame
    bool showPanels = true;
    bool placePanels = true; ///< move panels to their default positions: the window is new, or has another size
    int palettePage = 0;
    std::string paletteText;
    int paletteChoice = 0;
    OpenPanel open;
    RecentFiles recent;
    std::string settingsText; ///< search text
    std::string fileText = "view.json";

    // Measurements.
    FrameFigures figures;
    TimeHistory history;
    render::RenderStats stats;
    std::vector<std::string> notes;
    uint32_t width = 0; ///< size of the picture as currently rendered
    uint32_t height = 0;
    uint32_t frames = 0;

    std::string message;
    bool messageIsError = false;
    double messageUntil = 0;
    std::string shaderError; ///< of the compiler or the device; kept until shaders are accepted again
    double now = 0;          ///< seconds since the start
    std::vector<Request> requests;

    void say(std::string text, bool isError = false) {
        message = std::move(text);
        messageIsError = isError;
        messageUntil = now + (isError ? 12 : 3);
    }
    void ask(Request::Kind kind, std::string text = {}) { requests.push_back({kind, std::move(text)}); }
};

} // namespace glint::view
