#include "lab/measure/bench/bench_check.hpp"

#include <algorithm>

namespace glint::measure {
namespace {

bool isSame(const BenchFigure& a, const BenchFigure& b) {
    return a.scene == b.scene && a.size == b.size && a.share == b.share && a.config == b.config;
}

} // namespace

std::vector<BenchFigure> figuresOf(const BenchResult& result) {
    std::vector<BenchFigure> figures;
    for (const BenchPoint& point : result.points)
        for (size_t i = 0; i < result.configs.size(); ++i)
            figures.push_back({point.scene,
                               {point.plan.width, point.plan.height},
                               point.plan.share,
                               result.configs[i],
                               point.figures[i].times.floorMultiple(),
                               point.figures[i].stats.lookupsPerRay});
    return figures;
}

void keepFaster(std::vector<BenchFigure>& best, const std::vector<BenchFigure>& again) {
    for (BenchFigure& figure : best)
        for (const BenchFigure& other : again)
            if (isSame(figure, other))
                figure.floors = std::min(figure.floors, other.floors);
}

Result<std::vector<CheckedFigure>> checkFigures(const BenchBase& base, const std::vector<BenchFigure>& now,
                                                std::string_view device, const BenchTolerance& tolerance) {
    std::vector<CheckedFigure> checked;
    for (const BenchFigure& figure : base.figures) {
        const auto found = std::ranges::find_if(now, [&](const BenchFigure& other) { return isSame(figure, other); });
        if (found == now.end())
            return makeError(ErrorCode::NotFound, "{} at {}x{}, {}: the base has it, but it was not measured",
                             figure.scene, figure.size.x, figure.size.y, figure.config);
        checked.push_back({figure, *found,
                           device == base.device && found->floors > figure.floors * (1 + tolerance.floors),
                           found->lookups > figure.lookups * (1 + tolerance.lookups)});
    }
    return checked;
}

} // namespace glint::measure
