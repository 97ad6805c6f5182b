// What `glint view` was asked for.
#pragma once

#include "render_options.hpp"

namespace glint::view {

struct ViewOptions {
    cli::RenderOptions scene;
    std::string view = "composite";
    std::string screenshot; ///< written after `scene.frames` frames, then the window closes
    std::string script;     ///< a file of input_script.hpp
    std::string shaders;    ///< a folder of shader sources to follow (shader_reload.hpp); empty: none
};

} // namespace glint::view
