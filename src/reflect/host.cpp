#include "reflect/host.hpp"

#include "reflect/gbuffer_images.hpp"

namespace glint::reflect {

void Host::set(const GBuffer& stated, const EnvironmentMap& around) {
    gbuffer = stated;
    environment = around;
    images = {}; // new images may reuse handles of old ones
    for (size_t i = 0; i < kMaterialScalars.size(); ++i)
        images.scalars[i] = holderOf(i);
    lend();
    set_ = true;
}

/// An image that several statements name is borrowed once, so that its barriers are recorded once.
gpu::Image Inputs::*Host::holderOf(size_t scalar) const {
    const MaterialScalar& wanted = kMaterialScalars[scalar];
    if (!wanted.isRead(gbuffer))
        return nullptr;
    const HostImage& image = wanted.image(gbuffer);
    for (const GBufferImage& known : kGBufferImages)
        if (isSameImage(gbuffer.*known.host, image))
            return known.borrowed;
    for (size_t i = 0; i < scalar; ++i)
        if (images.scalars[i] && isSameImage(kMaterialScalars[i].image(gbuffer), image))
            return images.scalars[i];
    return wanted.own;
}

void Host::lend() {
    for (const GBufferImage& image : kGBufferImages)
        reflect::lend(images.*image.borrowed, gbuffer.*image.host, image.name);
    for (size_t i = 0; i < kMaterialScalars.size(); ++i)
        if (const MaterialScalar& scalar = kMaterialScalars[i]; images.scalars[i] == scalar.own)
            reflect::lend(images.*scalar.own, scalar.image(gbuffer), scalar.name);
    lendEnvironment();
    reflect::lend(images.environmentDiffuse, environment.diffuse, "environmentDiffuse", 1, 6);
}

void Host::lendEnvironment() {
    reflect::lend(images.environment, environment.cube, "environment", environment.mips, 6);
}

void Host::giveBack(gpu::Frame& frame) {
    for (const GBufferImage& image : kGBufferImages)
        reflect::giveBack(frame, images.*image.borrowed, gbuffer.*image.host);
    for (const MaterialScalar& scalar : kMaterialScalars)
        reflect::giveBack(frame, images.*scalar.own, scalar.image(gbuffer));
    reflect::giveBack(frame, images.environment, environment.cube);
    reflect::giveBack(frame, images.environmentDiffuse, environment.diffuse);
}

} // namespace glint::reflect
