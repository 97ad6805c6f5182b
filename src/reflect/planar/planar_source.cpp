#include "reflect/planar/planar_source.hpp"

namespace glint::reflect {

static_assert(shared::kMaxPlanarRecords == kMaxPlanarMirrors);

Result<std::unique_ptr<PlanarSource>> PlanarSource::create(gpu::Context& context, uint32_t width, uint32_t height) {
    std::unique_ptr<PlanarSource> source(new PlanarSource(context));
    GLINT_TRY(answer, gpu::Image::create(context, {"glint/planarAnswer", VK_FORMAT_R16G16B16A16_SFLOAT, width, height,
                                                   1, 1, gpu::ImageShape::Flat,
                                                   VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_STORAGE_BIT}));
    GLINT_TRY(records,
              gpu::Buffer::create(context, {"glint/planarRecords", kMaxPlanarMirrors * sizeof(shared::PlanarRecord),
                                            VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                            gpu::BufferHome::Device}));
    source->answer_ = std::move(answer);
    source->records_ = std::move(records);
    return source;
}

Result<void> PlanarSource::setPlanar(PlanarState& planar) {
    GLINT_TRY(reflect, gpu::Pipeline::compute(
                           context_, {"planar/reflect", sizeof(shared::PlanarConstants), {}, planar.picturesLayout()}));
    reflect_ = std::move(reflect);
    planar_ = &planar;
    return {};
}

void PlanarSource::record(gpu::Frame& frame, const Settings& settings, const PlanarInputs& inputs) {
    const std::vector<shared::PlanarRecord> records = planar_->records(inputs.constants);
    if (!records.empty())
        frame.update(records_, records.data(), records.size() * sizeof(shared::PlanarRecord));
    shared::PlanarConstants constants = {};
    constants.count = static_cast<uint32_t>(records.size());
    constants.before = inputs.earlier.before;
    constants.steps = static_cast<uint32_t>(settings.planar.steps);
    constants.roughnessFadeStart = settings.planar.roughnessFadeStart;
    constants.maxRoughness = settings.planar.maxRoughness;
    constants.borderWidth = settings.fade.borderWidth;
    gpu::Pass pass = frame.pass(reflect_);
    pass.read("frame", inputs.frameConstants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("mirrors", records_)
        .write("planarAnswer", answer_)
        .table(planar_->pictures());
    inputs.earlier.bind(pass);
    pass.push(constants).dispatch(answer_.width(), answer_.height());
}

} // namespace glint::reflect
