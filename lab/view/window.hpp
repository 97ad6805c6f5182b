// The window, by GLFW: creates it, reads its events, and creates its Vulkan surface.
#pragma once

#include "base/result.hpp"
#include "gpu/api.hpp"
#include "lab/view/input_event.hpp"

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace glint::view {

class Window {
public:
    /// `width`, `height`  pixels. Errors: NotFound if there is no display; the message suggests `glint render`.
    static Result<std::unique_ptr<Window>> create(const std::string& title, uint32_t width, uint32_t height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// Returns the instance extensions that makeSurface requires.
    std::vector<const char*> vulkanExtensions() const;
    /// Returns a surface that the caller must destroy. Errors: Unsupported.
    Result<VkSurfaceKHR> makeSurface(VkInstance instance) const;

    /// Returns the events since the last call; waits at most `seconds` for an event.
    std::vector<InputEvent> poll(double seconds);
    glm::uvec2 size() const; ///< pixels; 0 x 0 while minimized or lost
    bool lost() const;       ///< another client has destroyed the window; asks the window system
    float scale() const;     ///< scale of texts relative to a standard-resolution screen
    void resize(uint32_t width, uint32_t height);
    void minimize();
    void restore();
    void setTitle(const std::string& title);
    void setClipboard(const std::string& text);
    std::string clipboard() const;

private:
    explicit Window(GLFWwindow* window) : window_(window) {}
    void listen();

    GLFWwindow* window_;
    std::vector<InputEvent> events_;
};

} // namespace glint::view
