#include "lab/view/window.hpp"

#include "base/text.hpp"
#include "lab/view/lost_window.hpp"

#include <vulkan/vulkan.h>
// After Vulkan's header, so that GLFW declares its Vulkan functions.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace glint::view {
namespace {

std::string lastReason() {
    const char* reason = nullptr;
    glfwGetError(&reason);
    return reason ? printable(reason, 200) : "no reason given";
}

Modifiers modifiers(int bits) {
    return {(bits & GLFW_MOD_CONTROL) != 0, (bits & GLFW_MOD_SHIFT) != 0, (bits & GLFW_MOD_ALT) != 0};
}

std::vector<InputEvent>& eventsOf(GLFWwindow* window) {
    return *static_cast<std::vector<InputEvent>*>(glfwGetWindowUserPointer(window));
}

void onKey(GLFWwindow* window, int key, int, int action, int mods) {
    InputEvent event;
    event.kind = InputKind::Key;
    event.key = key;
    event.down = action != GLFW_RELEASE;
    event.repeated = action == GLFW_REPEAT;
    event.modifiers = modifiers(mods);
    // Systems differ in whether a modifier key's own event includes that modifier.
    if (key == GLFW_KEY_LEFT_CONTROL || key == GLFW_KEY_RIGHT_CONTROL)
        event.modifiers.control = event.down;
    else if (key == GLFW_KEY_LEFT_SHIFT || key == GLFW_KEY_RIGHT_SHIFT)
        event.modifiers.shift = event.down;
    else if (key == GLFW_KEY_LEFT_ALT || key == GLFW_KEY_RIGHT_ALT)
        event.modifiers.alt = event.down;
    eventsOf(window).push_back(std::move(event));
}

void onCharacter(GLFWwindow* window, unsigned int character) {
    InputEvent event;
    event.kind = InputKind::Text;
    event.character = character;
    eventsOf(window).push_back(std::move(event));
}

void onMove(GLFWwindow* window, double x, double y) {
    int width = 0, height = 0, pixelsX = 0, pixelsY = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixelsX, &pixelsY);
    if (width <= 0 || height <= 0)
        return;
    InputEvent event;
    event.kind = InputKind::Move;
    event.position = glm::vec2(x * pixelsX / width, y * pixelsY / height);
    eventsOf(window).push_back(std::move(event));
}

void onButton(GLFWwindow* window, int button, int action, int mods) {
    InputEvent event;
    event.kind = InputKind::Button;
    event.key = button;
    event.down = action != GLFW_RELEASE;
    event.modifiers = modifiers(mods);
    eventsOf(window).push_back(std::move(event));
}

void onScroll(GLFWwindow* window, double x, double y) {
    InputEvent event;
    event.kind = InputKind::Scroll;
    event.position = glm::vec2(x, y);
    eventsOf(window).push_back(std::move(event));
}

void onDrop(GLFWwindow* window, int count, const char** paths) {
    InputEvent event;
    event.kind = InputKind::Drop;
    event.files.assign(paths, paths + count);
    eventsOf(window).push_back(std::move(event));
}

void onClose(GLFWwindow* window) {
    InputEvent event;
    event.kind = InputKind::Close;
    eventsOf(window).push_back(std::move(event));
}

} // namespace

Result<std::unique_ptr<Window>> Window::create(const std::string& title, uint32_t width, uint32_t height) {
    if (!glfwInit())
        return makeError(ErrorCode::NotFound, "no display for a window ({}); `glint render` makes pictures without one",
                         lastReason());
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    // Shown when its loss is watched for: GLFW puts Xlib's own handler, which ends the program, back in place
    // meanwhile.
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* const made =
        glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
    if (!made) {
        const std::string reason = lastReason();
        glfwTerminate();
        return makeError(ErrorCode::NotFound, "no window can be opened ({}); `glint render` makes pictures without one",
                         reason);
    }
    std::unique_ptr<Window> window(new Window(made));
    window->listen();
    watchForLostWindow();
    glfwShowWindow(made);
    return window;
}

void Window::listen() {
    glfwSetWindowUserPointer(window_, &events_);
    glfwSetKeyCallback(window_, onKey);
    glfwSetCharCallback(window_, onCharacter);
    glfwSetCursorPosCallback(window_, onMove);
    glfwSetMouseButtonCallback(window_, onButton);
    glfwSetScrollCallback(window_, onScroll);
    glfwSetDropCallback(window_, onDrop);
    glfwSetWindowCloseCallback(window_, onClose);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

std::vector<const char*> Window::vulkanExtensions() const {
    uint32_t count = 0;
    const char** const names = glfwGetRequiredInstanceExtensions(&count);
    return names ? std::vector<const char*>(names, names + count) : std::vector<const char*>();
}

Result<VkSurfaceKHR> Window::makeSurface(VkInstance instance) const {
    VkSurfaceKHR surface = VK_NULL_HANDLE;
    if (const VkResult result = glfwCreateWindowSurface(instance, window_, nullptr, &surface); result != VK_SUCCESS)
        return makeError(ErrorCode::Unsupported, "Vulkan cannot draw into the window (VkResult {}, {})",
                         static_cast<int>(result), lastReason());
    return surface;
}

std::vector<InputEvent> Window::poll(double seconds) {
    if (seconds > 0)
        glfwWaitEventsTimeout(seconds);
    else
        glfwPollEvents();
    std::vector<InputEvent> events;
    events.swap(events_);
    return events;
}

glm::uvec2 Window::size() const {
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    const bool hidden = glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0;
    if (hidden || windowIsLost()) // a lost window's size is undefined
        return glm::uvec2(0);
    return glm::uvec2(std::max(width, 0), std::max(height, 0));
}

bool Window::lost() const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height); // a request that waits for its answer, or for the error
    return windowIsLost();
}

float Window::scale() const {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::max(y, 1.0f);
}

void Window::resize(uint32_t width, uint32_t height) {
    glfwSetWindowSize(window_, static_cast<int>(width), static_cast<int>(height));
}

void Window::minimize() {
    glfwIconifyWindow(window_);
}

void Window::restore() {
    glfwRestoreWindow(window_);
}

void Window::setTitle(const std::string& title) {
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::setClipboard(const std::string& text) {
    glfwSetClipboardString(window_, text.c_str());
}

std::string Window::clipboard() const {
    const char* const text = glfwGetClipboardString(window_);
    return text ? text : "";
}

} // namespace glint::view
