// The view ray of a background pixel.
#ifndef GLINT_RENDER_BACKGROUND_RAY_GLSL
#define GLINT_RENDER_BACKGROUND_RAY_GLSL

#include "shared/render_view.h"

layout(scalar, set = 0, binding = 0) uniform ViewBlock {
    RenderView constants;
} view;

layout(location = 0) in vec2 ndc;

/// Unit.
vec3 viewRay() {
    if (view.constants.orthographic != 0u)
        return view.constants.cameraForwardWS;
    vec4 nearWS = view.constants.clipToWorld * vec4(ndc, 1.0, 1.0);
    return normalize(nearWS.xyz / nearWS.w - view.constants.cameraPositionWS);
}

#endif
