// The host's side of a frame: its images, wrapped for barriers, and the conventions that it declares.
#pragma once

#include "glint/reflections.hpp"
#include "reflect/host_image.hpp"

#include <array>

namespace glint::reflect {

/// The host's images, borrowed.
struct Inputs {
    gpu::Image depth;
    gpu::Image normal;
    gpu::Image material;  ///< may be absent
    gpu::Image baseColor; ///< may be absent
    gpu::Image litRadiance;
    gpu::Image fallbackSpecular;   ///< may be absent
    gpu::Image backDepth;          ///< may be absent; own size
    gpu::Image transparentDepth;   ///< may be absent
    gpu::Image motion;             ///< may be absent
    gpu::Image environment;        ///< cube; may be absent
    gpu::Image environmentDiffuse; ///< cube; may be absent
    gpu::Image coatNormal;         ///< may be absent
    // Images of the material's scalars; absent where an image above holds the scalar, or no image does.
    gpu::Image roughness;
    gpu::Image metallic;
    gpu::Image specular;
    gpu::Image occlusion;
    gpu::Image f90;
    gpu::Image coat;
    gpu::Image coatRoughness;

    /// A scalar's number: its place in kMaterialScalars (gbuffer_images.hpp).
    static constexpr size_t kScalars = 7;
    enum Scalar : uint8_t { Roughness, Metallic, Specular, Occlusion, F90, Coat, CoatRoughness };
    /// The image that holds each scalar; null: it is read from no image.
    std::array<gpu::Image Inputs::*, kScalars> scalars = {};
    /// The image that holds the scalar, otherwise `absent`, which is then not read.
    gpu::Image& scalar(Scalar which, gpu::Image& absent) { return scalars[which] ? this->*scalars[which] : absent; }
};

/// True if the host states something else than `constant`, which the scalar has without a statement.
inline bool isStated(const MaterialChannel& scalar, float constant) {
    return scalar.scale != 0 || scalar.bias != constant;
}

/// True if the host states F90, which is 1 otherwise.
inline bool statesF90(const GBuffer& gbuffer) {
    return isStated(gbuffer.f90, 1) && gbuffer.conventions.material != MaterialKind::Standard;
}

inline bool hasCoat(const GBuffer& gbuffer) {
    return isStated(gbuffer.coat, 0);
}

/// True if F0, F90 and coverage must be computed: the host's material image does not hold them.
inline bool resolvesMaterial(const GBuffer& gbuffer) {
    return gbuffer.depth.samples > 1 || gbuffer.conventions.material != MaterialKind::F0Roughness || statesF90(gbuffer);
}

class Host {
public:
    GBuffer gbuffer;
    EnvironmentMap environment;
    Inputs images;

    bool isSet() const { return set_; }
    void set(const GBuffer& stated, const EnvironmentMap& around);
    /// Resets the images to the state that the host declares, as the host's own passes may have written them.
    void lend();
    /// As lend, for the environment alone: for layers.
    void lendEnvironment();
    /// Returns every image to the layout that the host declares.
    void giveBack(gpu::Frame& frame);

    const Conventions& conventions() const { return gbuffer.conventions; }
    bool hasManySamples() const { return images.depth.desc().samples > 1; }
    /// True if F0 and coverage must be read from Prepared::material instead of the host's image.
    bool resolvesMaterial() const { return reflect::resolvesMaterial(gbuffer); }

private:
    gpu::Image Inputs::*holderOf(size_t scalar) const;

    bool set_ = false;
};

} // namespace glint::reflect
