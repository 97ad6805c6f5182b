// What the viewer knows and what the person has asked for: panels and keys read and write it, the loop (viewer.hpp)
// acts on it.
#pragma once

#include "frame_figures.hpp"
#include "open_list.hpp"
#include "orbit_camera.hpp"
#include "recent_files.hpp"
#include "render/run_job.hpp"
#include "second_camera.hpp"
#include "settings_model.hpp"
#include "time_history.hpp"

#include <optional>
#include <string>
#include <vector>

namespace glint::view {

/// What stands beside the picture, right of a line that can be dragged.
enum class Beside { Nothing, View, Settings };

/// Instead of the picture: how it differs from the one beside it.
enum class Heat { None, Difference, Flip };

struct Request {
    enum class Kind {
        Screenshot,      ///< of the window, into `text`
        Picture,         ///< of the scene alone, .png or .exr, into `text`
        Stats,           ///< what the help panel shows, into `text`
        Save,            ///< settings into `text`, the camera beside them
        Open,            ///< `text`: a scene, an environment, settings or a camera
        CopyCommandLine, ///< into the clipboard
        CopyRay,         ///< what `glint inspect` would print
        Capture,         ///< the next frame, by RenderDoc
        ReloadShaders,   ///< `text` "all": also those that have not changed
        Close,
    };
    Kind kind = Kind::Close;
    std::string text;
};

struct Animation {
    double seconds = 0; ///< into the scene's animations
    double length = 0;  ///< of the longest one; 0: there are none
    bool playing = false;
};

/// Single pixels in sight: the picture's pixel at the window's centre, and how many of the window's it is wide.
struct Zoom {
    float factor = 1; ///< 1: the whole picture
    glm::vec2 centerUV = glm::vec2(0.5f);
};

struct ViewerState {
    explicit ViewerState(SettingsModel model) : settings(std::move(model)) {}

    std::string scene; ///< as the command line has it
    SettingsModel settings;
    OrbitCamera camera;
    std::vector<scene::Camera> cameras; ///< the scene's own
    int cameraIndex = -1;               ///< -1: none of them
    Animation animation;

    std::string view = "composite";
    Beside beside = Beside::Nothing;
    std::string besideView = "scene";
    std::string besidePreset = "reference"; ///< empty: our settings with `besideMarch`
    std::string besideMarch = "linear";
    Heat heat = Heat::None;
    float line = 0.5f; ///< where the two meet, share of the window's width
    double heatMean = 0;
    uint32_t besideFrames = 0;
    Zoom zoom;

    std::optional<glm::vec2> asked; ///< the pixel to explain, as UV
    bool askFollows = false;        ///< the mouse
    bool focusAsked = false;        ///< turn to it as soon as it is known
    std::optional<RayInspection> ray;
    render::View rayView; ///< that it was asked in
    SecondCamera second;

    bool showSettings = true;
    bool showHelp = false;
    bool showTimes = false;
    bool showPalette = false;
    bool paletteOpens = false; ///< in this frame
    bool showPanels = true;
    bool placePanels = true; ///< where they belong: the window is new, or has another size
    int palettePage = 0;
    std::string paletteText;
    int paletteChoice = 0;
    OpenPanel open;
    RecentFiles recent;
    std::string settingsText; ///< what is searched for
    std::string fileText = "view.json";

    // Measured.
    FrameFigures figures;
    TimeHistory history;
    render::RenderStats stats;
    std::vector<std::string> notes;
    uint32_t width = 0; ///< of the picture as it is rendered now
    uint32_t height = 0;
    uint32_t frames = 0;

    std::string message;
    bool messageIsError = false;
    double messageUntil = 0;
    std::string shaderError; ///< of the compiler or the device; stays until shaders are taken again
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
