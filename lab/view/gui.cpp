#include "lab/view/gui.hpp"

#include "lab/view/font_file.hpp"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>

namespace glint::view {
namespace {

#if IMGUI_VERSION_NUM < 18700
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeyPadEnter;
#else
constexpr ImGuiKey kKeypadEnter = ImGuiKey_KeypadEnter;
#endif

/// The keys that ImGui uses.
constexpr std::array<std::pair<int, ImGuiKey>, 22> kKeys = {{
    {GLFW_KEY_TAB, ImGuiKey_Tab},
    {GLFW_KEY_LEFT, ImGuiKey_LeftArrow},
    {GLFW_KEY_RIGHT, ImGuiKey_RightArrow},
    {GLFW_KEY_UP, ImGuiKey_UpArrow},
    {GLFW_KEY_DOWN, ImGuiKey_DownArrow},
    {GLFW_KEY_PAGE_UP, ImGuiKey_PageUp},
    {GLFW_KEY_PAGE_DOWN, ImGuiKey_PageDown},
    {GLFW_KEY_HOME, ImGuiKey_Home},
    {GLFW_KEY_END, ImGuiKey_End},
    {GLFW_KEY_INSERT, ImGuiKey_Insert},
    {GLFW_KEY_DELETE, ImGuiKey_Delete},
    {GLFW_KEY_BACKSPACE, ImGuiKey_Backspace},
    {GLFW_KEY_SPACE, ImGuiKey_Space},
    {GLFW_KEY_ENTER, ImGuiKey_Enter},
    {GLFW_KEY_ESCAPE, ImGuiKey_Escape},
    {GLFW_KEY_KP_ENTER, kKeypadEnter},
    {GLFW_KEY_A, ImGuiKey_A},
    {GLFW_KEY_C, ImGuiKey_C},
    {GLFW_KEY_V, ImGuiKey_V},
    {GLFW_KEY_X, ImGuiKey_X},
    {GLFW_KEY_Y, ImGuiKey_Y},
    {GLFW_KEY_Z, ImGuiKey_Z},
}};

#if IMGUI_VERSION_NUM < 18700 // the program numbers keys, through a map

void prepareKeys(ImGuiIO& io) {
    for (const auto& [ours, theirs] : kKeys)
        io.KeyMap[theirs] = ours;
}

void feedKey(ImGuiIO& io, const InputEvent& event) {
    io.KeyCtrl = event.modifiers.control;
    io.KeyShift = event.modifiers.shift;
    io.KeyAlt = event.modifiers.alt;
    if (event.key >= 0 && event.key < IM_ARRAYSIZE(io.KeysDown))
        io.KeysDown[event.key] = event.down;
}

void feedMove(ImGuiIO& io, glm::vec2 position) {
    io.MousePos = {position.x, position.y};
}

void feedButton(ImGuiIO& io, const InputEvent& event) {
    if (event.key >= 0 && event.key < IM_ARRAYSIZE(io.MouseDown))
        io.MouseDown[event.key] = event.down;
}

void feedScroll(ImGuiIO& io, glm::vec2 notches) {
    io.MouseWheelH += notches.x;
    io.MouseWheel += notches.y;
}

#else

void prepareKeys(ImGuiIO&) {}

void feedKey(ImGuiIO& io, const InputEvent& event) {
    io.AddKeyEvent(ImGuiMod_Ctrl, event.modifiers.control);
    io.AddKeyEvent(ImGuiMod_Shift, event.modifiers.shift);
    io.AddKeyEvent(ImGuiMod_Alt, event.modifiers.alt);
    for (const auto& [ours, theirs] : kKeys)
        if (ours == event.key)
            io.AddKeyEvent(theirs, event.down);
}

void feedMove(ImGuiIO& io, glm::vec2 position) {
    io.AddMousePosEvent(position.x, position.y);
}

void feedButton(ImGuiIO& io, const InputEvent& event) {
    if (event.key >= 0 && event.key < ImGuiMouseButton_COUNT)
        io.AddMouseButtonEvent(event.key, event.down);
}

void feedScroll(ImGuiIO& io, glm::vec2 notches) {
    io.AddMouseWheelEvent(notches.x, notches.y);
}

#endif

void setLooks(float scale) {
    ImGui::StyleColorsDark();
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowRounding = 4;
    style.FrameRounding = 3;
    style.WindowBorderSize = 0;
    style.Colors[ImGuiCol_WindowBg].w = 0.88f; // the picture stays visible
    style.ScaleAllSizes(scale);
}

/// Loads a scalable font at the screen's scale; without one, enlarges ImGui's bitmap font.
void setFont(ImGuiIO& io, float scale) {
    constexpr float kHeight = 14; // pixels on an ordinary screen
    const std::string file = findFont(fontPlaces());
    if (!file.empty() && io.Fonts->AddFontFromFileTTF(file.c_str(), std::round(kHeight * scale)))
        return;
    io.FontGlobalScale = scale;
}

} // namespace

Gui::Gui(float scale, Clipboard clipboard) : clipboard_(std::move(clipboard)) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr; // write no file
    setFont(io, scale);
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* gui, const char* text) { static_cast<Gui*>(gui)->clipboard_.set(text); };
    io.GetClipboardTextFn = [](void* gui) {
        Gui& self = *static_cast<Gui*>(gui);
        self.pasted_ = self.clipboard_.get();
        return self.pasted_.c_str();
    };
    prepareKeys(io);
    setLooks(scale);
}

Gui::~Gui() {
    ImGui::DestroyContext();
}

void Gui::feed(const InputEvent& event) {
    ImGuiIO& io = ImGui::GetIO();
    switch (event.kind) {
    case InputKind::Key: feedKey(io, event); break;
    case InputKind::Text: io.AddInputCharacter(event.character); break;
    case InputKind::Move: feedMove(io, event.position); break;
    case InputKind::Button: feedButton(io, event); break;
    case InputKind::Scroll: feedScroll(io, event.position); break;
    case InputKind::Drop:
    case InputKind::Close: break;
    }
}

void Gui::begin(std::span<const InputEvent> events, glm::uvec2 size, double seconds) {
    ImGuiIO& io = ImGui::GetIO();
    for (const InputEvent& event : events)
        feed(event);
    io.DisplaySize = {static_cast<float>(size.x), static_cast<float>(size.y)};
    io.DeltaTime = std::max(static_cast<float>(seconds), 1e-4f);
    ImGui::NewFrame();
}

void Gui::end() {
    ImGui::Render();
}

bool Gui::wantsKeys() const {
    return ImGui::GetIO().WantTextInput;
}

bool Gui::wantsMouse() const {
    return ImGui::GetIO().WantCaptureMouse;
}

} // namespace glint::view
