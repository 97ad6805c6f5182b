#include "c_api/handles.hpp"
#include "c_api/last_error.hpp"
#include "c_api/struct_reading.hpp"

using namespace glint;
using namespace glint::c_api;

void glint_planar_mirror_init(GlintPlanarMirror* mirror, uint32_t size) {
    initStruct<PlanarMirror>(mirror, size);
}

void glint_planar_picture_init(GlintPlanarPicture* picture, uint32_t size) {
    initStruct<PlanarPicture>(picture, size);
}

void glint_planar_mirrors_desc_init(GlintPlanarMirrorsDesc* desc, uint32_t size) {
    initStruct<PlanarMirrorsDesc>(desc, size);
}

GlintResult glint_mirrored_view(const GlintView* view, const GlintPlanarMirror* mirror, GlintView* mirrored) {
    GLINT_C_CHECK(checkResultStruct<View>(mirrored));
    GLINT_C_TRY(from, readStruct<View>(view));
    GLINT_C_TRY(in, readStruct<PlanarMirror>(mirror));
    writeStruct(toC(mirroredView(from, in)), mirrored, mirrored->size);
    return GLINT_SUCCESS;
}

GlintResult glint_clip_plane(const GlintPlanarMirror* mirror, float plane[4]) {
    GLINT_C_REQUIRE(plane);
    GLINT_C_TRY(in, readStruct<PlanarMirror>(mirror));
    std::ranges::copy(clipPlane(in), plane);
    return GLINT_SUCCESS;
}

GlintResult glint_faces_view(const GlintPlanarMirror* mirror, const GlintView* view, VkBool32* faces) {
    GLINT_C_REQUIRE(faces);
    GLINT_C_TRY(in, readStruct<PlanarMirror>(mirror));
    GLINT_C_TRY(from, readStruct<View>(view));
    *faces = facesView(in, from) ? VK_TRUE : VK_FALSE;
    return GLINT_SUCCESS;
}

GlintResult glint_planar_mirrors_create(GlintContext* context, const GlintPlanarMirrorsDesc* desc,
                                        GlintPlanarMirrors** mirrors) {
    GLINT_C_REQUIRE(mirrors);
    *mirrors = nullptr;
    GLINT_C_REQUIRE(context);
    GLINT_C_TRY(whole, wholeStruct<PlanarMirrorsDesc>(desc));
    GLINT_C_TRY(cpp, readStruct<PlanarMirrorsDesc>(desc));
    GLINT_C_TRY(places, readArray<PlanarMirror>(whole.mirrors, whole.mirrorCount));
    cpp.mirrors = places;
    GLINT_C_TRY(made, PlanarMirrors::create(context->context, cpp));
    *mirrors = new GlintPlanarMirrors{std::move(made)};
    return GLINT_SUCCESS;
}

void glint_planar_mirrors_destroy(GlintPlanarMirrors* mirrors) {
    delete mirrors;
}

uint32_t glint_planar_mirrors_count(const GlintPlanarMirrors* mirrors) {
    return mirrors ? mirrors->mirrors.count() : 0;
}

GlintResult glint_planar_mirrors_set(GlintPlanarMirrors* mirrors, const GlintPlanarMirror* places, uint32_t count) {
    GLINT_C_REQUIRE(mirrors);
    GLINT_C_TRY(list, readArray<PlanarMirror>(places, count));
    return outcome(mirrors->mirrors.setMirrors(list));
}

GlintResult glint_planar_mirrors_record(GlintPlanarMirrors* mirrors, VkCommandBuffer commands, uint32_t mirror,
                                        const GlintPlanarPicture* picture) {
    GLINT_C_REQUIRE(mirrors);
    GLINT_C_REQUIRE(commands);
    GLINT_C_TRY(in, readStruct<PlanarPicture>(picture));
    return outcome(mirrors->mirrors.record(commands, mirror, in));
}

GlintResult glint_planar_mirrors_skip(GlintPlanarMirrors* mirrors, uint32_t mirror) {
    GLINT_C_REQUIRE(mirrors);
    if (mirror >= mirrors->mirrors.count())
        return fail(invalidArgument("no mirror {}: there are {}", mirror, mirrors->mirrors.count()));
    mirrors->mirrors.skip(mirror);
    return GLINT_SUCCESS;
}
