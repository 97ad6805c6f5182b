#include "lab/cli/report/gallery.hpp"

namespace glint::cli {
namespace {

using GalleryJson = nlohmann::ordered_json;

void addRendered(const RenderedPicture& picture, GalleryJson& json) {
    json["width"] = picture.width;
    json["height"] = picture.height;
    if (picture.frames)
        json["frames"] = *picture.frames;
    json["rays"] = picture.stats.rays;
    json["lookupsPerRay"] = picture.stats.lookupsPerRay;
    json["passes"] = GalleryJson::array();
    for (const auto& [name, milliseconds] : picture.stats.passes)
        json["passes"].push_back({{"name", name}, {"ms", milliseconds}});
    json["outcomes"] = GalleryJson::object();
    for (const auto& [name, pixels] : picture.stats.outcomes)
        if (pixels > 0)
            json["outcomes"][name] = pixels;
}

} // namespace

GalleryJson galleryJson(const Gallery& gallery) {
    GalleryJson json = {{"complete", gallery.complete}, {"pictures", GalleryJson::array()}};
    for (const GalleryPicture& picture : gallery.pictures) {
        GalleryJson& one = json["pictures"].emplace_back(GalleryJson{
            {"name", picture.name}, {"title", picture.title}, {"scene", picture.scene}, {"command", picture.command}});
        if (picture.rendered)
            addRendered(*picture.rendered, one);
    }
    return json;
}

} // namespace glint::cli
