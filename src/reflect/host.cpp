#include "reflect/host.hpp"

#include "reflect/gbuffer_images.hpp"

namespace glint::reflect {

void Host::set(const GBuffer& stated, const EnvironmentMap& around) {
    gbuffer = stated;
    environment = around;
    images = {}; // new images may reuse handles of old ones
    lend();
    set_ = true;
}

void Host::lend() {
    for (const GBufferImage& image : kGBufferImages)
        reflect::lend(images.*image.borrowed, gbuffer.*image.host, image.name);
    lendEnvironment();
    reflect::lend(images.environmentDiffuse, environment.diffuse, "environmentDiffuse", 1, 6);
}

void Host::lendEnvironment() {
    reflect::lend(images.environment, environment.cube, "environment", environment.mips, 6);
}

void Host::giveBack(gpu::Frame& frame) {
    for (const GBufferImage& image : kGBufferImages)
        reflect::giveBack(frame, images.*image.borrowed, gbuffer.*image.host);
    reflect::giveBack(frame, images.environment, environment.cube);
    reflect::giveBack(frame, images.environmentDiffuse, environment.diffuse);
}

} // namespace glint::reflect
