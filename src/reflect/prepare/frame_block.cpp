#include "reflect/prepare/frame_block.hpp"

#include "reflect/prepare/conventions.hpp"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>

namespace glint::reflect {

Result<FrameBlock> FrameBlock::create(StageContext& stages) {
    FrameBlock block(stages);
    GLINT_TRY(buffer,
              gpu::Buffer::create(stages.gpu, {"glint/frame", sizeof(FrameBlockValues),
                                               VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               gpu::BufferHome::Device}));
    block.buffer_ = std::move(buffer);
    return block;
}

void FrameBlock::begin(const View& view, const Host& host) {
    before_ = values_.constants;
    const shared::FrameConstants now =
        makeFrameConstants(view, host.conventions(), stages_->extent.x, stages_->extent.y);
    values_.constants = now;
    const GBuffer& gbuffer = host.gbuffer;
    const auto channel = [](const MaterialChannel& stated) {
        return shared::HostChannel{stated.channel, stated.scale, stated.bias};
    };
    values_.constants.roughness = channel(gbuffer.roughness);
    values_.constants.metallic = channel(gbuffer.metallic);
    values_.constants.specular = channel(gbuffer.specular);
    values_.constants.occlusion = channel(gbuffer.occlusion);
    values_.constants.f90 = channel(gbuffer.f90);
    values_.constants.coat = channel(gbuffer.coat);
    values_.constants.coatRoughness = channel(gbuffer.coatRoughness);
    sameProjection_ = ((now.flags ^ before_.flags) & shared::kInputOrthographic) == 0;
    sameView_ = now.worldToView == before_.worldToView && now.viewToPixel == before_.viewToPixel;
}

void FrameBlock::record(gpu::Frame& frame, const Host& host, const shared::SettingsConstants& resolved,
                        glm::uvec2 traced, History& previous) {
    const Settings& settings = stages_->settings();
    shared::FrameConstants& constants = values_.constants;
    values_.settings = resolved;
    const Inputs& images = host.images;
    const auto flag = [&](bool on, uint32_t bit) { constants.flags |= on ? bit : 0; };
    flag(static_cast<bool>(images.environment), shared::kInputEnvironment);
    flag(static_cast<bool>(images.fallbackSpecular), shared::kInputFallback);
    flag(static_cast<bool>(images.material), shared::kInputMaterial);
    flag(host.resolvesMaterial(), shared::kInputResolved);
    flag(host.hasManySamples(), shared::kInputSamples);
    flag(statesF90(host.gbuffer), shared::kInputF90);
    flag(stages_->plan.coat, shared::kInputCoat);
    flag(static_cast<bool>(images.coatNormal), shared::kInputCoatNormal);
    flag(static_cast<bool>(images.motion), shared::kInputMotion);
    flag(host.gbuffer.occlusion.scale != 0 || host.gbuffer.occlusion.bias != 1, shared::kInputOcclusion);
    flag(settings.gbuffer.depthFormat == DepthFormat::Half, shared::kInputHalfDepth);
    flag(previous.valid() && stages_->plan.previousColors, shared::kInputHistory);
    flag(previous.valid(), shared::kInputPrevious);
    const bool now = settings.screen.colorSource == ColorSource::Current; // the previous image lacks them
    flag(host.conventions().highlightsInAlpha && !settings.screen.highlights && now, shared::kInputHighlights);
    flag(gammaBefore_, shared::kHistoryGamma);
    flag(settings.input.colorIsGamma, shared::kInputGamma);
    flag(settings.output.colorIsGamma, shared::kOutputGamma);
    flag(settings.screen.targetFormat == TargetFormat::Rgba8, shared::kTraceTarget8);
    constants.traceSize = traced;
    constants.traceScale = constants.size / constants.traceSize;
    constants.motionScale = {host.conventions().motionScale[0], host.conventions().motionScale[1]};
    constants.motionDepthScale = host.conventions().motionDepthScale;
    constants.viewToPrevView = glm::mat4(glm::dmat4(before_.worldToView) * glm::dmat4(constants.viewToWorld));
    constants.prevViewToPixel = before_.viewToPixel;
    constants.prevUvToView = before_.uvToView;
    constants.prevSize = before_.size;
    constants.prevInvSize = before_.invSize;
    const EnvironmentMap& environment = host.environment;
    constants.environmentStrength = environment.strength;
    constants.environmentMips = static_cast<float>(std::max(environment.mips, 1u));
    constants.worldToEnvironment = glm::rotate(glm::scale(glm::mat4(1), glm::vec3(1, environment.flipY ? -1 : 1, 1)),
                                               -environment.rotation, glm::vec3(0, 1, 0));
    constants.historyExpected = previous.expectedTag();
    gammaBefore_ = settings.output.colorIsGamma;
    frame.update(buffer_, &values_, sizeof(values_));
    if (previous.valid())
        previous.copyTag(frame, buffer_, offsetof(FrameBlockValues, constants.historyTag));
}

} // namespace glint::reflect
