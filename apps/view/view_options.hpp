// What `glint view` was asked for.
#pragma once

#include "render_options.hpp"

namespace glint::view {

struct ViewOptions {
    cli::RenderOptions scene;
    std::string view = "composite";
    std::string screenshot; ///< written after `scene.frames` frames, then the window closes
    std::string script;     ///< a file of input_script.hpp
};

} // namespace glint::view
