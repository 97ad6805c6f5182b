#include "lab/measure/truth/job_exact.hpp"

#include "lab/job/job_inputs.hpp"
#include "lab/renderer/view.hpp"

#include <algorithm>

namespace glint::measure {

Result<MirrorError> measureExact(const render::RenderJob& job, const render::RenderResult& result) {
    const auto composite = std::ranges::find(result.views, "composite", &render::RenderedView::name);
    if (composite == result.views.end())
        return invalidArgument("measure.exact compares the view composite: add it to --view");
    GLINT_TRY(inputs, render::loadJobInputs(job));
    const render::View view = render::makeView(inputs.camera, result.width, result.height);
    GLINT_TRY(exact, exactPicture(*inputs.scene, inputs.pose, view.worldToClip, result.width, result.height));
    return compareMirrors(exact, composite->rgba);
}

} // namespace glint::measure
