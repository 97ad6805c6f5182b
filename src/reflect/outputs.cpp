#include "reflect/outputs.hpp"

#include "reflect/host_image.hpp"

namespace glint::reflect {
namespace {

constexpr VkFormat kHalf = VK_FORMAT_R16G16B16A16_SFLOAT;

} // namespace

Result<void> OutputImages::set(const Outputs& outputs) {
    if (!outputs.composite && !outputs.reflection)
        GLINT_CHECK(
            makeImage(stages_.gpu, own_, {"glint/composite", kHalf, stages_.width(), stages_.height(), kShown}));
    else
        stages_.retired.keep(std::move(own_));
    stated_ = outputs;
    hosts_ = {}; // new images may reuse handles of old ones
    lend();
    return {};
}

Result<void> OutputImages::makePrevious() {
    if (previous_)
        return {};
    GLINT_TRY(copy, gpu::Pipeline::compute(stages_.gpu, {"prefilter/picture", 0, {}}));
    copy_ = std::move(copy);
    return makeImage(stages_.gpu, previous_, {"glint/previous", kHalf, stages_.width(), stages_.height()});
}

void OutputImages::lend() {
    reflect::lend(hosts_.composite, stated_.composite, "composite");
    reflect::lend(hosts_.reflection, stated_.reflection, "reflection");
}

void OutputImages::giveBack(gpu::Frame& frame) {
    reflect::giveBack(frame, hosts_.composite, stated_.composite);
    reflect::giveBack(frame, hosts_.reflection, stated_.reflection);
}

void OutputImages::handOut(gpu::Frame& frame) {
    giveBack(frame);
    if (own_)
        frame.hand(own_, kHandedOut);
}

void OutputImages::remember(gpu::Frame& frame) {
    frame.scope("composite/remember", [&] {
        frame.untimed([&] {
            frame.pass(copy_)
                .read("picture", composite(), kTexels)
                .write("copy", previous_)
                .dispatch(stages_.width(), stages_.height());
        });
    });
}

HostImage OutputImages::result() const {
    if (own_)
        return reflect::handOut(own_);
    HostImage host = stated_.composite ? stated_.composite : stated_.reflection;
    host.stages = kHandedOut.stages;
    host.access = VK_ACCESS_2_NONE;
    return host;
}

} // namespace glint::reflect
