#include "lab/cli/report/gallery_plan.hpp"

#include "base/text.hpp"
#include "lab/cli/plan_place.hpp"

#include <algorithm>
#include <array>
#include <set>

namespace glint::cli {
namespace {

constexpr size_t kMostPictures = 100;
constexpr size_t kLongestName = 60;

/// A file name, and part of a link, on every system.
bool isFileName(std::string_view name) {
    constexpr std::string_view kPlain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    return name.size() <= kLongestName && name.find_first_not_of(kPlain) == name.npos;
}

/// Reads the keys that are there into their texts.
Result<void> readTexts(const PlanPlace& place, std::span<const std::pair<const char*, std::string*>> texts) {
    for (const auto& [key, value] : texts) {
        if (!place.has(key))
            continue;
        GLINT_TRY(text, place.at(key).text());
        *value = std::move(text);
    }
    return {};
}

Result<GalleryEntry> readEntry(const PlanPlace& place) {
    constexpr std::array<std::string_view, 10> kKeys = {"name",      "title",  "scene",  "camera", "env",
                                                        "materials", "probes", "planar", "view",   "config"};
    GLINT_CHECK(place.checkKeys(kKeys));
    for (const char* required : {"name", "scene"})
        if (!place.has(required))
            return place.says(fmt::format("it has no \"{}\"", required));
    GalleryEntry entry;
    std::string view;
    const std::array<std::pair<const char*, std::string*>, 10> texts = {{{"name", &entry.name},
                                                                         {"title", &entry.title},
                                                                         {"scene", &entry.options.scene},
                                                                         {"camera", &entry.options.camera},
                                                                         {"env", &entry.options.environment},
                                                                         {"materials", &entry.options.materials},
                                                                         {"probes", &entry.options.probes},
                                                                         {"planar", &entry.options.planar},
                                                                         {"view", &view},
                                                                         {"config", &entry.config}}};
    GLINT_CHECK(readTexts(place, texts));
    if (!isFileName(entry.name))
        return place.at("name").wrong(fmt::format("letters, digits, - and _, at most {}", kLongestName));
    if (entry.title.empty())
        entry.title = entry.name;
    if (!view.empty())
        entry.options.views = {view};
    if (!entry.config.empty()) {
        GLINT_TRY(request, place.at("config").config());
        entry.options.settings = std::move(request);
    }
    return entry;
}

} // namespace

Result<GalleryPlan> readGalleryPlan(std::string_view text, const std::string& name) {
    const PlanJson json = PlanJson::parse(text, nullptr, false);
    if (json.is_discarded())
        return invalidInput("{}: this is not JSON", printable(name));
    const PlanPlace root(json, printable(name) + ":");
    constexpr std::array<std::string_view, 5> kKeys = {"description", "size", "softwareSize", "settle", "pictures"};
    GLINT_CHECK(root.checkKeys(kKeys));
    if (!root.has("pictures"))
        return root.says("it has no \"pictures\"");
    GalleryPlan plan;
    for (const auto& [key, value] : {std::pair("size", &plan.size), std::pair("softwareSize", &plan.softwareSize)}) {
        if (!root.has(key))
            continue;
        GLINT_TRY(size, root.at(key).size());
        *value = std::move(size);
    }
    double settle = 0;
    if (root.has("settle")) {
        GLINT_TRY(error, root.at("settle").number(0, 255));
        settle = error;
    }
    GLINT_TRY(count, root.at("pictures").list());
    if (count > kMostPictures)
        return root.at("pictures").wrong(fmt::format("a list of 1 to {} entries", kMostPictures));
    std::set<std::string> names;
    for (size_t i = 0; i < count; ++i) {
        const PlanPlace place = root.at("pictures").at(i);
        GLINT_TRY(entry, readEntry(place));
        if (!names.insert(entry.name).second)
            return place.says(fmt::format("the name '{}' is there twice", entry.name));
        entry.options.settle = settle;
        plan.entries.push_back(std::move(entry));
    }
    return plan;
}

} // namespace glint::cli
