#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

void glint_reflections_desc_init(GlintReflectionsDesc* desc, uint32_t size) {
    initStruct<ReflectionsDesc>(desc, size);
}

void glint_statistics_init(GlintStatistics* statistics, uint32_t size) {
    initStruct<Statistics>(statistics, size);
}

GlintResult glint_reflections_create(GlintContext* context, const GlintReflectionsDesc* desc,
                                     GlintReflections** reflections) {
    GLINT_C_REQUIRE(reflections);
    *reflections = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(whole, wholeStruct<ReflectionsDesc>(desc));
    GLINT_C_TRY(cpp, readStruct<ReflectionsDesc>(desc));
    if (whole.settings)
        cpp.settings = whole.settings->settings;
    GLINT_C_TRY(made, Reflections::create(context->context, cpp));
    *reflections = new GlintReflections(std::move(made), cpp.inspection);
    return GLINT_SUCCESS;
}

void glint_reflections_destroy(GlintReflections* reflections) {
    delete reflections;
}

GlintResult glint_reflections_resize(GlintReflections* reflections, uint32_t width, uint32_t height) {
    GLINT_C_REQUIRE(reflections);
    return outcome(reflections->reflections.resize(width, height));
}

GlintResult glint_reflections_set_settings(GlintReflections* reflections, const GlintSettings* settings) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(settings);
    return outcome(reflections->reflections.setSettings(settings->settings));
}

GlintResult glint_reflections_set_inputs(GlintReflections* reflections, const GlintGBuffer* gbuffer,
                                         const GlintEnvironmentMap* environment) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_TRY(images, readStruct<GBuffer>(gbuffer));
    if (!environment)
        return outcome(reflections->reflections.setInputs(images));
    GLINT_C_TRY(cubes, readStruct<EnvironmentMap>(environment));
    return outcome(reflections->reflections.setInputs(images, cubes));
}

GlintResult glint_reflections_set_outputs(GlintReflections* reflections, const GlintOutputs* outputs) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_TRY(images, readStruct<Outputs>(outputs));
    return outcome(reflections->reflections.setOutputs(images));
}

GlintResult glint_reflections_set_rays(GlintReflections* reflections, GlintRayScene* scene,
                                       GlintSurfaceTable* surfaces) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(scene);
    GLINT_C_REQUIRE(surfaces);
    return outcome(reflections->reflections.setRays(scene->scene, surfaces->table));
}

GlintResult glint_reflections_set_shaded_rays(GlintReflections* reflections, GlintRayScene* scene, GlintShadeHits shade,
                                              void* user) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(scene);
    GLINT_C_REQUIRE(shade);
    return outcome(
        reflections->reflections.setRays(scene->scene, [shade, user](VkCommandBuffer commands, const RayHits& hits) {
            const GlintImage answer = toC(hits.answer);
            const GlintRayHits c = {sizeof c, 0, hits.arguments, hits.hits, hits.hitsSize, &answer};
            shade(user, commands, &c);
        }));
}

GlintResult glint_reflections_set_planar(GlintReflections* reflections, GlintPlanarMirrors* mirrors) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(mirrors);
    return outcome(reflections->reflections.setPlanar(mirrors->mirrors));
}

GlintResult glint_reflections_set_probes(GlintReflections* reflections, GlintProbes* probes) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(probes);
    return outcome(reflections->reflections.setProbes(probes->probes));
}

void glint_reflections_restart_accumulation(GlintReflections* reflections) {
    if (reflections)
        reflections->reflections.restartAccumulation();
}

GlintResult glint_reflections_record(GlintReflections* reflections, VkCommandBuffer commands, const GlintView* view,
                                     GlintImage* result) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_CHECK(checkResultStruct<HostImage>(result));
    GLINT_C_TRY(camera, readStruct<View>(view));
    writeStruct(toC(reflections->reflections.record(commands, camera)), result, result->size);
    return GLINT_SUCCESS;
}

GlintResult glint_reflections_record_layer(GlintReflections* reflections, VkCommandBuffer commands,
                                           const GlintTransparentLayer* layer, const GlintImage* picture,
                                           GlintImage* result) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_CHECK(checkResultStruct<HostImage>(result));
    GLINT_C_TRY(images, readStruct<TransparentLayer>(layer));
    GLINT_C_TRY(behind, readStruct<HostImage>(picture));
    GLINT_C_TRY(image, reflections->reflections.recordLayer(commands, images, behind));
    writeStruct(toC(image), result, result->size);
    return GLINT_SUCCESS;
}

GlintResult glint_reflections_record_view(GlintReflections* reflections, VkCommandBuffer commands, const char* name,
                                          GlintImage* result) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_REQUIRE(name);
    GLINT_C_CHECK(checkResultStruct<HostImage>(result));
    GLINT_C_TRY(image, reflections->reflections.recordView(commands, name));
    writeStruct(toC(image), result, result->size);
    return GLINT_SUCCESS;
}

uint32_t glint_view_name_count(void) {
    return static_cast<uint32_t>(Reflections::viewNames().size());
}

const char* glint_view_name(uint32_t index) {
    const std::vector<std::string_view> names = Reflections::viewNames();
    return index < names.size() ? names[index].data() : nullptr; // literals, which end in a zero
}

uint32_t glint_reflections_read_pass_images(GlintReflections* reflections) {
    if (!reflections)
        return 0;
    reflections->passImages = reflections->reflections.passImages();
    return static_cast<uint32_t>(reflections->passImages.size());
}

const char* glint_reflections_pass_image(const GlintReflections* reflections, uint32_t index) {
    return reflections && index < reflections->passImages.size() ? reflections->passImages[index].c_str() : nullptr;
}

uint32_t glint_reflections_read_pass_times(GlintReflections* reflections) {
    if (!reflections)
        return 0;
    reflections->passTimes = reflections->reflections.passTimes();
    return static_cast<uint32_t>(reflections->passTimes.size());
}

const char* glint_reflections_pass_name(const GlintReflections* reflections, uint32_t index) {
    return reflections && index < reflections->passTimes.size() ? reflections->passTimes[index].name.c_str() : nullptr;
}

double glint_reflections_pass_milliseconds(const GlintReflections* reflections, uint32_t index) {
    return reflections && index < reflections->passTimes.size() ? reflections->passTimes[index].milliseconds : 0;
}

uint32_t glint_reflections_read_notes(GlintReflections* reflections) {
    if (!reflections)
        return 0;
    reflections->notes = reflections->reflections.notes();
    return static_cast<uint32_t>(reflections->notes.size());
}

const char* glint_reflections_note(const GlintReflections* reflections, uint32_t index) {
    return reflections && index < reflections->notes.size() ? reflections->notes[index].c_str() : nullptr;
}

GlintResult glint_reflections_statistics(GlintReflections* reflections, GlintStatistics* statistics) {
    GLINT_C_REQUIRE(reflections);
    GLINT_C_CHECK(checkResultStruct<Statistics>(statistics));
    const Statistics read = reflections->reflections.statistics();
    reflections->outcomeNames.clear();
    reflections->outcomes.clear();
    for (const Statistics::Outcome& one : read.outcomes)
        reflections->outcomeNames.emplace_back(one.name);
    for (size_t i = 0; i < read.outcomes.size(); ++i)
        reflections->outcomes.push_back({reflections->outcomeNames[i].c_str(), read.outcomes[i].count});
    GlintStatistics c = toC(read);
    c.outcomes = reflections->outcomes.data();
    c.outcomeCount = static_cast<uint32_t>(reflections->outcomes.size());
    c.scenePixels = read.scene.pixels;
    c.sceneRays = read.scene.rays;
    c.sceneFromScreen = read.scene.fromScreen;
    c.sceneReplaced = read.scene.replaced;
    c.sceneReusedLight = read.scene.reusedLight;
    writeStruct(c, statistics, statistics->size);
    return GLINT_SUCCESS;
}
