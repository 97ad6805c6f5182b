// What happens to a window on X11 that nobody here asked for: something else destroys it, or the server ends. Xlib's
// own answer is to end the program in the middle of whatever it does.
#pragma once

namespace glint::view {

/// From here on a destroyed window is noticed (windowIsLost), and a server that is gone ends the program with 1 and one
/// line: nothing can be shown or asked any more. Does nothing without X11.
void watchForLostWindow();
/// Since then an X request has failed because the window is not there any more.
bool windowIsLost();

} // namespace glint::view
