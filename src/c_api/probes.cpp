#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

namespace {

Result<void> checkProbe(const GlintProbes& probes, uint32_t probe) {
    if (probe >= probes.probes.count())
        return invalidArgument("no probe {}: there are {}", probe, probes.probes.count());
    return {};
}

} // namespace

void glint_probe_init(GlintProbe* probe, uint32_t size) {
    initStruct<Probe>(probe, size);
}

void glint_probes_desc_init(GlintProbesDesc* desc, uint32_t size) {
    initStruct<ProbesDesc>(desc, size);
}

GlintResult glint_probes_create(GlintContext* context, const GlintProbesDesc* desc, GlintProbes** probes) {
    GLINT_C_REQUIRE(probes);
    *probes = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(whole, wholeStruct<ProbesDesc>(desc));
    GLINT_C_TRY(cpp, readStruct<ProbesDesc>(desc));
    GLINT_C_TRY(list, readArray<Probe>(whole.probes, whole.probeCount));
    cpp.probes = list;
    GLINT_C_TRY(made, Probes::create(context->context, cpp));
    *probes = new GlintProbes{std::move(made)};
    return GLINT_SUCCESS;
}

void glint_probes_destroy(GlintProbes* probes) {
    delete probes;
}

uint32_t glint_probes_count(const GlintProbes* probes) {
    return probes ? probes->probes.count() : 0;
}

GlintResult glint_probes_set_volumes(GlintProbes* probes, const GlintProbe* volumes, uint32_t count) {
    GLINT_C_REQUIRE(probes);
    GLINT_C_TRY(list, readArray<Probe>(volumes, count));
    return outcome(probes->probes.setVolumes(list));
}

GlintResult glint_probes_refilter(GlintProbes* probes, uint32_t probe) {
    GLINT_C_REQUIRE(probes);
    GLINT_C_CHECK(checkProbe(*probes, probe));
    probes->probes.refilter(probe);
    return GLINT_SUCCESS;
}

void glint_probes_record(GlintProbes* probes, VkCommandBuffer commands) {
    if (probes && commands)
        probes->probes.record(commands);
}

GlintResult glint_probes_cube(const GlintProbes* probes, uint32_t probe, GlintImage* cube, uint32_t* mips) {
    GLINT_C_REQUIRE(probes);
    GLINT_C_CHECK(checkProbe(*probes, probe));
    GLINT_C_CHECK(checkResultStruct<HostImage>(cube));
    writeStruct(toC(probes->probes.cube(probe)), cube, cube->size);
    if (mips)
        *mips = probes->probes.cubeMips(probe);
    return GLINT_SUCCESS;
}
