#include "exact_report.hpp"

#include "render/job_inputs.hpp"
#include "render/view.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace glint::cli {

Result<measure::MirrorError> measureExact(const render::RenderJob& job, const render::RenderResult& result) {
    const auto composite = std::ranges::find(result.views, "composite", &render::RenderedView::name);
    if (composite == result.views.end())
        return invalidArgument("measure.exact compares the view composite: add it to --view");
    GLINT_TRY(inputs, render::loadJobInputs(job));
    const render::View view = render::makeView(inputs.camera, result.width, result.height);
    GLINT_TRY(exact, measure::exactPicture(*inputs.scene, inputs.pose, view.worldToClip, result.width, result.height));
    return measure::compareMirrors(exact, composite->rgba);
}

nlohmann::ordered_json exactJson(const measure::MirrorError& error) {
    nlohmann::ordered_json byBounces = nlohmann::ordered_json::array();
    for (size_t i = 0; i < error.byBounces.size(); ++i)
        byBounces.push_back(
            {{"bounces", i + 1}, {"pixels", error.byBounces[i].pixels}, {"wrong", error.byBounces[i].wrong}});
    return {{"mirrorPixels", error.mirrorPixels},
            {"wrongPixels", error.wrongPixels},
            {"wrongShare", error.share()},
            {"oneBouncePixels", error.oneBouncePixels},
            {"oneBounceWrong", error.oneBounceWrong},
            {"oneBounceWrongShare", error.oneBounceShare()},
            {"byBounces", byBounces}};
}

} // namespace glint::cli
