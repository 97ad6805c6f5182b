// Handles the loss of a window on X11: another client destroys the window, or the server ends. Xlib's default is to end
// the program immediately.
#pragma once

namespace glint::view {

/// After this call, a destroyed window is detected (windowIsLost). If the server is gone, the program ends with 1 and
/// one line of error, as nothing can be shown or queried any more. Does nothing without X11.
void watchForLostWindow();
/// True if an X request has failed since then because the window no longer exists.
bool windowIsLost();

} // namespace glint::view
