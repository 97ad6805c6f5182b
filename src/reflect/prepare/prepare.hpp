// `prepare`: converts the host's G-buffer from its conventions to viewZ, packed surfaces, F0 and back faces.
#pragma once

#include "reflect/stage.hpp"
#include "reflect/stages.hpp"

#include <functional>

namespace glint::reflect {

class Prepare {
public:
    using Bind = std::function<void(gpu::Pass&)>; ///< binds more to a pass

    static Result<std::unique_ptr<Prepare>> create(StageContext& stages);

    /// Compiles and allocates what the plan needs: edges with several samples per pixel, and back faces in their own
    /// size. Errors: OutOfMemory, Unsupported.
    Result<void> make();

    /// Initializes images that may be read before they are written.
    void clear(gpu::Frame& frame);
    void rehearse(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ);
    /// Writes `viewZ` and the images of `prepared`, except back faces.
    void record(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ) {
        recordSurface(frame, inputs, viewZ, passFor(inputs.host.depth.desc().samples > 1));
    }
    /// The same with the work of trace/classify, whose outputs `bindClasses` binds. For hosts with one sample per
    /// pixel.
    void recordClassified(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ, const Bind& bindClasses) {
        recordSurface(frame, inputs, viewZ, classifiedPass_, bindClasses);
    }
    /// Writes the back faces once the presence of rays is known: `rays` contains the number of groups to dispatch.
    /// Nothing to do where they are read in place.
    void recordBackFaces(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ, Rays& rays);

    Prepared prepared(Host& host, gpu::Image& viewZ);
    /// Group counts of the pass that recordBackFaces records, and of that for transparent surfaces.
    glm::uvec2 backFaceGroups() const;

private:
    explicit Prepare(StageContext& stages) : stages_(stages) {}
    glm::uvec2 sizeIf(bool needed) const;
    Result<void> makeMaterial(bool resolves);
    Result<void> makeBackFaces(bool wanted);
    Result<void> makeEdge(bool manySamples);
    Result<void> makeCoat();
    gpu::Pipeline& passFor(bool manySamples);
    bool hasCoats() const { return stages_.plan.coat && coatSurface_; }
    void recordSurface(gpu::Frame& frame, const FrameInputs& inputs, gpu::Image& viewZ, gpu::Pipeline& pipeline,
                       const Bind& bindMore = {});

    StageContext& stages_;
    gpu::Pipeline surfacePass_;
    gpu::Pipeline classifiedPass_;
    gpu::Pipeline surfaceSamplesPass_; ///< for hosts with several samples per pixel
    gpu::Pipeline coatedPass_;         ///< these two for hosts that state a clear coat
    gpu::Pipeline coatedSamplesPass_;
    gpu::Pipeline backFacesPass_;
    gpu::Image surface_;
    gpu::Image resolvedMaterial_; ///< RGBA16F: F0, coverage; one texel where the host's own image holds F0
    gpu::Image edge_;
    gpu::Image coatSurface_; ///< RG32UI: Prepared::otherLobe; absent until a host states a clear coat
    gpu::Image backViewZ_;
    gpu::Standing blank_;       ///< edge_ and backViewZ_ are initialized
    gpu::Standing noBackFaces_; ///< backViewZ_ is cleared
};

} // namespace glint::reflect
