// The options of `glint view`.
#pragma once

#include "lab/cli/render/render_options.hpp"

namespace glint::view {

struct ViewOptions {
    cli::RenderOptions scene;
    std::string view = "composite";
    std::string screenshot; ///< file written after `scene.frames` frames; the window then closes
    std::string script;     ///< script file (input_script.hpp)
    std::string shaders;    ///< folder of shader sources to watch (shader_reload.hpp); empty: none
};

} // namespace glint::view
