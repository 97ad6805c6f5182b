// The pictures that a page shows from files beside it, some of them still being rendered.
#pragma once

#include "lab/job/render_job.hpp"

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace glint::cli {

/// What is known of a picture once it is rendered.
struct RenderedPicture {
    uint32_t width = 0;
    uint32_t height = 0;
    std::optional<uint32_t> frames; ///< until it settled
    render::RenderStats stats;      ///< without passes where pictures were rendered at the same time
};

struct GalleryPicture {
    std::string name; ///< NAME.png beside the page
    std::string title;
    std::string scene;
    std::string command; ///< `glint render ...`
    std::optional<RenderedPicture> rendered;
};

struct Gallery {
    std::string device;
    std::string driver;
    bool software = false;
    bool complete = false; ///< the page is not written again
    std::vector<GalleryPicture> pictures;
};

/// {"complete", "pictures": [{"name", "title", "scene", "command", ["width", "height", "frames", "rays",
///  "lookupsPerRay", "passes": [{"name", "ms"}], "outcomes": {name: pixels}]}]}
nlohmann::ordered_json galleryJson(const Gallery& gallery);

} // namespace glint::cli
