#include "lab/cli/compare/exact_report.hpp"

#include <nlohmann/json.hpp>

namespace glint::cli {

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
            {"oneBounceWrongInFrameShare", error.inFrameShare()},
            {"oneBounceUnseenShare", error.unseenShare()},
            {"byBounces", byBounces}};
}

} // namespace glint::cli
