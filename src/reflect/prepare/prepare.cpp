#include "reflect/prepare/prepare.hpp"

#include "shared/trace_constants.h"

namespace glint::reflect {

Result<std::unique_ptr<Prepare>> Prepare::create(StageContext& stages) {
    std::unique_ptr<Prepare> prepare(new Prepare(stages));
    using gpu::Compile, gpu::Pipeline;
    GLINT_TRY(surface, Pipeline::compute(stages.gpu, {"prepare/surface", 0, {}}, Compile::Later));
    GLINT_TRY(classified, Pipeline::compute(stages.gpu, {"prepare/classified", 0, {}}, Compile::Later));
    GLINT_TRY(surfaceSamples, Pipeline::compute(stages.gpu, {"prepare/surface_samples", 0, {}}, Compile::Later));
    GLINT_TRY(coated, Pipeline::compute(stages.gpu, {"prepare/coated", 0, {}}, Compile::Later));
    GLINT_TRY(coatedSamples, Pipeline::compute(stages.gpu, {"prepare/coated_samples", 0, {}}, Compile::Later));
    GLINT_TRY(backFaces, Pipeline::compute(stages.gpu, {"prepare/back_faces", 0, {}}, Compile::Later));
    prepare->surfacePass_ = std::move(surface);
    prepare->classifiedPass_ = std::move(classified);
    prepare->surfaceSamplesPass_ = std::move(surfaceSamples);
    prepare->coatedPass_ = std::move(coated);
    prepare->coatedSamplesPass_ = std::move(coatedSamples);
    prepare->backFacesPass_ = std::move(backFaces);
    const uint32_t w = stages.width();
    const uint32_t h = stages.height();
    GLINT_CHECK(makeImage(stages.gpu, prepare->surface_, {"glint/surface", VK_FORMAT_R32G32_UINT, w, h}));
    GLINT_CHECK(prepare->makeMaterial(false));
    GLINT_CHECK(prepare->makeBackFaces(false));
    GLINT_CHECK(prepare->makeEdge(false));
    return prepare;
}

Result<void> Prepare::make() {
    const FramePlan& plan = stages_.plan;
    const bool converts = plan.backFaces && !plan.backFacesInPlace;
    if (!plan.manySamples && !plan.coat)
        GLINT_CHECK((plan.classifiesEarly ? classifiedPass_ : surfacePass_).compile());
    if (converts)
        GLINT_CHECK(backFacesPass_.compile());
    GLINT_CHECK(makeEdge(plan.manySamples));
    if (plan.coat)
        GLINT_CHECK(makeCoat());
    GLINT_CHECK(makeMaterial(plan.resolvesMaterial));
    return makeBackFaces(converts);
}

/// The size of an image that is needed, and of one that is only bound.
glm::uvec2 Prepare::sizeIf(bool needed) const {
    return needed ? glm::uvec2(stages_.width(), stages_.height()) : glm::uvec2(1);
}

Result<void> Prepare::makeMaterial(bool resolves) {
    const glm::uvec2 size = sizeIf(resolves);
    GLINT_CHECK(
        growImage(stages_, resolvedMaterial_, {"glint/material", VK_FORMAT_R16G16B16A16_SFLOAT, size.x, size.y}));
    return {};
}

/// If not wanted, an existing image is kept, cleared.
Result<void> Prepare::makeBackFaces(bool wanted) {
    const glm::uvec2 size = sizeIf(wanted);
    GLINT_TRY(made, growImage(stages_, backViewZ_,
                              {"glint/backViewZ", VK_FORMAT_R32_SFLOAT, size.x, size.y,
                               kCleared | VK_IMAGE_USAGE_TRANSFER_SRC_BIT}));
    if (made) {
        blank_.ask();
        noBackFaces_.ask();
    }
    return {};
}

Result<void> Prepare::makeEdge(bool manySamples) {
    if (manySamples && !stages_.plan.coat)
        GLINT_CHECK(surfaceSamplesPass_.compile());
    const glm::uvec2 size = sizeIf(manySamples);
    GLINT_TRY(made, growImage(stages_, edge_, {"glint/edge", VK_FORMAT_R32G32B32A32_UINT, size.x, size.y, kCleared}));
    if (made)
        blank_.ask();
    return {};
}

Result<void> Prepare::makeCoat() {
    GLINT_CHECK(passFor(stages_.plan.manySamples).compile());
    return makeImage(stages_.gpu, coatSurface_,
                     {"glint/coatSurface", VK_FORMAT_R32G32_UINT, stages_.width(), stages_.height()});
}

gpu::Pipeline& Prepare::passFor(bool manySamples) {
    if (stages_.plan.coat)
        return manySamples ? coatedSamplesPass_ : coatedPass_;
    return manySamples ? surfaceSamplesPass_ : surfacePass_;
}

void Prepare::clear(gpu::Frame& frame) {
    if (frame.rehearsing() || !blank_.isNeeded(stages_.progress))
        return;
    frame.clear(edge_, {});
    frame.clear(backViewZ_, {.float32 = {shared::kBackgroundZ}});
    blank_.recorded(stages_.progress);
}

void Prepare::rehearse(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ) {
    recordSurface(frame, inputs, viewZ, surfacePass_);
    recordSurface(frame, inputs, viewZ, surfaceSamplesPass_);
    recordSurface(frame, inputs, viewZ, coatedPass_);
    recordSurface(frame, inputs, viewZ, coatedSamplesPass_);
    Rays none;
    recordBackFaces(frame, inputs, viewZ, none);
}

void Prepare::recordSurface(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ, gpu::Pipeline& pipeline,
                            const Bind& bindMore) {
    // Absent images are not read: any image with the same sample count can be bound instead.
    Inputs& host = inputs.host;
    gpu::Image& material = host.material ? host.material : host.normal;
    gpu::Pass pass = frame.pass(pipeline);
    pass.read("frame", inputs.constants)
        .read("depth", host.depth, kTexels)
        .read("normal", host.normal, kTexels)
        .read("material", material, kTexels)
        .read("baseColor", host.baseColor ? host.baseColor : material, kTexels)
        .read("roughness", host.scalar(Inputs::Roughness, material), kTexels)
        .read("metallic", host.scalar(Inputs::Metallic, material), kTexels)
        .read("specular", host.scalar(Inputs::Specular, material), kTexels)
        .read("f90", host.scalar(Inputs::F90, material), kTexels)
        .write("viewZ", viewZ)
        .write("surface", surface_)
        .write("resolvedMaterial", resolvedMaterial_);
    if (&pipeline == &surfaceSamplesPass_ || &pipeline == &coatedSamplesPass_)
        pass.write("edge", edge_);
    if (&pipeline == &coatedPass_ || &pipeline == &coatedSamplesPass_)
        pass.read("coat", host.scalar(Inputs::Coat, material), kTexels)
            .read("coatRoughness", host.scalar(Inputs::CoatRoughness, material), kTexels)
            .read("coatNormal", host.coatNormal ? host.coatNormal : host.normal, kTexels)
            .write("coatSurface", coatSurface_);
    if (bindMore)
        bindMore(pass);
    pass.dispatch(stages_.extent.x, stages_.extent.y);
}

void Prepare::recordBackFaces(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ, Rays& rays) {
    if ((stages_.plan.backFaces && !stages_.plan.backFacesInPlace) || frame.rehearsing()) {
        frame.pass(backFacesPass_)
            .read("frame", inputs.constants)
            .read("backDepth", inputs.host.backDepth, kTexels)
            .read("viewZ", viewZ)
            .read("resolvedMaterial", resolvedMaterial_)
            .read("edge", edge_)
            .write("backViewZ", backViewZ_)
            .dispatchIndirect(rays.list, offsetof(shared::RayListHeader, backFaceGroups));
        noBackFaces_.ask();
    } else if (!stages_.plan.backFacesInPlace && noBackFaces_.isNeeded(stages_.progress)) {
        frame.clear(backViewZ_, {.float32 = {shared::kBackgroundZ}});
        noBackFaces_.recorded(stages_.progress);
    }
}

Prepared Prepare::prepared(Host& host, gpu::Image& viewZ) {
    return {viewZ,
            surface_,
            host.resolvesMaterial() ? resolvedMaterial_ : host.images.material,
            edge_,
            stages_.plan.backFacesInPlace ? host.images.backDepth : backViewZ_,
            stages_.plan.backFaces,
            stages_.plan.backFacesInPlace,
            hasCoats() ? coatSurface_ : surface_};
}

glm::uvec2 Prepare::backFaceGroups() const {
    const uint32_t* local = backFacesPass_.localSize();
    const glm::uvec2 pixels = stages_.plan.backFaces ? stages_.extent : glm::uvec2(1); // otherwise no pass runs
    return {(pixels.x + local[0] - 1) / local[0], (pixels.y + local[1] - 1) / local[1]};
}

} // namespace glint::reflect
