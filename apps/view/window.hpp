// The window, by GLFW: made, asked for what happened in it, and lent to Vulkan as a surface.
#pragma once

#include "base/result.hpp"
#include "gpu/api.hpp"
#include "input_event.hpp"

#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace glint::view {

class Window {
public:
    /// `width`, `height`  pixels. Errors: NotFound where there is no display; it points to `glint render`.
    static Result<std::unique_ptr<Window>> create(const std::string& title, uint32_t width, uint32_t height);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    /// What the instance must have for makeSurface.
    std::vector<const char*> vulkanExtensions() const;
    /// The caller's to destroy. Errors: Unsupported.
    Result<VkSurfaceKHR> makeSurface(VkInstance instance) const;

    /// What happened since the last call; waits at most `seconds` for something to happen.
    std::vector<InputEvent> poll(double seconds);
    glm::uvec2 size() const; ///< pixels; 0 x 0 while minimized or lost
    bool lost() const;       ///< something else has destroyed it; that shows as soon as it is asked for something
    float scale() const;     ///< how much larger than on an ordinary screen texts should be
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
