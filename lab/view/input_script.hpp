// Scripted input: lines that drive the viewer with keys and mouse, for tests and for images in documentation.
#pragma once

#include "base/result.hpp"
#include "lab/view/key_names.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace glint::view {

/// One line of a script. docs/viewer.md has the same list.
struct ScriptStep {
    enum class Kind {
        Frame,       ///< frame N: lets N frames pass
        Still,       ///< still: waits until the picture is complete at full size
        Quiet,       ///< quiet: ends the message that the bar shows, unless it is an error
        Key,         ///< key Ctrl+P: presses and releases
        Press,       ///< press W
        Release,     ///< release W
        Type,        ///< type some words
        Move,        ///< move X Y: pixels from the top left
        Click,       ///< click X Y: with the left button
        DoubleClick, ///< doubleclick X Y
        Drag,        ///< drag X Y X2 Y2 [right|middle]
        Scroll,      ///< scroll N: notches, away from the user
        Resize,      ///< resize W H
        Minimize,    ///< minimize
        Restore,     ///< restore
        Drop,        ///< drop FILE
        Screenshot,  ///< screenshot FILE.png: the window with its panels
        Picture,     ///< picture FILE.png|.exr: the picture alone, as `glint render` writes it
        Save,        ///< save FILE.json: settings, and beside them FILE.camera.json
        Stats,       ///< stats FILE.json: what the help panel shows
        Close,       ///< close
    };
    Kind kind = Kind::Frame;
    int line = 0;
    KeyStroke stroke;
    std::vector<int> numbers;
    std::string text; ///< typed text, a file, or a button's name
};

/// Empty lines and lines that begin with # are comments. Errors: InvalidInput, "name:line: ...".
Result<std::vector<ScriptStep>> readScript(std::string_view text, std::string_view name);

} // namespace glint::view
