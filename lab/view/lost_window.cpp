#include "lab/view/lost_window.hpp"

#include <dlfcn.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace glint::view {
namespace {

bool lost = false; // global, as Xlib's handlers get no user data

/// The head of XErrorEvent (Xlib.h, "Using the Default Error Handlers" in Xlib - C Language X Interface, 11.8.2):
/// declared here because only GLFW needs Xlib's headers.
struct XError {
    int type;
    void* display;
    unsigned long resource;
    unsigned long serial;
    unsigned char code;
};

constexpr unsigned char kBadWindow = 3, kBadDrawable = 9;

/// Other failed X requests are ignored.
int onError(void*, XError* error) {
    lost = lost || error->code == kBadWindow || error->code == kBadDrawable;
    return 0;
}

/// Xlib exits if this returns; _Exit skips destructors, which would talk to the lost server.
int onServerGone(void*) {
    constexpr std::string_view kText =
        "glint: error: the connection to the display is gone: its server ended, or has thrown this program out\n";
    [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, kText.data(), kText.size());
    std::_Exit(1);
}

} // namespace

void watchForLostWindow() {
    void* const xlib = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (!xlib)
        return;
    using SetErrorHandler = void* (*)(int (*)(void*, XError*));
    using SetServerGoneHandler = void* (*)(int (*)(void*));
    if (const auto set = reinterpret_cast<SetErrorHandler>(dlsym(xlib, "XSetErrorHandler")))
        set(onError);
    if (const auto set = reinterpret_cast<SetServerGoneHandler>(dlsym(xlib, "XSetIOErrorHandler")))
        set(onServerGone);
}

bool windowIsLost() {
    return lost;
}

} // namespace glint::view
