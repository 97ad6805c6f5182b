#include "reflect/planar/planar_source.hpp"

namespace glint::reflect {

static_assert(shared::kMaxPlanarRecords == kMaxPlanarMirrors);

Result<std::unique_ptr<PlanarSource>> PlanarSource::create(StageContext& stages) {
    std::unique_ptr<PlanarSource> source(new PlanarSource(stages));
    GLINT_CHECK(makeImage(stages.gpu, source->answer_,
                          {"glint/planarAnswer", VK_FORMAT_R16G16B16A16_SFLOAT, stages.width(), stages.height()}));
    GLINT_TRY(records,
              gpu::Buffer::create(stages.gpu, {"glint/planarRecords", kMaxPlanarMirrors * sizeof(shared::PlanarRecord),
                                               VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT,
                                               gpu::BufferHome::Device}));
    source->records_ = std::move(records);
    return source;
}

Result<void> PlanarSource::setPlanar(PlanarState& planar) {
    GLINT_TRY(reflect,
              gpu::Pipeline::compute(stages_.gpu, {"planar/reflect", sizeof(uint32_t), {}, planar.picturesLayout()}));
    stages_.retired.keep(std::move(reflect_));
    reflect_ = std::move(reflect);
    planar_ = &planar;
    return {};
}

shared::PlanarConstants PlanarSource::constants(const Settings& settings, uint32_t before) {
    return {before, static_cast<uint32_t>(settings.planar.steps), settings.planar.roughnessFadeStart,
            settings.planar.maxRoughness, settings.fade.borderWidth};
}

void PlanarSource::record(gpu::Frame& frame, const PlanarInputs& inputs) {
    std::array<shared::PlanarRecord, kMaxPlanarMirrors> room;
    const std::span<const shared::PlanarRecord> records = planar_->records(inputs.frame.values, room);
    if (!records.empty())
        frame.update(records_, records.data(), records.size_bytes());
    gpu::Pass pass = frame.pass(reflect_);
    pass.read("frame", inputs.frame.constants)
        .read("viewZ", inputs.prepared.viewZ)
        .read("surface", inputs.prepared.surface)
        .read("mirrors", records_)
        .write("planarAnswer", answer_)
        .table(planar_->pictures());
    inputs.earlier.bind(pass);
    pass.push(static_cast<uint32_t>(records.size())).dispatch(stages_.extent.x, stages_.extent.y);
}

} // namespace glint::reflect
