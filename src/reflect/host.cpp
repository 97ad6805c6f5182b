#include "reflect/host.hpp"

#include <array>

namespace glint::reflect {
namespace {

struct InputImage {
    const char* name;
    HostImage GBuffer::*host;
    gpu::Image Inputs::*borrowed;
};

constexpr std::array<InputImage, 8> kInputImages = {{
    {"depth", &GBuffer::depth, &Inputs::depth},
    {"normal", &GBuffer::normal, &Inputs::normal},
    {"material", &GBuffer::material, &Inputs::material},
    {"baseColor", &GBuffer::baseColor, &Inputs::baseColor},
    {"litRadiance", &GBuffer::litRadiance, &Inputs::litRadiance},
    {"fallbackSpecular", &GBuffer::fallbackSpecular, &Inputs::fallbackSpecular},
    {"backDepth", &GBuffer::backDepth, &Inputs::backDepth},
    {"motion", &GBuffer::motion, &Inputs::motion},
}};

} // namespace

void Host::set(const GBuffer& stated, const EnvironmentMap& around) {
    gbuffer = stated;
    environment = around;
    images = {}; // new images may reuse handles of old ones
    lend();
    set_ = true;
}

void Host::lend() {
    for (const auto& [name, host, borrowed] : kInputImages)
        reflect::lend(images.*borrowed, gbuffer.*host, name);
    lendEnvironment();
    reflect::lend(images.environmentDiffuse, environment.diffuse, "environmentDiffuse", 1, 6);
}

void Host::lendEnvironment() {
    reflect::lend(images.environment, environment.cube, "environment", environment.mips, 6);
}

void Host::giveBack(gpu::Frame& frame) {
    for (const auto& [name, host, borrowed] : kInputImages)
        reflect::giveBack(frame, images.*borrowed, gbuffer.*host);
    reflect::giveBack(frame, images.environment, environment.cube);
    reflect::giveBack(frame, images.environmentDiffuse, environment.diffuse);
}

} // namespace glint::reflect
