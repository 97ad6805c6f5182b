#include "lab/measure/truth/comparison.hpp"

#include "lab/measure/truth/compared_view.hpp"

namespace glint::measure {

Result<Comparison> compareConfigs(gpu::Context& context, const std::vector<ComparedConfig>& configs,
                                  const std::optional<ComparedConfig>& reference, uint32_t frames,
                                  const std::function<void(const std::string&)>& progress, uint32_t seeds) {
    GLINT_TRY(view, ComparedView::open(context, configs.front().job));
    Comparison result;
    result.scene = configs.front().job.scene;
    result.width = view.width();
    result.height = view.height();
    result.device = context.info().name;
    result.driver = context.info().driver;
    result.software = context.info().software;
    result.noExact = view.noExact();
    if (reference) {
        if (progress)
            progress(reference->name);
        result.reference = reference->name;
        GLINT_TRY(images, view.drawReference(*reference));
        view.setReference(images);
        result.referencePicture = std::move(images.displayed);
    }
    for (const ComparedConfig& config : configs) {
        if (progress)
            progress(config.name);
        GLINT_TRY(figures, view.measure(config, {.frames = frames, .seeds = seeds}));
        result.configs.push_back(std::move(figures));
    }
    result.withoutReflections = view.withoutReflections();
    return result;
}

} // namespace glint::measure
