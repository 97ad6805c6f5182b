// The list of the stages that only some frames have. A new one is two lines here, its class and its shader.
#pragma once

#include "reflect/check/input_check.hpp"
#include "reflect/composite/ray_counts.hpp"
#include "reflect/composite/views.hpp"
#include "reflect/denoise/denoiser.hpp"
#include "reflect/inspect/inspector.hpp"
#include "reflect/rays/rays.hpp"
#include "reflect/refraction/refraction.hpp"
#include "reflect/resolve/lobe_mean.hpp"
#include "reflect/stage_list.hpp"
#include "reflect/trace/cone_picture.hpp"
#include "reflect/trace/transparents.hpp"

namespace glint::reflect {

using OptionalStages = StageList<ConePicture,      // trace/picture
                                 TransparentTrace, // trace/transparents
                                 LobeMean,         // resolve/lobe
                                 RaysSource,       // rays/...
                                 Denoiser,         // denoise/...
                                 Refraction,       // refraction/...
                                 RayCounts,        // composite/statistics
                                 Views,            // recordView
                                 Inspector,        // recordInspection
                                 InputChecker>;    // recordInputCheck

} // namespace glint::reflect
