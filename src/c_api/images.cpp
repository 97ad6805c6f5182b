// Defaults of the structs of a frame.
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

void glint_image_init(GlintImage* image, uint32_t size) {
    initStruct<HostImage>(image, size);
}

void glint_material_channel_init(GlintMaterialChannel* channel, uint32_t size) {
    initStruct<MaterialChannel>(channel, size);
}

void glint_conventions_init(GlintConventions* conventions, uint32_t size) {
    initStruct<Conventions>(conventions, size);
}

void glint_gbuffer_init(GlintGBuffer* gbuffer, uint32_t size) {
    initStruct<GBuffer>(gbuffer, size);
}

void glint_environment_map_init(GlintEnvironmentMap* environment, uint32_t size) {
    initStruct<EnvironmentMap>(environment, size);
}

void glint_outputs_init(GlintOutputs* outputs, uint32_t size) {
    initStruct<Outputs>(outputs, size);
}

void glint_transparent_layer_init(GlintTransparentLayer* layer, uint32_t size) {
    initStruct<TransparentLayer>(layer, size);
}

void glint_view_init(GlintView* view, uint32_t size) {
    initStruct<View>(view, size);
}
